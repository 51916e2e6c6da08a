#include "app/drawing/plots/strokes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace taut::app {
namespace {

void draw_solid(renderer::Canvas& canvas, std::span<const glm::vec2> points, const Stroke& stroke) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    canvas.line(points[i - 1].x, points[i - 1].y, points[i].x, points[i].y, stroke.colour,
                stroke.thickness_px);
  }
  // Segments are stroked one by one: a disc closes the wedge at every corner.
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    canvas.circle(points[i].x, points[i].y, 0.5F * stroke.thickness_px, stroke.colour);
  }
}

// Walks along the line and tells dashes from gaps.
class Dasher {
 public:
  Dasher(const Stroke& stroke, const glm::vec2& start)
      : stroke_(stroke), left_px_(stroke.dashes.front() * stroke.thickness_px) {
    pieces_.push_back({start});
  }

  void go_to(const glm::vec2& a, const glm::vec2& b) {
    const float length = glm::distance(a, b);
    float done = 0.0F;
    while (length - done > left_px_) {
      done += left_px_;
      turn_over(a + (b - a) * (done / length));
    }
    left_px_ -= length - done;
    if (is_dash_) {
      pieces_.back().push_back(b);
    }
  }

  std::vector<std::vector<glm::vec2>> pieces() && {
    std::erase_if(pieces_, [](const auto& piece) { return piece.size() < 2; });
    return std::move(pieces_);
  }

 private:
  void turn_over(const glm::vec2& at) {
    if (is_dash_) {
      pieces_.back().push_back(at);
    } else {
      pieces_.push_back({at});
    }
    is_dash_ = !is_dash_;
    index_ = (index_ + 1) % stroke_.dashes.size();
    left_px_ = stroke_.dashes[index_] * stroke_.thickness_px;
  }

  const Stroke& stroke_;
  std::vector<std::vector<glm::vec2>> pieces_;
  float left_px_;
  std::size_t index_ = 0;
  bool is_dash_ = true;
};

void append_column(std::vector<glm::vec2> column, std::vector<glm::vec2>& result) {
  if (column.size() <= 4) {
    result.insert(result.end(), column.begin(), column.end());
    return;
  }
  const auto [low, high] =
      std::minmax_element(column.begin(), column.end(), [](auto& p, auto& q) { return p.y < q.y; });
  result.push_back(column.front());
  result.push_back(*std::min(low, high));
  result.push_back(*std::max(low, high));
  result.push_back(column.back());
}

}  // namespace

std::vector<std::vector<glm::vec2>> cut_into_dashes(std::span<const glm::vec2> points, const Stroke& stroke) {
  if (points.size() < 2) {
    return {};
  }
  if (stroke.dashes.empty()) {
    return {{points.begin(), points.end()}};
  }
  Dasher dasher(stroke, points.front());
  for (std::size_t i = 1; i < points.size(); ++i) {
    dasher.go_to(points[i - 1], points[i]);
  }
  return std::move(dasher).pieces();
}

void draw_polyline(renderer::Canvas& canvas, std::span<const glm::vec2> points, const Stroke& stroke) {
  for (const std::vector<glm::vec2>& piece : cut_into_dashes(points, stroke)) {
    draw_solid(canvas, piece, stroke);
  }
}

std::vector<glm::vec2> bow(const glm::vec2& a, const glm::vec2& b, float sideways) {
  constexpr int pieces = 16;
  const glm::vec2 along = b - a;
  const glm::vec2 across(-along.y, along.x);
  std::vector<glm::vec2> points;
  for (int i = 0; i <= pieces; ++i) {
    const float t = static_cast<float>(i) / pieces;
    points.push_back(a + t * along + 4.0F * t * (1.0F - t) * sideways * across);
  }
  return points;
}

std::vector<glm::vec2> thinned_out(std::span<const glm::vec2> points) {
  std::vector<glm::vec2> result;
  std::vector<glm::vec2> column;
  for (const glm::vec2& point : points) {
    if (!column.empty() && std::floor(point.x) != std::floor(column.front().x)) {
      append_column(std::move(column), result);
      column.clear();
    }
    column.push_back(point);
  }
  append_column(std::move(column), result);
  return result;
}

}  // namespace taut::app
