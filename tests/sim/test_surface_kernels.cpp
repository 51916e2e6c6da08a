// One triangle after a sweep and after the projection: properties that hold for any triangle.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "sim/solvers/bounded/kernels/kernels.hpp"
#include "sim/solvers/bounded/layout.hpp"

namespace taut::sim {
namespace {

using namespace bounded;

constexpr std::array<Vec3, 3> rest = {Vec3(0.02, 0.01, 0.0), Vec3(0.05, 0.015, 0.0), Vec3(0.03, 0.04, 0.0)};

/// One triangle that is displaced from its rest shape.
class OneTriangle {
 public:
  OneTriangle(std::vector<Index> pins, double compression_share = 0.0, double relaxation = 1.0)
      : garment_(make_garment({{rest.begin(), rest.end()}, {{0, 1, 2}}, {}})),
        layout_(make_layout(garment_, make_pins(garment_, std::move(pins)), BoundKind::surface)),
        rows_(layout_.row_count()) {
    StartRows start;
    set_start(layout_, garment_.mesh.positions, start);
    kernels_.start_surface(start, 0, layout_.surface.block_count(), layout_.surface);
    layout_.surface.blocks[0].short_share[0] = static_cast<float>(compression_share);
    layout_.surface.relaxation = static_cast<float>(relaxation);
  }

  void place(const std::array<Vec3, 3>& corners) {
    for (Index v = 0; v < 3; ++v) {
      rows_[layout_.solver_indices[v]] = to_float4(corners[v] - rest[v]);
    }
  }
  void sweep(bool again = false) { kernels_.sweep_surface(layout_.surface, {0, 1, again}, nullptr, rows_.data()); }
  void shorten(double bound) {
    const std::array<std::uint32_t, 1> block = {0};
    kernels_.shorten_surface(layout_.surface, block, static_cast<float>((1.0 + bound) * (1.0 + bound)), 1.0F,
                             rows_.data());
  }

  std::array<Vec3, 3> corners() const {
    std::array<Vec3, 3> now;
    for (Index v = 0; v < 3; ++v) {
      now[v] = rest[v] + to_vec3(rows_[layout_.solver_indices[v]]);
    }
    return now;
  }
  PrincipalStretches stretches() const {
    return principal_stretches(deformation_gradient(garment_.triangles_at_rest[0], corners()));
  }
  double max_by_kernel() const {
    float squared = 0.0F;
    kernels_.find_max_surface_ratios(layout_.surface, 0, 1, rows_.data(), &squared);
    return std::sqrt(static_cast<double>(squared));
  }
  const std::vector<double>& masses_kg() const { return garment_.masses_kg; }

 private:
  Garment garment_;
  Layout layout_;
  Float4Array rows_;
  const Kernels& kernels_ = kernels_for(VectorUnit::best);
};

/// The rest shape stretched by `first` along (0.6, 0.8) and by `second` across, turned out of its plane.
std::array<Vec3, 3> stretch_triangle(double first, double second) {
  const Vec3 u(0.6, 0.8, 0.0), v(-0.8, 0.6, 0.0);
  const Vec3 u_now(0.6, 0.64, 0.48), v_now(-0.8, 0.48, 0.36);
  std::array<Vec3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = first * glm::dot(u, rest[k]) * u_now + second * glm::dot(v, rest[k]) * v_now;
  }
  return corners;
}

TEST(SurfaceKernels, MeasureTheLargestSingularValue) {
  OneTriangle triangle({});
  for (const auto& [first, second] : {std::pair(1.1, 0.7), {1.0, 1.0}, {0.4, 1.3}, {1.2, 1.2}}) {
    triangle.place(stretch_triangle(first, second));
    EXPECT_NEAR(triangle.max_by_kernel(), std::max(first, second), 2e-6);
  }
}

TEST(SurfaceKernels, BothDirectionsAreBroughtBackAtOnce) {
  OneTriangle triangle({});
  triangle.place(stretch_triangle(1.02, 1.01));
  triangle.sweep();
  // The remainder is of second order in the stretch, plus a 256th of the stretch (min_mobility).
  EXPECT_NEAR(triangle.stretches().max_ratio, 1.0, 1e-3);
  EXPECT_NEAR(triangle.stretches().min_ratio, 1.0, 1e-3);
}

TEST(SurfaceKernels, TheDirectionThatIsNotTooLongStaysAsItIs) {
  OneTriangle triangle({});
  triangle.place(stretch_triangle(1.05, 0.8));
  triangle.shorten(0.01);
  EXPECT_NEAR(triangle.stretches().max_ratio, 1.01, 1e-3);
  EXPECT_NEAR(triangle.stretches().min_ratio, 0.8, 1e-5);
  triangle.place(stretch_triangle(1.005, 0.8));
  const auto before = triangle.corners();
  triangle.shorten(0.01);
  EXPECT_EQ(triangle.corners(), before);
}

TEST(SurfaceKernels, TheCentreOfMassDoesNotMove) {
  OneTriangle triangle({});
  triangle.place(stretch_triangle(1.3, 1.1));
  const auto before = triangle.corners();
  triangle.sweep();
  Vec3 moved(0.0);
  for (std::size_t k = 0; k < 3; ++k) {
    moved += triangle.masses_kg()[k] * (triangle.corners()[k] - before[k]);
  }
  EXPECT_GT(glm::distance(triangle.corners()[1], before[1]), 1e-3);
  EXPECT_LT(glm::length(moved), 1e-8 * triangle.masses_kg()[0]);
}

TEST(SurfaceKernels, PinnedCornersStayExactlyWhereTheyAre) {
  for (const std::vector<Index>& pins : {std::vector<Index>{0}, {1, 2}}) {
    OneTriangle triangle(pins);
    triangle.place(stretch_triangle(1.1, 1.05));
    const auto before = triangle.corners();
    triangle.sweep();
    triangle.shorten(0.01);
    for (const Index v : pins) {
      EXPECT_EQ(triangle.corners()[v], before[v]);
    }
    EXPECT_LT(triangle.stretches().max_ratio, principal_stretches({Vec3(1.1, 0, 0), Vec3(0, 1.05, 0)}).max_ratio);
  }
}

// The third corner cannot shorten the edge between the two pins, wherever it moves.
TEST(SurfaceKernels, ACornerBesideAnEdgeBetweenPinsIsNotThrownAway) {
  OneTriangle triangle({0, 1});
  std::array<Vec3, 3> corners = rest;
  corners[1] += 0.5 * (rest[1] - rest[0]);
  triangle.place(corners);
  for (int k = 0; k < 50; ++k) {
    triangle.sweep();
  }
  EXPECT_LT(glm::distance(triangle.corners()[2], rest[2]), 0.1);
}

TEST(SurfaceKernels, WhatIsTooShortPushesByItsShareAndOnceInASweep) {
  OneTriangle triangle({}, 0.25);
  triangle.place(stretch_triangle(1.0, 0.9));
  triangle.sweep(true);
  EXPECT_NEAR(triangle.stretches().min_ratio, 0.9, 1e-6);
  triangle.sweep();
  const double error = (0.81 - 1.0) / (0.81 + 1.0);
  EXPECT_NEAR(triangle.stretches().min_ratio, 0.9 * (1.0 - 0.25 * error), 3e-4);
  EXPECT_NEAR(triangle.stretches().max_ratio, 1.0, 1e-5);
}

TEST(SurfaceKernels, RelaxationIsOfWhatIsTooLongAlone) {
  OneTriangle triangle({}, 0.25, 1.25);
  triangle.place(stretch_triangle(1.02, 0.98));
  triangle.sweep();
  EXPECT_NEAR(triangle.stretches().max_ratio, 0.995, 3e-4);
  EXPECT_NEAR(triangle.stretches().min_ratio, 0.985, 3e-4);
}

}  // namespace
}  // namespace taut::sim
