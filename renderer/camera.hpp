#pragma once

#include "prelude.hpp"

namespace taut::renderer {

/// A perspective camera. Lengths are in metres, angles in radians. +y is up in the world.
struct Camera {
  glm::vec3 eye{0.0F, 0.0F, 3.0F};  ///< position of the camera, world space
  glm::vec3 target{0.0F};           ///< point in the middle of the picture, world space
  glm::vec3 up{0.0F, 1.0F, 0.0F};   ///< not parallel to target - eye
  float vertical_fov_rad = 0.5F;    ///< full angle from the lower to the upper edge of the picture
  float near_m = 0.05F;             ///< distance of the near plane, above 0
  float far_m = 50.0F;              ///< distance of the far plane, above near_m

  /// Returns the matrix from world to eye space.
  glm::mat4 view() const;
  /// Returns the matrix from eye space to OpenGL clip space. `aspect` is width / height.
  glm::mat4 projection(float aspect) const;
};

/// Largest absolute coordinate that is drawn, metres. Beyond it products of coordinates overflow a float.
inline constexpr float farthest_m = 1e9F;

/// An axis-aligned box, in metres.
struct Box {
  glm::vec3 lower{0.0F};
  glm::vec3 upper{0.0F};
};

/// Returns the smallest box around the points. NaN coordinates are ignored. Throws std::invalid_argument when
/// there are no points.
Box bounding_box(std::span<const glm::vec3> points);
/// Returns whether lower <= upper in every axis and all coordinates are within +-farthest_m.
bool is_near(const Box& box);
/// Returns the smallest box around both boxes.
Box united(const Box& a, const Box& b);

/// Direction, field of view and border for a camera that is fitted to a box or to points.
struct Framing {
  float azimuth_rad = 0.0F;       ///< direction of the eye around +y; 0: +z, pi/2: +x
  float elevation_rad = 0.0F;     ///< of the eye above the horizon, -pi/2 to pi/2, both excluded
  float vertical_fov_rad = 0.5F;  ///< as Camera::vertical_fov_rad
  float margin = 0.08F;           ///< free border on the tighter side, share of the picture, 0 to 0.49
};

/// Returns the closest camera that sees the whole box inside the margin, with near_m and far_m set. The box's
/// projection is centred in the picture. `aspect` is width / height. A box without extent counts as a cube of
/// one millimetre. Throws std::invalid_argument unless is_near(box), aspect is finite and positive, and the
/// margin is 0 to 0.49.
Camera fit_camera_to_box(const Box& box, const Framing& framing, float aspect);

/// Returns those of the points that decide how fit_camera_to_points places the camera: the ones farthest to
/// the right, to the left, up and down. Throws std::invalid_argument as it does.
std::array<glm::vec3, 4> outermost_points(std::span<const glm::vec3> points, const Framing& framing, float aspect);

/// As fit_camera_to_box, but fits the points themselves, which is closer than their bounding box. Throws
/// std::invalid_argument also when there are no points.
Camera fit_camera_to_points(std::span<const glm::vec3> points, const Framing& framing, float aspect);

}  // namespace taut::renderer
