#include "app/verify/orientation.hpp"

#include <gmpxx.h>

namespace taut::app {
namespace {

constexpr double unit_roundoff = 0x1p-53;
// Rounding errors of determinants of differences, as fractions of the sum of the absolute values of their terms.
constexpr double error_of_3 = (7.0 + 56.0 * unit_roundoff) * unit_roundoff;
constexpr double error_of_2 = (3.0 + 16.0 * unit_roundoff) * unit_roundoff;
// Smallest sum for which these bounds hold. Products below it may have lost digits to underflow.
constexpr double min_sum = 1e-200;

int sign(double value) { return (value > 0.0) - (value < 0.0); }

bool is_certain(double determinant, double error, double sum_of_sizes) {
  return sum_of_sizes > min_sum && std::abs(determinant) > error * sum_of_sizes;
}

/// Rational coordinates. Every double is a rational number.
using Exact = std::array<mpq_class, 3>;

Exact difference(const sim::Vec3& a, const sim::Vec3& b) {
  return {mpq_class(a.x) - mpq_class(b.x), mpq_class(a.y) - mpq_class(b.y), mpq_class(a.z) - mpq_class(b.z)};
}

mpq_class cross(const Exact& v, const Exact& w, std::size_t axis) {
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  return v[i] * w[j] - v[j] * w[i];
}

int exact_orientation(const sim::Vec3& a, const sim::Vec3& b, const sim::Vec3& c, const sim::Vec3& d) {
  assert(is_exactly_comparable(a) && is_exactly_comparable(b) && is_exactly_comparable(c) && is_exactly_comparable(d));
  const Exact u = difference(a, d), v = difference(b, d), w = difference(c, d);
  const mpq_class determinant = u[0] * cross(v, w, 0) + u[1] * cross(v, w, 1) + u[2] * cross(v, w, 2);
  return sgn(determinant);
}

int exact_orientation(const sim::Vec2& a, const sim::Vec2& b, const sim::Vec2& c) {
  assert(is_exactly_comparable({a, 0.0}) && is_exactly_comparable({b, 0.0}) && is_exactly_comparable({c, 0.0}));
  const mpq_class determinant = cross(difference({a, 0.0}, {c, 0.0}), difference({b, 0.0}, {c, 0.0}), 2);
  return sgn(determinant);
}

}  // namespace

bool is_exactly_comparable(const sim::Vec3& point) {
  constexpr double too_large = 1e100;
  return std::abs(point.x) < too_large && std::abs(point.y) < too_large && std::abs(point.z) < too_large;
}

int orientation(const sim::Vec3& a, const sim::Vec3& b, const sim::Vec3& c, const sim::Vec3& d) {
  const sim::Vec3 u = a - d, v = b - d, w = c - d;
  double determinant = 0.0, sum_of_sizes = 0.0;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    // Cloth that begins flat, along two of the axes, needs no rational numbers.
    if (u[k] == 0.0 && v[k] == 0.0 && w[k] == 0.0) return 0;
    const double plus = v[i] * w[j], minus = v[j] * w[i];
    determinant += u[k] * (plus - minus);
    sum_of_sizes += std::abs(u[k]) * (std::abs(plus) + std::abs(minus));
  }
  return is_certain(determinant, error_of_3, sum_of_sizes) ? sign(determinant) : exact_orientation(a, b, c, d);
}

int orientation(const sim::Vec2& a, const sim::Vec2& b, const sim::Vec2& c) {
  const sim::Vec2 u = a - c, v = b - c;
  if ((u.x == 0.0 || v.y == 0.0) && (u.y == 0.0 || v.x == 0.0)) return 0;
  const double plus = u.x * v.y, minus = u.y * v.x;
  const double determinant = plus - minus;
  return is_certain(determinant, error_of_2, std::abs(plus) + std::abs(minus)) ? sign(determinant)
                                                                               : exact_orientation(a, b, c);
}

}  // namespace taut::app
