#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace taut::tailor {

using Vec2 = glm::dvec2;

/// Twice the area of the triangle a b c, positive where it is counter-clockwise.
inline double doubled_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

/// Length of a polyline.
double length_of(std::span<const Vec2> line);

/// The point at this fraction of a polyline's length. 0 is its first point and 1 its last point.
Vec2 point_at_fraction(std::span<const Vec2> line, double fraction);

/// Signed area of a closed polygon, given without repeating its first point. Positive if it is
/// counter-clockwise.
double polygon_area(std::span<const Vec2> polygon);

/// Whether the point is inside a closed polygon, given as for polygon_area.
bool is_inside(std::span<const Vec2> polygon, const Vec2& point);

/// Barycentric coordinates: weights of the corners a, b and c with sum 1.
struct Barycentric {
  double a, b, c;
};
/// The coordinates of `point` in the triangle a b c. One is negative if the point is outside.
Barycentric barycentric(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& point);

}  // namespace taut::tailor
