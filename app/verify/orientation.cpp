#include "app/verify/orientation.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

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

mpz_class minor_of(const mpz_class& a, const mpz_class& b, const mpz_class& c, const mpz_class& d) {
  return a * d - b * c;
}

/// Coordinates as multiples of one power of two, which are whole numbers.
class WholeNumbers {
 public:
  explicit WholeNumbers(std::initializer_list<double> coordinates) {
    for (const double x : coordinates) {
      exponent_ = x != 0.0 ? std::min(exponent_, std::ilogb(x) - digits) : exponent_;
    }
  }

  mpz_class operator()(double x) const {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    return x != 0.0 ? mpz_class(std::ldexp(mantissa, digits)) << (exponent - digits - exponent_)
                    : mpz_class(0);
  }

 private:
  static constexpr int digits = std::numeric_limits<double>::digits;
  int exponent_ = std::numeric_limits<int>::max();
};

int exact_orientation(const sim::Vec3& a, const sim::Vec3& b, const sim::Vec3& c, const sim::Vec3& d) {
  mpz_class u[3], v[3], w[3];
  for (int k = 0; k < 3; ++k) {
    // Each axis has a scale of its own, which leaves the sign.
    const WholeNumbers whole({a[k], b[k], c[k], d[k]});
    const mpz_class origin = whole(d[k]);
    u[k] = whole(a[k]) - origin;
    v[k] = whole(b[k]) - origin;
    w[k] = whole(c[k]) - origin;
  }
  const mpz_class determinant = u[0] * minor_of(v[1], v[2], w[1], w[2]) +
                                u[1] * minor_of(v[2], v[0], w[2], w[0]) +
                                u[2] * minor_of(v[0], v[1], w[0], w[1]);
  return sgn(determinant);
}

int exact_orientation(const sim::Vec2& a, const sim::Vec2& b, const sim::Vec2& c) {
  const WholeNumbers x({a.x, b.x, c.x}), y({a.y, b.y, c.y});
  const mpz_class ux = x(a.x) - x(c.x), uy = y(a.y) - y(c.y);
  const mpz_class vx = x(b.x) - x(c.x), vy = y(b.y) - y(c.y);
  return sgn(minor_of(ux, uy, vx, vy));
}

}  // namespace

int orientation(const sim::Vec3& a, const sim::Vec3& b, const sim::Vec3& c, const sim::Vec3& d) {
  const sim::Vec3 u = a - d, v = b - d, w = c - d;
  double determinant = 0.0, sum_of_sizes = 0.0;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    // Cloth that begins flat, along two of the axes, is not worth long numbers.
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
