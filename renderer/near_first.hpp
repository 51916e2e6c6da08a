#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace taut::renderer {

/// The same triangles (three indices each), roughly in the order of their distance from `eye`, into
/// `ordered`. Triangles about as far away keep their order.
void near_first(std::span<const glm::vec3> positions, std::span<const std::uint32_t> triangles,
                const glm::vec3& eye, std::vector<std::uint32_t>& ordered);

}  // namespace taut::renderer
