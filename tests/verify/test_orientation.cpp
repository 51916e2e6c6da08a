#include <gtest/gtest.h>

#include <random>

#include "app/verify/triangle_crossing.hpp"

namespace taut::app {
namespace {

using sim::Vec2;
using sim::Vec3;

// Integer for determinants of whole coordinates up to 2^42. Products of three numbers need some 80 bits here.
__extension__ using Wide = __int128;

int sign(Wide value) { return (value > 0) - (value < 0); }

int exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Wide m[3][3];
  for (int k = 0; k < 3; ++k) {
    m[0][k] = static_cast<Wide>(a[k] - d[k]);
    m[1][k] = static_cast<Wide>(b[k] - d[k]);
    m[2][k] = static_cast<Wide>(c[k] - d[k]);
  }
  Wide sum = 0;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    sum += m[0][k] * (m[1][i] * m[2][j] - m[1][j] * m[2][i]);
  }
  return sign(sum);
}

struct NearlyFlat {
  std::mt19937 random{7};  // NOLINT: the same points in every run
  std::uniform_int_distribution<int> coordinate{-(1 << 20), 1 << 20}, factor{-(1 << 20), 1 << 20}, off{-1, 1};

  Vec3 point() { return {coordinate(random), coordinate(random), coordinate(random)}; }
};

TEST(Orientation, IsThatOfWholeNumbersWhereDoublesAreInDoubt) {
  NearlyFlat of;
  int in_plane = 0, beside = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 d = of.point(), u = of.point(), v = of.point();
    const double s = of.factor(of.random), t = of.factor(of.random);
    const Vec3 a = d + u, b = d + v;
    const Vec3 c = d + s * u + t * v + Vec3(of.off(of.random), of.off(of.random), of.off(of.random));
    const int expected = exact(a, b, c, d);
    ASSERT_EQ(orientation(a, b, c, d), expected);
    ASSERT_EQ(orientation(b, a, c, d), -expected);
    // Products of three lose some of their digits, or all.
    for (const double scale : {0x1p-374, 0x1p-500}) {
      ASSERT_EQ(orientation(scale * a, scale * b, scale * c, scale * d), expected);
    }
    ++(expected == 0 ? in_plane : beside);
  }
  EXPECT_GT(in_plane, 100);
  EXPECT_GT(beside, 10000);
}

TEST(Orientation, IsThatOfWholeNumbersInThePlane) {
  NearlyFlat of;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = of.point(), u = of.point();
    const double s = of.factor(of.random);
    const Vec3 q = p + u, r = p + s * u + Vec3(of.off(of.random), of.off(of.random), 0.0);
    const int expected = exact(Vec3(q.x, q.y, 0), Vec3(r.x, r.y, 0), Vec3(p.x, p.y, 1), Vec3(p.x, p.y, 0));
    for (const double scale : {1.0, 0x1p-556, 0x1p-600}) {
      const Vec2 a(scale * q.x, scale * q.y), b(scale * r.x, scale * r.y), c(scale * p.x, scale * p.y);
      ASSERT_EQ(orientation(a, b, c), expected);
    }
  }
}

// Rounded products are equal here. As doubles, 0.1 + 0.2 is not on the line, and 0.5 + 0.5 is.
TEST(Orientation, SeesTheLastBit) {
  EXPECT_EQ(orientation(Vec2(0.0, 0.0), Vec2(12.0, 12.0), Vec2(24.0, 24.0)), 0);
  EXPECT_NE(orientation(Vec2(0.5, 0.5), Vec2(12.0, 12.0), Vec2(24.0, std::nextafter(24.0, 25.0))), 0);
  const Vec3 a(0.0, 0.0, 1.0), b(1.0, 0.0, 1.0), c(0.0, 1.0, 1.0);
  EXPECT_EQ(orientation(a, b, c, Vec3(0.3, 0.3, 1.0)), 0);
  const int above = orientation(a, b, c, Vec3(0.3, 0.3, std::nextafter(1.0, 2.0)));
  EXPECT_NE(above, 0);
  EXPECT_EQ(orientation(a, b, c, Vec3(0.3, 0.3, std::nextafter(1.0, 0.0))), -above);
}

}  // namespace
}  // namespace taut::app
