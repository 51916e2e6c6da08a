#include "app/drawing/wind_arrows.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/drawing/framing.hpp"

namespace taut::app {
namespace {

// Wind with the longest arrows.
constexpr float fastest_m_per_s = 20.0F;
// Shares of the box's radius: of the shortest and the longest arrow, from arrow to arrow, and of the gap
// between their heads and the box.
constexpr float shortest = 0.25F;
constexpr float longest = 1.0F;
constexpr float apart = 0.4F;
constexpr float gap = 0.15F;
// Length of a head, share of the box's radius, and its half width, share of that.
constexpr float head = 0.1F;
constexpr float head_width = 0.4F;

}  // namespace

std::vector<glm::vec3> wind_arrows(const sim::Wind& wind, const std::vector<sim::Vec3>& positions) {
  std::vector<glm::vec3> lines;
  const auto speed = static_cast<float>(wind.speed_m_per_s);
  if (speed <= 0.0F) {
    return lines;
  }
  const glm::vec3 along = glm::normalize(glm::vec3(wind.direction));
  const glm::vec3 up_ish = std::abs(along.y) < 0.9F ? glm::vec3{0, 1, 0} : glm::vec3{0, 0, 1};
  const glm::vec3 right = glm::normalize(glm::cross(along, up_ish));
  const glm::vec3 up = glm::cross(right, along);
  const renderer::Box around = renderer::bounding_box(to_float(positions));
  const glm::vec3 middle = 0.5F * (around.lower + around.upper);
  const glm::vec3 half = 0.5F * (around.upper - around.lower);
  const float radius = glm::length(half);
  const float reach = glm::dot(glm::abs(along), half);
  const float length = radius * std::clamp(longest * speed / fastest_m_per_s, shortest, longest);
  for (const float row : {-1.0F, 0.0F, 1.0F}) {
    for (const float column : {-0.5F, 0.5F}) {
      const glm::vec3 tip =
          middle - along * (reach + gap * radius) + apart * radius * (row * up + column * right);
      lines.insert(lines.end(), {tip - length * along, tip});
      for (const glm::vec3& side : {right, -right, up, -up}) {
        lines.insert(lines.end(), {tip, tip - head * radius * (along - head_width * side)});
      }
    }
  }
  return lines;
}

}  // namespace taut::app
