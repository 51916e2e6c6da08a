#include "app/verify/orientation.hpp"

#include <gmpxx.h>

#include <cmath>

namespace taut::app {
namespace {

constexpr double unit_roundoff = 0x1p-53;
// Rounding errors of the determinants of differences, in parts of the sum of the sizes of their terms.
constexpr double error_of_3 = (7.0 + 56.0 * unit_roundoff) * unit_roundoff;
constexpr double error_of_2 = (3.0 + 16.0 * unit_roundoff) * unit_roundoff;
// Below it products may have lost digits at the small end of the numbers, which those bounds do not count.
constexpr double smallest_sum = 1e-200;

int sign_of(double value) {
  return (value > 0.0) - (value < 0.0);
}

bool is_certain(double determinant, double error, double sum_of_sizes) {
  return sum_of_sizes > smallest_sum && std::abs(determinant) > error * sum_of_sizes;
}

template <class Number>
Number minor_of(const Number& a, const Number& b, const Number& c, const Number& d) {
  return a * d - b * c;
}

int exact_orientation(const sim::Vec3& a, const sim::Vec3& b, const sim::Vec3& c, const sim::Vec3& d) {
  mpq_class u[3], v[3], w[3];
  for (int k = 0; k < 3; ++k) {
    const mpq_class origin(d[k]);
    u[k] = mpq_class(a[k]) - origin;
    v[k] = mpq_class(b[k]) - origin;
    w[k] = mpq_class(c[k]) - origin;
  }
  const mpq_class determinant = u[0] * minor_of(v[1], v[2], w[1], w[2]) +
                                u[1] * minor_of(v[2], v[0], w[2], w[0]) +
                                u[2] * minor_of(v[0], v[1], w[0], w[1]);
  return sgn(determinant);
}

int exact_orientation(const sim::Vec2& a, const sim::Vec2& b, const sim::Vec2& c) {
  const mpq_class x(c.x), y(c.y);
  const mpq_class ux = mpq_class(a.x) - x, uy = mpq_class(a.y) - y;
  const mpq_class vx = mpq_class(b.x) - x, vy = mpq_class(b.y) - y;
  return sgn(minor_of(ux, uy, vx, vy));
}

}  // namespace

int orientation(const sim::Vec3& a, const sim::Vec3& b, const sim::Vec3& c, const sim::Vec3& d) {
  const sim::Vec3 u = a - d, v = b - d, w = c - d;
  double determinant = 0.0, sum_of_sizes = 0.0;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    // Cloth that begins flat, along two of the axes, is not worth rational numbers.
    if (u[k] == 0.0 && v[k] == 0.0 && w[k] == 0.0) {
      return 0;
    }
    const double plus = v[i] * w[j], minus = v[j] * w[i];
    determinant += u[k] * (plus - minus);
    sum_of_sizes += std::abs(u[k]) * (std::abs(plus) + std::abs(minus));
  }
  return is_certain(determinant, error_of_3, sum_of_sizes) ? sign_of(determinant)
                                                           : exact_orientation(a, b, c, d);
}

int orientation(const sim::Vec2& a, const sim::Vec2& b, const sim::Vec2& c) {
  const sim::Vec2 u = a - c, v = b - c;
  if ((u.x == 0.0 || v.y == 0.0) && (u.y == 0.0 || v.x == 0.0)) {
    return 0;
  }
  const double plus = u.x * v.y, minus = u.y * v.x;
  const double determinant = plus - minus;
  return is_certain(determinant, error_of_2, std::abs(plus) + std::abs(minus)) ? sign_of(determinant)
                                                                               : exact_orientation(a, b, c);
}

}  // namespace taut::app
