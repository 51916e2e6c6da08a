#include "renderer/passes/covered_squares.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "renderer/page/whole_number.hpp"

namespace taut::renderer {

namespace {

constexpr std::uint8_t nothing = 0;
constexpr std::uint8_t decided = 1;
constexpr std::uint8_t open_to_shadow = 2;

// The square a coordinate lies in, one pixel's rounding aside.
int square_of(float coordinate_px, int count) {
  const float square = std::floor(coordinate_px / static_cast<float>(CoveredSquares::side_px));
  return whole_within(square, -1, count);
}

}  // namespace

void CoveredSquares::find(const SurfaceTables& tables, const glm::mat4& world_to_clip,
                          const glm::ivec2& size_px) {
  tile_px = size_px;
  squares = (size_px + side_px - 1) / side_px;
  kinds.assign(static_cast<std::size_t>(squares.x) * static_cast<std::size_t>(squares.y), nothing);
  projected.clear();
  for (const SurfaceTables::Vertex& vertex : tables.all_vertices()) {
    const glm::vec4 clip = world_to_clip * glm::vec4{glm::vec3{vertex.place}, 1.0F};
    const bool seen = clip.w > 1e-6F;
    const glm::vec2 place =
        seen ? (0.5F + 0.5F * glm::vec2{clip} / clip.w) * glm::vec2{size_px} : glm::vec2{0};
    projected.emplace_back(place, seen ? 1.0F : 0.0F);
  }
  for (const glm::uvec4& triangle : tables.all_triangles()) {
    const glm::vec3& a = projected[triangle.x];
    const glm::vec3& b = projected[triangle.y];
    const glm::vec3& c = projected[triangle.z];
    const std::uint8_t kind = SurfaceTables::is_open(triangle) ? open_to_shadow : decided;
    if (a.z + b.z + c.z == 0.0F) continue;
    if (a.z * b.z * c.z == 0.0F) return mark_all();
    const glm::vec2 lower = glm::vec2{glm::min(a, glm::min(b, c))} - 1.0F;
    const glm::vec2 upper = glm::vec2{glm::max(a, glm::max(b, c))} + 1.0F;
    mark({square_of(lower.x, squares.x), square_of(lower.y, squares.y), square_of(upper.x, squares.x),
          square_of(upper.y, squares.y)},
         kind);
  }
}

void CoveredSquares::mark(const glm::ivec4& box, std::uint8_t kind) {
  for (int y = std::max(box.y, 0); y <= std::min(box.w, squares.y - 1); ++y) {
    for (int x = std::max(box.x, 0); x <= std::min(box.z, squares.x - 1); ++x) {
      std::uint8_t& own = kinds[static_cast<std::size_t>(y * squares.x + x)];
      own = std::max(own, kind);
    }
  }
}

// A triangle that reaches behind the eye may be anywhere.
void CoveredSquares::mark_all() {
  std::fill(kinds.begin(), kinds.end(), open_to_shadow);
}

void CoveredSquares::add_run(int first, int end, int row) {
  const auto clip = [&](int x, int y) {
    return 2.0F * glm::vec2{std::min(x * side_px, tile_px.x), std::min(y * side_px, tile_px.y)} /
               glm::vec2{tile_px} -
           1.0F;
  };
  const glm::vec2 lower_left = clip(first, row);
  const glm::vec2 lower_right = clip(end, row);
  const glm::vec2 upper_left = clip(first, row + 1);
  const glm::vec2 upper_right = clip(end, row + 1);
  triangles.insert(triangles.end(),
                   {lower_left, lower_right, upper_right, lower_left, upper_right, upper_left});
}

const std::vector<glm::vec2>& CoveredSquares::corners(bool open) {
  const std::uint8_t wanted = open ? open_to_shadow : decided;
  triangles.clear();
  for (int row = 0; row < squares.y; ++row) {
    const std::uint8_t* own = kinds.data() + static_cast<std::ptrdiff_t>(row) * squares.x;
    for (int x = 0; x < squares.x;) {
      const int first = x;
      while (x < squares.x && own[x] == wanted) ++x;
      if (x > first) {
        add_run(first, x, row);
      } else {
        ++x;
      }
    }
  }
  return triangles;
}

}  // namespace taut::renderer
