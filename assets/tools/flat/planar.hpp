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

double length_of(std::span<const Vec2> line);

/// The point at a fraction of a polyline's length, 0 its first and 1 its last point.
Vec2 point_at_fraction(std::span<const Vec2> line, double fraction);

/// Of a closed polygon given without repeating its first point; positive where it is counter-clockwise.
double polygon_area(std::span<const Vec2> polygon);

bool is_inside(std::span<const Vec2> polygon, const Vec2& point);

/// The weights of a point with respect to the corners a, b, c; a negative one outside the triangle.
struct Barycentric {
  double a, b, c;
};
Barycentric barycentric(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& point);

}  // namespace taut::tailor
