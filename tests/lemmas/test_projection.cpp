// Lemma 4 of sim/solvers/bounded/bounded.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <glm/geometric.hpp>

#include "app/verify/stretch.hpp"
#include "check.hpp"
#include "numbers.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/solvers/bounded/projection.hpp"

namespace taut::sim::bounded {
namespace {

/// A ball around each vertex's start, cut by a half-space whose plane passes near the ball's middle.
class BallsAndPlanes : public Confinement {
 public:
  BallsAndPlanes(std::size_t rows, float radius_m, Numbers& some) : radius_m_(radius_m) {
    for (std::size_t row = 0; row < rows; ++row) {
      normals_.emplace_back(glm::normalize(some.vector(1.0)));
    }
  }

  void begin(const Float4Array&, const Float4Array&) override {}
  void project_into_region(Float4Array& displacements, bool /*is_stuck*/) override {
    for (std::size_t row = 0; row < displacements.size(); ++row) {
      glm::vec3 d = vec(displacements[row]);
      d += std::max(0.0F, depth_m(row, d)) * normals_[row];
      d *= std::min(1.0F, radius_m_ / std::max(glm::length(d), 1e-12F));
      displacements[row] = {d.x, d.y, d.z, 0.0F};
    }
    seen = displacements;
  }

  bool is_within(std::size_t row, const glm::vec3& d) const {
    return glm::length(d) <= radius_m_ + 1e-7F && depth_m(row, d) <= 1e-7F;
  }

  Float4Array seen;  ///< displacements of the last call; empty before the first

 private:
  // The plane misses the middle, so that a displacement scaled towards the middle stays on the right side.
  float depth_m(std::size_t row, const glm::vec3& d) const {
    return -0.3F * radius_m_ - glm::dot(normals_[row], d);
  }

  float radius_m_;
  std::vector<glm::vec3> normals_;
};

TEST(Lemma, TheProjectionEndsWithinTheBoundAndWhatConfinesItOrSaysThatItDoesNot) {
  GridSettings grid;
  grid.columns = grid.rows = 6;
  grid.width_m = grid.height_m = 0.1;
  const Garment garment = make_garment(make_grid(grid));
  const std::vector<Vec3>& at_rest_m = garment.mesh.positions;
  std::size_t kept = 0;
  std::size_t not_kept = 0;
  ASSERT_TRUE(holds("projection", [&] {
    Numbers some(*rc::gen::arbitrary<unsigned>());
    const auto bound = *rc::gen::element(BoundKind::springs, BoundKind::surface);
    const double max_stretch = *rc::gen::element(0.01, 0.05);
    const Pins pins = make_pins(garment, some.is_so() ? std::vector<Index>{0, 5} : std::vector<Index>{0});
    Layout layout = make_layout(garment, pins, bound);
    ParallelKernels kernels(kernels_for(VectorUnit::best), 1);
    StartRows start;
    set_start(layout, at_rest_m, start);
    kernels.start(start, layout.springs);
    kernels.start(start, layout.surface);
    const double raw_m = *rc::gen::element(1e-3, 3e-3, 1e-2);
    Float4Array raw(layout.row_count());
    Float4Array corrections(layout.row_count());
    for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
      raw[row] = to_float4(row < layout.pin_count ? Vec3(0.0) : some.vector(raw_m));
      corrections[row] = to_float4(row < layout.pin_count ? Vec3(0.0) : some.vector(0.3 * raw_m));
    }
    BallsAndPlanes confinement(layout.row_count(), static_cast<float>(some.between(0.1, 2.0) * raw_m), some);
    BoundProjection projection(layout, 1.0 / 60.0);
    const double most_sweeps = some.between(1.0, 300.0);
    const ProjectionResult result =
        projection.project(layout, raw, max_stretch, {most_sweeps}, &confinement, kernels, corrections);
    std::vector<Vec3> ends_m = at_rest_m;
    for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
      const Float4& d = projection.corrected()[row];
      ends_m[layout.vertex_indices[row]] += to_vec3(d);
      RC_ASSERT(confinement.seen.empty() || confinement.is_within(row, vec(d)));
      RC_ASSERT(confinement.seen.empty() || std::memcmp(&d, &confinement.seen[row], sizeof d) == 0);
    }
    const app::LargestStretch stretch = app::largest_stretch(garment.mesh, ends_m);
    const double largest =
        bound == BoundKind::springs ? stretch.springs : std::max(stretch.springs, stretch.surface);
    RC_ASSERT(!result.is_kept || largest <= max_stretch);
    RC_ASSERT(result.is_kept || largest > max_stretch - 1e-5);
    ++(result.is_kept ? kept : not_kept);
  }));
  EXPECT_GT(kept, 10U);
  EXPECT_GT(not_kept, 10U);
}

/// Returns the largest stretch of springs and triangles after a sheet's corner is pulled by one and a half edges.
app::LargestStretch pull(BoundKind bound, bool shortens) {
  GridSettings grid;
  grid.columns = grid.rows = 9;
  const Garment garment = make_garment(make_grid(grid));
  Layout layout = make_layout(garment, make_pins(garment, {0}), bound);
  ParallelKernels kernels(kernels_for(VectorUnit::best), 1);
  StartRows start;
  set_start(layout, garment.mesh.positions, start);
  kernels.start(start, layout.springs);
  kernels.start(start, layout.surface);
  Float4Array rows(layout.row_count());
  rows[0] = {-0.1F, 0.1F, 0.1F, 0.0F};
  if (shortens) {
    shorten_roughly(layout, 0.05, kernels, rows);
  }
  EXPECT_EQ(to_vec3(rows[0]), to_vec3({-0.1F, 0.1F, 0.1F, 0.0F}));
  std::vector<Vec3> ends_m = garment.mesh.positions;
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    ends_m[layout.vertex_indices[row]] += to_vec3(rows[row]);
  }
  return app::largest_stretch(garment.mesh, ends_m);
}

TEST(ShortenRoughly, BringsWhatIsPulledNearerToTheBound) {
  EXPECT_GT(pull(BoundKind::springs, false).springs, 1.0);
  EXPECT_LT(pull(BoundKind::springs, true).springs, 0.75);
  EXPECT_GT(pull(BoundKind::surface, false).surface, 1.0);
  EXPECT_LT(pull(BoundKind::surface, true).surface, 0.75);
}

}  // namespace
}  // namespace taut::sim::bounded
