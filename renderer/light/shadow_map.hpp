#pragma once

#include "renderer/gl/gl_objects.hpp"

namespace taut::renderer {

/// A rectangle of a square map, in texels.
struct MapArea {
  glm::ivec2 lower{0};
  glm::ivec2 upper{0};  ///< excluded
};

/// A square shadow map (Williams 1978), rasterised on the CPU. Garment triangles cover only a few texels, so
/// that their setup in a general rasteriser would cost several times as much.
class ShadowMap {
 public:
  /// Sets the side in texels. A new size clears the map.
  void resize(int side_px);
  /// Sets every texel to depth 1, the farthest.
  void clear();
  /// Rasterises triangles and keeps the least depth at every texel centre. `world_to_map` leads from metres
  /// to 0..1 in all three axes; what falls outside is clipped. `triangles`: three indices into positions
  /// each.
  void draw(const glm::mat4& world_to_map, std::span<const glm::vec3> positions,
            std::span<const std::uint32_t> triangles);

  /// Returns the side in texels.
  int side_px() const { return side_; }
  /// Returns the depth of the texel at `place`, texture coordinates 0..1; 1 outside the map.
  float depth_at(const glm::vec2& place) const;
  /// Returns the bounds of all texels drawn since the last clear().
  const MapArea& drawn() const { return drawn_; }
  /// Returns side_px * side_px depths, lowest row first, as OpenGL takes textures.
  std::span<const float> depths() const { return texels_; }

 private:
  void include(const std::vector<glm::vec3>& points);

  int side_ = 0;
  MapArea drawn_;
  std::vector<float> texels_;
  std::vector<glm::vec3> projected_;  // scratch: x and y in pixels, z the depth
};

/// Fills `projected` with one point per position: x and y in texels of a map of side_px, z the depth, 0..1.
void project_to_map(const glm::mat4& world_to_map, int side_px, std::span<const glm::vec3> positions,
                    std::vector<glm::vec3>& projected);

/// Whether the key light reaches a triangle. The values are those of shaders/surface_buffers.glsl.
enum class KeyVisibility : std::uint8_t {
  shadowed = 0,
  lit = 1,
  partial = 2,  ///< partly shadowed: every pixel looks into the shadow map
};

/// Classifies triangles as lit, shadowed or partly shadowed. Only pixels of the last look into the shadow
/// map, which would otherwise take most of a picture's time. Each triangle is compared with the shadow map at
/// the texels it covers. Where light and shadow meet, the penumbra is spread over the mesh from vertex to
/// vertex.
class ShadowClassifier {
 public:
  /// Sets the shadow map and its place in the world (block.world_to_shadow and the shadow members). The map
  /// must live while classify() is called.
  void set_shadow_map(const ShadowMap& map, const FrameBlock& block);
  /// Fills `visibility` with one value per triangle of the surface. Requires set_shadow_map() before.
  void classify(const SurfaceView& surface, std::vector<KeyVisibility>& visibility);

 private:
  // How many texels of a triangle the light sees.
  struct Sight {
    int lit = 0;
    int dark = 0;
    float widest_gap = 0.0F;  // from the triangle to its blocker; share of the map's depth
  };
  using Corners = std::span<const std::uint32_t, 3>;

  Sight sight_of(Corners corners) const;
  void compare(const SurfaceView& surface, std::vector<KeyVisibility>& visibility);
  void find_shadow_edges(std::span<const std::uint32_t> triangles, const std::vector<KeyVisibility>& visibility);
  void spread(const SurfaceView& surface);
  float penumbra_m(float gap) const;

  const ShadowMap* map_ = nullptr;
  glm::mat4 world_to_map_{1.0F};
  float side_m_ = 0.0F;      // 0: nothing casts a shadow
  float softness_m_ = 0.0F;  // widest blur
  float sharpest_m_ = 0.0F;  // narrowest blur
  float tangent_ = 0.0F;     // of the light's angular radius
  // Scratch.
  std::vector<glm::vec3> projected_;   // x and y in samples, z the depth
  std::vector<float> penumbrae_m_;     // of each triangle with shadow on it
  std::vector<std::uint8_t> touched_;  // by light (1) and shadow (2), for each vertex
  std::vector<float> reaches_m_;       // how far a penumbra still goes from each vertex
};

}  // namespace taut::renderer
