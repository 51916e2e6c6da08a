#include "renderer/passes/covered_squares.hpp"

namespace taut::renderer {
namespace {

// Bounds are rounded outwards to blocks of this side, px. Larger reallocates buffers less often while a
// garment moves, smaller draws fewer pixels.
constexpr int block_px = 32;
// Margin around surfaces and marks, px, besides a mark's width: edges are antialiased half a pixel beyond it,
// and a line's corners stick out by less than its width. Less cuts marks off.
constexpr float soft_px = 2.0F;

// Collects points as they appear in the picture, in pixels from its lower left corner.
class Bounds {
 public:
  Bounds(const glm::mat4& world_to_clip, const PictureSettings& settings)
      : to_clip_(world_to_clip), size_px_(settings.width_px, settings.height_px) {}

  void add(std::span<const glm::vec3> points, float margin_px) {
    for (const glm::vec3& point : points) {
      const glm::vec4 clip = to_clip_ * glm::vec4{point, 1.0F};
      if (clip.w < 1e-3F) {  // behind the eye: what hangs on it may be anywhere
        lower_px_ = glm::vec2{0.0F};
        upper_px_ = size_px_;
        return;
      }
      const glm::vec2 place_px = (0.5F + 0.5F * glm::vec2{clip} / clip.w) * size_px_;
      lower_px_ = glm::min(lower_px_, place_px - margin_px);
      upper_px_ = glm::max(upper_px_, place_px + margin_px);
    }
  }

  Tile in_blocks() const {
    const glm::ivec2 size{size_px_};
    const auto within = [&](const glm::vec2& place) {
      return glm::ivec2{whole_within(place.x, 0, size.x), whole_within(place.y, 0, size.y)};
    };
    const glm::ivec2 lower = within(lower_px_) / block_px * block_px;
    const glm::ivec2 last = within(upper_px_) / block_px;
    const glm::ivec2 upper = glm::min((last + 1) * block_px, size);
    if (lower_px_.x > upper_px_.x || lower.x >= upper.x || lower.y >= upper.y) return {};
    return {lower.x, size.y - upper.y, upper.x - lower.x, upper.y - lower.y};
  }

 private:
  glm::mat4 to_clip_;
  glm::vec2 size_px_;
  glm::vec2 lower_px_{1e30F};
  glm::vec2 upper_px_{-1e30F};
};

constexpr std::uint8_t no_surface = 0;
constexpr std::uint8_t uniform_shadow = 1;
constexpr std::uint8_t partial_shadow = 2;

// The square a coordinate lies in, one pixel's rounding aside.
int square_of(float coordinate_px, int count) {
  const float square = std::floor(coordinate_px / static_cast<float>(CoveredSquares::side_px));
  return whole_within(square, -1, count);
}

}  // namespace

Tile screen_bounds(const FrameView& frame, std::span<const SurfaceView> surfaces, const glm::mat4& world_to_clip,
                   const PictureSettings& settings) {
  Bounds bounds(world_to_clip, settings);
  for (const SurfaceView& surface : surfaces) {
    bounds.add(surface.positions, soft_px + (surface.wireframe ? surface.wireframe->width_px : 0.0F));
  }
  for (const LineView& lines : frame.lines) bounds.add(lines.points, soft_px + lines.width_px);
  for (const PointView& points : frame.points) bounds.add(points.centres, soft_px + points.diameter_px);
  return bounds.in_blocks();
}

bool reaches_below(float height_m, const FrameView& frame, std::span<const SurfaceView> surfaces) {
  const auto below = [&](std::span<const glm::vec3> points) {
    return std::ranges::any_of(points, [&](const glm::vec3& point) { return point.y < height_m; });
  };
  const auto any = [](const auto& views, const auto& holds) { return std::ranges::any_of(views, holds); };
  return any(surfaces, [&](const SurfaceView& surface) { return below(surface.positions); }) ||
         any(frame.lines, [&](const LineView& lines) { return below(lines.points); }) ||
         any(frame.points, [&](const PointView& points) { return below(points.centres); });
}

void CoveredSquares::find(const SurfaceBuffers& surfaces, const glm::mat4& world_to_clip, const glm::ivec2& size_px) {
  tile_px_ = size_px;
  squares_ = (size_px + side_px - 1) / side_px;
  kinds_.assign(static_cast<std::size_t>(squares_.x) * static_cast<std::size_t>(squares_.y), no_surface);
  projected_.clear();
  for (const SurfaceBuffers::Vertex& vertex : surfaces.all_vertices()) {
    const glm::vec4 clip = world_to_clip * glm::vec4{glm::vec3{vertex.place}, 1.0F};
    const bool seen = clip.w > 1e-6F;
    const glm::vec2 place = seen ? (0.5F + 0.5F * glm::vec2{clip} / clip.w) * glm::vec2{size_px} : glm::vec2{0};
    projected_.emplace_back(place, seen ? 1.0F : 0.0F);
  }
  for (const glm::uvec4& triangle : surfaces.all_triangles()) {
    const glm::vec3& a = projected_[triangle.x];
    const glm::vec3& b = projected_[triangle.y];
    const glm::vec3& c = projected_[triangle.z];
    const std::uint8_t kind = SurfaceBuffers::is_partial(triangle) ? partial_shadow : uniform_shadow;
    if (a.z + b.z + c.z == 0.0F) continue;
    if (a.z * b.z * c.z == 0.0F) return mark_all();
    const glm::vec2 lower = glm::vec2{glm::min(a, glm::min(b, c))} - 1.0F;
    const glm::vec2 upper = glm::vec2{glm::max(a, glm::max(b, c))} + 1.0F;
    mark({square_of(lower.x, squares_.x), square_of(lower.y, squares_.y), square_of(upper.x, squares_.x),
          square_of(upper.y, squares_.y)},
         kind);
  }
}

void CoveredSquares::mark(const glm::ivec4& box, std::uint8_t kind) {
  for (int y = std::max(box.y, 0); y <= std::min(box.w, squares_.y - 1); ++y) {
    for (int x = std::max(box.x, 0); x <= std::min(box.z, squares_.x - 1); ++x) {
      std::uint8_t& own = kinds_[static_cast<std::size_t>(y * squares_.x + x)];
      own = std::max(own, kind);
    }
  }
}

// A triangle that reaches behind the eye may be anywhere.
void CoveredSquares::mark_all() { std::ranges::fill(kinds_, partial_shadow); }

void CoveredSquares::add_run(int first, int end, int row) {
  const auto clip = [&](int x, int y) {
    return 2.0F * glm::vec2{std::min(x * side_px, tile_px_.x), std::min(y * side_px, tile_px_.y)} /
               glm::vec2{tile_px_} -
           1.0F;
  };
  const glm::vec2 lower_left = clip(first, row);
  const glm::vec2 lower_right = clip(end, row);
  const glm::vec2 upper_left = clip(first, row + 1);
  const glm::vec2 upper_right = clip(end, row + 1);
  triangles_.insert(triangles_.end(), {lower_left, lower_right, upper_right, lower_left, upper_right, upper_left});
}

const std::vector<glm::vec2>& CoveredSquares::corners(bool partial) {
  const std::uint8_t wanted = partial ? partial_shadow : uniform_shadow;
  triangles_.clear();
  for (int row = 0; row < squares_.y; ++row) {
    const std::uint8_t* own = kinds_.data() + static_cast<std::ptrdiff_t>(row) * squares_.x;
    for (int x = 0; x < squares_.x;) {
      const int first = x;
      while (x < squares_.x && own[x] == wanted) ++x;
      if (x > first) {
        add_run(first, x, row);
      } else {
        ++x;
      }
    }
  }
  return triangles_;
}

}  // namespace taut::renderer
