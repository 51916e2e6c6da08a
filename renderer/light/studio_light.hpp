#pragma once

#include "renderer/gl/picture_target.hpp"
#include "renderer/light/light_maps.hpp"
#include "renderer/light/surface_buffers.hpp"

namespace taut::renderer {

/// Light of one frame: depth maps of the key lamp and of directions of the sky, and the light of the sky on vertices
/// and floor that is gathered from them. Ambient light is bright from above and weaker from below.
class StudioLight {
 public:
  /// The context must be current and outlive this object.
  explicit StudioLight(const GladGLContext& context);

  /// Starts a frame: sets `block` except tile members, and uploads the casters of shadows among `surfaces`.
  void begin(FrameBlock& block, const FrameView& frame, std::span<const SurfaceView> surfaces,
             const PictureSettings& settings);
  /// Points the lights of a block that begin() has set to a pass's samples.
  void turn(FrameBlock& block, const PassSample& sample) const;
  /// Draws the depth maps. `block` must be bound.
  void draw_maps(const FrameBlock& block);
  /// Gathers the light of the sky on this number of vertices of the bound surface buffers, and on the floor. The maps
  /// must be bound.
  void gather(std::size_t vertex_count);

  /// Binds textures and samplers to their units.
  void bind() const;
  /// Unbinds all textures and samplers, so that other users of the context find none.
  void unbind() const;

 private:
  void upload_casters(std::span<const SurfaceView> casters);
  void set_sky(FrameBlock& block, std::span<const glm::vec3> directions) const;

  const GladGLContext* gl_;
  LightMaps key_map_;
  LightMaps sky_maps_;
  LazyProgram depth_;
  LazyProgram vertex_program_;
  LazyProgram floor_program_;
  GrowingTarget vertex_light_;
  GrowingTarget floor_light_;
  VertexArray no_arrays_;
  VertexArray caster_arrays_;
  Buffer caster_positions_;
  Buffer caster_corners_;
  // Members of the current frame.
  GLsizei corner_count_ = 0;
  std::optional<Box> casters_box_;
  int key_side_px_ = 0;
  int sky_side_px_ = 0;
  bool has_floor_ = false;
};

}  // namespace taut::renderer
