#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "renderer/camera.hpp"

namespace taut::app {

/// A part of the window that shows the scene, in pixels from the window's upper left corner.
struct ViewArea {
  int width_px = 1;
  int height_px = 1;

  float aspect() const { return static_cast<float>(width_px) / static_cast<float>(height_px); }
  bool contains(const glm::vec2& point_px) const {
    return point_px.x >= 0.0F && point_px.y >= 0.0F && point_px.x < static_cast<float>(width_px) &&
           point_px.y < static_cast<float>(height_px);
  }
};

/// From a point, of unit length.
struct Ray {
  glm::vec3 origin{0.0F};
  glm::vec3 direction{0.0F, 0.0F, -1.0F};
};

/// A camera that turns about what it looks at. y stays up.
class OrbitCamera {
 public:
  OrbitCamera() = default;
  explicit OrbitCamera(const renderer::Camera& camera);

  /// By a way of the pointer; the height of the area is half a turn.
  void orbit(const glm::vec2& way_px, const ViewArea& area);
  /// What is at the target's depth follows the pointer.
  void pan(const glm::vec2& way_px, const ViewArea& area);
  /// Nearer for positive notches of the wheel. What is seen at the pixel stays there.
  void zoom(float notches, const glm::vec2& point_px, const ViewArea& area);
  /// Looks at the whole box from the same side.
  void frame(const renderer::Box& box, const ViewArea& area);

  renderer::Camera camera() const;
  float azimuth_rad() const { return azimuth_rad_; }

  /// Through a pixel.
  Ray ray_through(const glm::vec2& point_px, const ViewArea& area) const;
  /// Where a point is seen; nothing for one behind the eye.
  std::optional<glm::vec2> pixel_of(const glm::vec3& point, const ViewArea& area) const;

  bool operator==(const OrbitCamera&) const = default;

  /// No camera looks farther, nor at a point that is farther from the origin along any axis.
  static constexpr float farthest_m = 1000.0F;

 private:
  void move_target(const glm::vec3& target);

  glm::vec3 target_{0.0F};
  float distance_m_ = 3.0F;
  float azimuth_rad_ = 0.0F;    ///< 0: from +z
  float elevation_rad_ = 0.0F;  ///< above the horizon
  float vertical_fov_rad_ = 0.5F;
};

}  // namespace taut::app
