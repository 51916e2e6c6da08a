#pragma once

#include <optional>
#include <span>

#include "renderer/camera.hpp"
#include "renderer/depth_atlas.hpp"
#include "renderer/frame_view.hpp"
#include "renderer/gl_objects.hpp"
#include "renderer/shader.hpp"

namespace taut::renderer {

/// How much of the studio's all-round light arrives: a small depth map for each of many directions, in one
/// atlas. Vertices look their own light up in it (shaders/sky.glsl), the floor has it gathered in a texture.
class SkyPass {
 public:
  SkyPass(const GladGLContext& context, std::span<const ShaderFile> files);

  /// Draws the atlas and binds the block `Sky`; no directions when there is no box around casters.
  void draw_atlas(std::span<const SurfaceView* const> casters, const std::optional<Box>& box, int directions);
  /// Gathers the light on the floor; the atlas, block `Frame` and block `Sky` have to be bound.
  void draw_ground_light();

  const Texture& atlas() const { return atlas_map; }
  const Texture& ground_light() const { return ground_texture; }

 private:
  struct Block;
  void draw_maps(std::span<const SurfaceView* const> casters, const Block& block, int directions);
  void clear_ground();

  const GladGLContext* gl;
  Program ground;
  DepthAtlas maps;
  Texture atlas_map;
  Texture ground_texture;
  Framebuffer ground_framebuffer;
  Buffer block_buffer;
  VertexArray no_arrays;
  int directions_drawn = 0;
};

}  // namespace taut::renderer
