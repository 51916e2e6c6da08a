#include "app/drawing/drawn_scene.hpp"

#include <algorithm>

#include "app/scene/promise.hpp"
#include "sim/solvers/bounded/promise.hpp"

namespace taut::app {

std::array<double, 2> shown_stretch_range(const DrawnScene& scene) {
  constexpr double most_without_bound = 0.05;
  const std::array from_zero = {
      0.0, std::max(stretch_bound(scene).value_or(most_without_bound), sim::smallest_promised_bound)};
  return scene.picture.stretch_range.value_or(from_zero);
}

}  // namespace taut::app
