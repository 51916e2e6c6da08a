#pragma once

#include <deque>
#include <span>
#include <vector>

#include "renderer/colour_map_textures.hpp"
#include "renderer/frame_view.hpp"
#include "renderer/lazy_program.hpp"
#include "renderer/studio_light.hpp"
#include "renderer/surface_buffers.hpp"

namespace taut::renderer {

/// Surfaces in the studio's light.
class SurfacePass {
 public:
  SurfacePass(const GladGLContext& context, std::span<const ShaderFile> files);

  /// Hands the surfaces to the graphics card.
  void fill(std::span<const SurfaceView> surfaces, StudioLight& light);
  /// Draws those of the last fill(); the block `Frame` and the light's textures have to be bound.
  void draw(std::span<const SurfaceView> surfaces);

 private:
  void draw_cloth(std::size_t surface, const SurfaceView& view);
  void draw_data(std::size_t surface, const SurfaceView& view);

  const GladGLContext* gl;
  LazyProgram decided_cloth;
  LazyProgram open_cloth;
  LazyProgram decided_data;
  LazyProgram open_data;
  ColourMapTextures colour_maps;
  std::deque<SurfaceBuffers> buffers;  // one for each surface, kept from frame to frame
  VertexLight vertex_light;            // scratch
};

}  // namespace taut::renderer
