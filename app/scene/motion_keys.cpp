#include "app/scene/motion_keys.hpp"

#include <fmt/core.h>

#include <glm/geometric.hpp>

namespace taut::app {
namespace {

constexpr double largest_offset_m = 1e6;

template <class Part>
void require_order(const char* part_name, const Part& part, const Source& source, int line) {
  if (!(part.until_s > part.from_s)) {
    fail(source, line,
         fmt::format("{0}.until: found {1:g} s, expected a time after {0}.from, {2:g} s", part_name,
                     part.until_s, part.from_s));
  }
}

}  // namespace

std::optional<std::vector<sim::PathPoint>> path_in(const toml::node& value) {
  std::vector<sim::PathPoint> path;
  for (const toml::node& item : value.is_array() ? *value.as_array() : toml::array{}) {
    const toml::array* row = item.as_array();
    std::array<double, 4> numbers{};
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const auto number = row != nullptr && row->size() == 4 ? finite_number((*row)[k]) : std::nullopt;
      if (!number || std::abs(*number) > largest_offset_m) {
        return std::nullopt;
      }
      numbers[k] = *number;
    }
    if (!path.empty() && !(numbers[0] > path.back().time_s)) {
      return std::nullopt;
    }
    path.push_back({numbers[0], {numbers[1], numbers[2], numbers[3]}});
  }
  return path.empty() ? std::nullopt : std::optional(path);
}

void normalise(sim::Vec3& direction) {
  constexpr double rounded_off = 4e-15;
  constexpr double least_squared = 1e-200;  // below it squares are lost
  if (glm::dot(direction, direction) < least_squared) {
    direction *= 1.0 / least_squared;
  }
  if (std::abs(glm::dot(direction, direction) - 1.0) > rounded_off) {
    direction = glm::normalize(direction);
  }
}

void check_motion(const Source& source, int line, sim::RigidMotion& motion) {
  require_order("shift", motion.shift, source, line);
  require_order("spin", motion.spin, source, line);
  normalise(motion.spin.axis);
}

}  // namespace taut::app
