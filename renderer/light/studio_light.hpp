#pragma once

#include "renderer/light/sky_light.hpp"
#include "renderer/light/surface_buffers.hpp"

namespace taut::renderer {

/// The light of one frame: the key light's shadow map and the ambient light. Surfaces get values per triangle
/// and per vertex, shaders read the shadow map and the floor's light from textures.
class StudioLight {
 public:
  /// The context must be current and outlive this object.
  explicit StudioLight(const GladGLContext& context);

  /// Starts a frame: sets `block` but for what depends on the tile. The surfaces must live until upload().
  void begin(FrameBlock& block, const FrameView& frame, std::span<const SurfaceView> surfaces,
             const PictureSettings& settings);
  /// Draws the shadow map and the maps of the ambient light. `block` is that of begin(). Calls no OpenGL, so
  /// that another thread may call it.
  void draw_maps(const FrameBlock& block);
  /// Fills `light` for one surface, after draw_maps(). Calls no OpenGL.
  void gather(const SurfaceView& surface, SurfaceLight& light);
  /// Uploads the textures that shaders read.
  void upload();

  /// Binds textures and samplers to their units.
  void bind() const;
  /// Unbinds all textures and samplers, so that other users of the context find none.
  void unbind() const;

 private:
  void draw_shadow_map(const FrameBlock& block);
  void upload_shadow_map();

  const GladGLContext* gl_;
  ShadowMap shadow_map_;
  ShadowClassifier shadow_classifier_;
  SkyLight sky_light_;
  Texture shadow_texture_;
  Texture floor_texture_;
  Sampler compare_;  // how much of a neighbourhood is farther than a value
  Sampler plain_;    // the depth itself
  // These belong to the frame at hand.
  std::vector<const SurfaceView*> casters_;
  std::optional<Box> casters_box_;
  int shadow_side_px_ = 0;
  int sky_directions_ = 0;
  bool has_floor_ = false;
  int allocated_px_ = 0;
  MapArea uploaded_;  // what the shadow texture holds apart from nothing
  std::vector<float> floor_light_;
};

}  // namespace taut::renderer
