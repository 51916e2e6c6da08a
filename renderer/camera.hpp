#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace taut::renderer {

/// A perspective camera. Lengths in metres, angles in radians, y is up.
struct Camera {
  glm::vec3 eye{0.0F, 0.0F, 3.0F};
  glm::vec3 target{0.0F};
  glm::vec3 up{0.0F, 1.0F, 0.0F};
  float vertical_fov_rad = 0.5F;  ///< the full angle between the lower and the upper edge of the picture
  float near_m = 0.05F;
  float far_m = 50.0F;

  /// World to eye space.
  glm::mat4 view() const;
  /// Eye space to OpenGL clip space; aspect = width / height.
  glm::mat4 projection(float aspect) const;
};

/// A coordinate beyond is too far for a picture: the products that shading and framing need would overflow.
inline constexpr float farthest_m = 1e9F;

/// An axis-aligned box, in metres.
struct Box {
  glm::vec3 lower{0.0F};
  glm::vec3 upper{0.0F};
};

/// The smallest box around the points; coordinates that are not a number are passed over. Throws
/// std::invalid_argument when there are no points.
Box bounding_box(std::span<const glm::vec3> points);
/// Whether a box holds something and nothing of it is farther than farthest_m.
bool is_near(const Box& box);
Box united(const Box& a, const Box& b);

/// How a box is looked at.
struct Framing {
  float azimuth_rad = 0.0F;       ///< 0: from +z; a quarter turn: from +x
  float elevation_rad = 0.0F;     ///< above the horizon, below pi/2
  float vertical_fov_rad = 0.5F;  ///< small angles flatten, large ones exaggerate depth
  float margin = 0.08F;           ///< free border on the tighter side, as a fraction of the picture
};

/// The camera that sees the whole box as large as the margin allows, its projection centred in the picture.
/// Also sets near_m and far_m. Throws std::invalid_argument for a box that is not near, an aspect that
/// is not finite, or a margin outside 0..0.49. A box without extent is taken as one of a millimetre.
Camera frame_box(const Box& box, const Framing& framing, float aspect);

/// The same for points, of which a box may hold only a few near its corners. Throws std::invalid_argument
/// also when there are none.
Camera frame_points(std::span<const glm::vec3> points, const Framing& framing, float aspect);

}  // namespace taut::renderer
