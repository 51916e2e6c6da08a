#pragma once

#include "renderer/camera.hpp"
#include "sim/mesh/types.hpp"

namespace taut::app {

/// The part of the window that shows the scene. Its upper left corner is that of the window.
struct ViewArea {
  int width_px = 1;
  int height_px = 1;

  /// Width over height.
  float aspect() const { return static_cast<float>(width_px) / static_cast<float>(height_px); }
  bool contains(const glm::vec2& point_px) const {
    return point_px.x >= 0.0F && point_px.y >= 0.0F && point_px.x < static_cast<float>(width_px) &&
           point_px.y < static_cast<float>(height_px);
  }
};

/// A ray in the scene. `direction` has unit length.
struct Ray {
  glm::vec3 origin{0.0F};
  glm::vec3 direction{0.0F, 0.0F, -1.0F};
};

/// A camera that turns around a target point. y stays up. Points are in metres; pixels count from the upper
/// left corner of the area.
class OrbitCamera {
 public:
  OrbitCamera() = default;
  explicit OrbitCamera(const renderer::Camera& camera);

  /// Turns by a movement of the pointer. The height of the area is half a turn.
  void orbit(const glm::vec2& way_px, const ViewArea& area);
  /// Turns to this direction.
  void turn_to(float azimuth_rad, float elevation_rad);
  /// Moves the target so that points at its depth follow the pointer.
  void pan(const glm::vec2& way_px, const ViewArea& area);
  /// Moves nearer for positive notches of the wheel. The place seen at `point_px` stays there.
  void zoom(float notches, const glm::vec2& point_px, const ViewArea& area);
  /// Moves so that the whole box is visible, from the same side.
  void fit(const renderer::Box& box, const ViewArea& area);

  renderer::Camera camera() const;
  float azimuth_rad() const { return azimuth_rad_; }

  /// The ray from the eye through a pixel.
  Ray ray_through(const glm::vec2& point_px, const ViewArea& area) const;
  /// The pixel where a point is seen; empty if it is behind the eye.
  std::optional<glm::vec2> pixel_of(const glm::vec3& point, const ViewArea& area) const;

  bool operator==(const OrbitCamera&) const = default;

  /// Largest distance to the target, and largest coordinate of the target.
  static constexpr float farthest_m = 1000.0F;

 private:
  void move_target(const glm::vec3& target);

  glm::vec3 target_{0.0F};
  float distance_m_ = 3.0F;
  float azimuth_rad_ = 0.0F;    ///< 0: from +z
  float elevation_rad_ = 0.0F;  ///< above the horizon
  float vertical_fov_rad_ = 0.5F;
};

/// A point of the cloth under the pointer.
struct PickedPoint {
  sim::Index vertex = 0;  ///< corner of the triangle that is nearest to the point
  glm::dvec3 point_m{0.0};
  double distance_m = 0.0;  ///< from the eye
};

/// The nearest point where the ray meets a triangle, from either side; empty if it meets none. `positions`
/// are in metres, per vertex. It tests every triangle: ten thousand take 0.1 ms.
std::optional<PickedPoint> pick(const Ray& ray, std::span<const sim::Vec3> positions,
                                std::span<const sim::Triangle> triangles);

/// Where the ray meets the plane through the point `through` that faces the camera. Empty if it does not meet
/// it.
std::optional<glm::dvec3> drag_point(const Ray& ray, const glm::dvec3& through, const renderer::Camera& camera);

/// Tells a user who sees no cloth that it left the picture, or the range of the camera, and what to do. Empty
/// if some triangle may be visible. `positions` are in metres, per vertex.
std::string lost_cloth(std::span<const sim::Vec3> positions, std::span<const sim::Triangle> triangles,
                       const OrbitCamera& camera, const ViewArea& area);

}  // namespace taut::app
