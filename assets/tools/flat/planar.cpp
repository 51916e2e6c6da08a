#include "tailor/flat/planar.hpp"

#include <glm/geometric.hpp>

namespace taut::tailor {

double length_of(std::span<const Vec2> line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    length += glm::length(line[i] - line[i - 1]);
  }
  return length;
}

Vec2 point_at_fraction(std::span<const Vec2> line, double fraction) {
  double left = fraction * length_of(line);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = glm::length(line[i] - line[i - 1]);
    if (left <= step) {
      return line[i - 1] + (line[i] - line[i - 1]) * (left / step);
    }
    left -= step;
  }
  return line.back();
}

double polygon_area(std::span<const Vec2> polygon) {
  double doubled = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    doubled += doubled_area(polygon[0], polygon[i], polygon[i + 1]);
  }
  return 0.5 * doubled;
}

bool is_inside(std::span<const Vec2> polygon, const Vec2& point) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[j];
    if ((a.y > point.y) != (b.y > point.y) && point.x < a.x + (b.x - a.x) * ((point.y - a.y) / (b.y - a.y))) {
      inside = !inside;
    }
  }
  return inside;
}

Barycentric barycentric(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& point) {
  const double whole = doubled_area(a, b, c);
  const double at_a = doubled_area(point, b, c) / whole;
  const double at_b = doubled_area(a, point, c) / whole;
  return {at_a, at_b, 1.0 - at_a - at_b};
}

}  // namespace taut::tailor
