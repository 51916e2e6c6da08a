#include "renderer/near_first.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/geometric.hpp>

namespace taut::renderer {

namespace {

// Steps of distance that are told apart. Layers of cloth closer than that may come in either order, which
// only costs time.
constexpr std::size_t steps = 256;

}  // namespace

void near_first(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles,
                const glm::vec3& eye, std::vector<std::uint32_t>& ordered) {
  const std::size_t count = triangles.size() / 3;
  ordered.resize(3 * count);
  if (count == 0) return;
  std::vector<float> distances(count);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 sum =
        positions[triangles[3 * i]] + positions[triangles[3 * i + 1]] + positions[triangles[3 * i + 2]];
    distances[i] = glm::distance(sum / 3.0F, eye);
  }
  const auto [nearest, farthest] = std::minmax_element(distances.begin(), distances.end());
  const float lowest = *nearest;
  const float scale = static_cast<float>(steps - 1) / std::max(*farthest - lowest, 1e-6F);
  const auto step_of = [&](std::size_t i) {
    return std::min(static_cast<std::size_t>((distances[i] - lowest) * scale), steps - 1);
  };
  std::array<std::size_t, steps + 1> start{};
  for (std::size_t i = 0; i < count; ++i) ++start[step_of(i) + 1];
  for (std::size_t step = 0; step < steps; ++step) start[step + 1] += start[step];
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t place = start[step_of(i)]++;
    std::copy_n(triangles.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                ordered.begin() + static_cast<std::ptrdiff_t>(3 * place));
  }
}

}  // namespace taut::renderer
