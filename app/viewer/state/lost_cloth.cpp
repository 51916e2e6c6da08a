#include "app/viewer/state/lost_cloth.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>

namespace taut::app {
namespace {

// One bit for each side of what the camera sees that a point is beyond; a lost point is beyond all of them.
unsigned sides_beyond(const sim::Vec3& position, const glm::dmat4& to_clip) {
  const glm::dvec4 clip = to_clip * glm::dvec4(position, 1.0);
  unsigned sides = 0;
  for (const int axis : {0, 1, 2}) {
    sides = sides << 2U | (clip[axis] >= -clip.w ? 0U : 1U) | (clip[axis] <= clip.w ? 0U : 2U);
  }
  return sides;
}

}  // namespace

std::string lost_cloth(std::span<const sim::Vec3> positions, std::span<const sim::Triangle> triangles,
                       const OrbitCamera& camera, const ViewArea& area) {
  const renderer::Camera seen = camera.camera();
  const glm::dmat4 to_clip(seen.projection(area.aspect()) * seen.view());
  // By triangles: seen from near by, one may fill the picture with its corners outside.
  const bool is_seen = std::any_of(triangles.begin(), triangles.end(), [&](const sim::Triangle& triangle) {
    const auto beyond = [&](int corner) { return sides_beyond(positions[triangle[corner]], to_clip); };
    return (beyond(0) & beyond(1) & beyond(2)) == 0U;
  });
  if (is_seen) {
    return "";
  }
  const bool is_in_reach = std::any_of(positions.begin(), positions.end(), [](const sim::Vec3& position) {
    const auto is_near = [](double coordinate) { return std::abs(coordinate) < OrbitCamera::farthest_m; };
    return is_near(position.x) && is_near(position.y) && is_near(position.z);
  });
  return is_in_reach ? "the cloth has left the picture: F looks at it, R starts again"
                     : "the cloth has left the world: R starts again";
}

}  // namespace taut::app
