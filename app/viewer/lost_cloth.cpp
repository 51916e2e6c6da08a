#include "app/viewer/lost_cloth.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>

namespace taut::app {

std::string lost_cloth(std::span<const sim::Vec3> positions, const OrbitCamera& camera,
                       const ViewArea& area) {
  const renderer::Camera seen = camera.camera();
  const glm::dmat4 to_clip(seen.projection(area.aspect()) * seen.view());
  const bool is_seen = std::any_of(positions.begin(), positions.end(), [&](const sim::Vec3& position) {
    const glm::dvec4 clip = to_clip * glm::dvec4(position, 1.0);
    return clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w && clip.z <= clip.w;
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
