#pragma once

#include <optional>
#include <span>
#include <vector>

#include "renderer/gl/frame_block.hpp"
#include "renderer/gl/gl_objects.hpp"
#include "renderer/light/depth_map.hpp"
#include "renderer/light/key_decision.hpp"
#include "renderer/light/sky_light.hpp"
#include "renderer/light/surface_tables.hpp"

namespace taut::renderer {

/// The light of one frame: what the key light and the studio around it reach. Shaders read it from textures,
/// vertices are told theirs.
class StudioLight {
 public:
  explicit StudioLight(const GladGLContext& context);

  /// Completes `block` but for what depends on the tile. The surfaces have to live until the light is
  /// uploaded.
  void begin(FrameBlock& block, const FrameView& frame, std::span<const SurfaceView> surfaces,
             const PictureSettings& settings);
  /// Looks at everything that casts a shadow. Needs no context, so that another thread may do it, as it may
  /// `gather`.
  void look(const FrameBlock& block);
  /// What arrives at each vertex of a surface.
  void gather(const SurfaceView& surface, SurfaceLight& light);
  /// Hands over what shaders read.
  void upload();

  void bind() const;
  /// Nothing may be left of the textures and samplers for whoever draws next.
  void unbind() const;

 private:
  void draw_shadow_map(const FrameBlock& block);
  void upload_shadow_map();

  const GladGLContext* gl;
  DepthMap shadow_map;
  KeyDecision key_decision;
  SkyLight sky_light;
  Texture shadow_texture;
  Texture floor_texture;
  Sampler compare;  // how much of a neighbourhood is farther than a value
  Sampler plain;    // the depth itself
  // Of the frame.
  std::vector<const SurfaceView*> casters;
  std::optional<Box> casters_box;
  int shadow_side_px = 0;
  int sky_directions = 0;
  bool has_floor = false;
  int allocated_px = 0;
  MapArea uploaded;  // what the shadow texture holds apart from nothing
  std::vector<float> floor_light;
};

}  // namespace taut::renderer
