#include "renderer/passes/screen_bounds.hpp"

#include <algorithm>
#include <glm/common.hpp>

#include "renderer/page/whole_number.hpp"

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

}  // namespace

Tile screen_bounds(const FrameView& frame, std::span<const SurfaceView> surfaces,
                   const glm::mat4& world_to_clip, const PictureSettings& settings) {
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
    return std::any_of(points.begin(), points.end(),
                       [&](const glm::vec3& point) { return point.y < height_m; });
  };
  const auto any = [](const auto& views, const auto& holds) {
    return std::any_of(views.begin(), views.end(), holds);
  };
  return any(surfaces, [&](const SurfaceView& surface) { return below(surface.positions); }) ||
         any(frame.lines, [&](const LineView& lines) { return below(lines.points); }) ||
         any(frame.points, [&](const PointView& points) { return below(points.centres); });
}

}  // namespace taut::renderer
