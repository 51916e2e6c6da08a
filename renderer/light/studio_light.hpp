#pragma once

#include "renderer/light/light_maps.hpp"
#include "renderer/light/surface_buffers.hpp"

namespace taut::renderer {

/// Ambient light with occlusion: bright from above, weaker from below, reduced by obstacles. Occlusion is tested along
/// pairs of opposite directions. A small map per pair holds the nearest and the farthest depth of the casters.
class SkyLight {
 public:
  /// Draws the maps of the casters, which lie in `box` (metres). `directions`: see PictureSettings::sky_directions.
  /// Without a box or with 0 directions nothing is occluded.
  void draw_maps(std::span<const SurfaceView* const> casters, const std::optional<Box>& box, int directions);

  /// Fills `light` with one pair per vertex: the light on its outside (x) and inside (y), relative to an
  /// unoccluded side that faces straight up.
  void gather(const SurfaceView& surface, std::vector<glm::vec2>& light);

  /// Fills `light` with the visible fraction of the sky per spot of the floor, 0 to 1: floor_px rows of floor_px
  /// values. `area`: FrameBlock::ground_light_area; `height_m`: y of the floor.
  void gather_floor(const glm::vec4& area, float height_m, std::vector<float>& light);

  /// Side of the floor's light texture, texels. Its contents are smooth; higher values cost time.
  static constexpr int floor_px = 56;

 private:
  struct DirectionPair {
    glm::vec3 towards{0.0F};  // upper direction of the pair
    glm::mat4 world_to_map{1.0F};
    std::vector<float> min_depths;
    std::vector<float> max_depths;
  };
  void draw(DirectionPair& pair, std::span<const SurfaceView* const> casters);
  void gather_pair(const DirectionPair& pair, const SurfaceView& surface, std::vector<glm::vec2>& light) const;
  void sum_up(const DirectionPair& pair, float height_m);
  float floor_blocked(const glm::vec2& texel, float radius_px) const;

  std::vector<DirectionPair> pairs_;
  float lift_m_ = 0.0F;
  float cone_tangent_ = 0.0F;
  std::vector<glm::vec3> projected_;  // scratch
  std::vector<float> sums_;           // scratch: sums of blockers from the map's corner
};

/// Light of one frame: the key light's shadow map and the ambient light. Surfaces get values per vertex,
/// shaders read the shadow map and the floor's light from textures.
class StudioLight {
 public:
  /// The context must be current and outlive this object.
  explicit StudioLight(const GladGLContext& context);

  /// Starts a frame: sets `block` except tile members. The surfaces must live until upload().
  void begin(FrameBlock& block, const FrameView& frame, std::span<const SurfaceView> surfaces,
             const PictureSettings& settings);
  /// Returns whether anything casts shadows in the frame.
  bool has_casters() const { return !casters_.empty(); }
  /// Points the lights of a block that begin() has set to a pass's samples.
  void turn(FrameBlock& block, const PassSample& sample) const;
  /// Draws the shadow map and the maps of the ambient light. `block` is the result of begin(). Calls no OpenGL, so
  /// another thread may call it.
  void draw_maps(const FrameBlock& block);
  /// Fills `light` with the ambient light of one surface, after draw_maps(); see SkyLight. Calls no OpenGL.
  void gather(const SurfaceView& surface, std::vector<glm::vec2>& light);
  /// Uploads the textures that shaders read.
  void upload();

  /// Binds textures and samplers to their units.
  void bind() const;
  /// Unbinds all textures and samplers, so that other users of the context find none.
  void unbind() const;

 private:
  void upload_shadow_map();

  const GladGLContext* gl_;
  ShadowMap shadow_map_;
  SkyLight sky_light_;
  Texture shadow_texture_;
  Texture floor_texture_;
  Sampler compare_;  // compares: the fraction of a neighbourhood farther than a value
  Sampler plain_;    // samples the depth itself
  // Members of the current frame.
  std::vector<const SurfaceView*> casters_;
  std::optional<Box> casters_box_;
  int shadow_side_px_ = 0;
  int sky_directions_ = 0;
  bool has_floor_ = false;
  int allocated_px_ = 0;
  MapArea uploaded_;  // non-empty area of the shadow texture
  std::vector<float> floor_light_;
};

}  // namespace taut::renderer
