// A fitted mesh is taken only if it is the model's cloth, by each of the measures of
// app/garments/fitting/comparison.hpp.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/garments/fitting/comparison.hpp"
#include "check.hpp"
#include "numbers.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

using sim::Index;
using sim::Vec3;

/// A garment open at both ends, with a flared hem, on a slant.
struct Skirt {
  explicit Skirt(sim::Numbers& some)
      : radius_m(some.between(0.1, 0.3)),
        height_m(some.between(0.4, 1.2)),
        flare(some.between(0.0, 0.5)),
        slant(some.between(-0.3, 0.3)),
        columns(static_cast<Index>(some.between(24.0, 60.0))),
        rows(static_cast<Index>(some.between(16.0, 40.0))) {}

  /// Returns its mesh, cut `finer` times as fine, without the triangles whose column and row, from 0 to 1, `is_lost`
  /// names.
  template <class IsLost> sim::Mesh mesh(double finer, const IsLost& is_lost) const {
    const auto across = static_cast<Index>(finer * columns), down = static_cast<Index>(finer * rows);
    sim::Mesh mesh;
    for (Index r = 0; r <= down; ++r) {
      for (Index c = 0; c < across; ++c) {
        const double turn = 2.0 * std::numbers::pi * c / across, low = static_cast<double>(r) / down;
        const double reach_m = radius_m * (1.0 + flare * low);
        mesh.positions.emplace_back(reach_m * std::cos(turn) + slant * low * height_m, -low * height_m,
                                    reach_m * std::sin(turn));
      }
    }
    for (Index r = 0; r < down; ++r) {
      for (Index c = 0; c < across; ++c) {
        const Index a = r * across + c, b = r * across + (c + 1) % across;
        if (is_lost((c + 0.5) / across, (r + 0.5) / down)) continue;
        mesh.triangles.push_back({a, b, b + across});
        mesh.triangles.push_back({a, b + across, a + across});
      }
    }
    return mesh;
  }
  sim::Mesh mesh(double finer = 1.0) const {
    return mesh(finer, [](double, double) { return false; });
  }

  double radius_m, height_m, flare, slant;
  Index columns, rows;
};

FittedMesh fitted(sim::Mesh mesh, const sim::Mesh& model) {
  FittedMesh fitted;
  fitted.mesh = std::move(mesh);
  fitted.is_simulated.assign(model.triangles.size(), 1);
  fitted.sheets = 1;
  return fitted;
}

/// Limits of which only this one is as by default.
ComparisonLimits only(double ComparisonLimits::*limit) {
  const ComparisonLimits usual;
  ComparisonLimits limits = {0.0, 1e9, 1e9, usual.border_distance_fraction, 1e9, 1e9, 1e9};
  limits.*limit = usual.*limit;
  return limits;
}

bool is_refused(const sim::Mesh& model, std::size_t crossings, const FittedMesh& fitted,
                const ComparisonLimits& limits) {
  return why_not_the_model(compare_with_model(model, crossings, fitted, limits), limits).has_value();
}

/// Holds in a hundred skirts that what `damage` makes of the same cloth is refused by this limit alone.
template <class Damage> bool refuses(const char* name, double ComparisonLimits::*limit, const Damage& damage) {
  return sim::holds(name, [&] {
    sim::Numbers some(*rc::gen::arbitrary<unsigned>());
    const Skirt skirt(some);
    const sim::Mesh model = skirt.mesh();
    FittedMesh same = fitted(skirt.mesh(some.between(1.0, 2.0)), model);
    RC_ASSERT(!is_refused(model, 0, same, {}));
    damage(some, skirt, same);
    RC_ASSERT(is_refused(model, 0, same, only(limit)));
  });
}

TEST(Lemma, AMeshThatLostAPanelIsRefusedByItsArea) {
  EXPECT_TRUE(
      refuses("area", &ComparisonLimits::min_area_fraction, [](auto& some, const Skirt& skirt, FittedMesh& mesh) {
        const double lost = some.between(0.25, 0.6);
        mesh.mesh = skirt.mesh(1.0, [&](double column, double) { return column < lost; });
      }));
}

TEST(Lemma, AMeshInTwoLayersIsRefusedByItsArea) {
  EXPECT_TRUE(refuses("layers", &ComparisonLimits::max_area_fraction, [](auto& some, const Skirt&, FittedMesh& mesh) {
    const auto count =
        static_cast<std::ptrdiff_t>(some.between(0.2, 1.0) * static_cast<double>(mesh.mesh.triangles.size()));
    const std::vector<sim::Triangle> more(mesh.mesh.triangles.begin(), mesh.mesh.triangles.begin() + count);
    mesh.mesh.triangles.insert(mesh.mesh.triangles.end(), more.begin(), more.end());
  }));
}

TEST(Lemma, AMeshWithAHoleIsRefusedByItsBorders) {
  EXPECT_TRUE(
      refuses("borders", &ComparisonLimits::max_torn_fraction, [](auto& some, const Skirt& skirt, FittedMesh& mesh) {
        const double width = some.between(0.3, 0.5);
        mesh.mesh =
            skirt.mesh(2.0, [&](double column, double row) { return column < width && row > 0.25 && row < 0.75; });
      }));
}

TEST(Lemma, AMeshInMorePartsThanTheModelIsRefused) {
  EXPECT_TRUE(refuses("parts", &ComparisonLimits::border_distance_fraction,
                      [](auto&, const Skirt&, FittedMesh& mesh) { mesh.sheets = 2; }));
}

TEST(Lemma, AMeshThatIsFarFromAHundredthOfTheModelIsRefused) {
  EXPECT_TRUE(refuses("distance", &ComparisonLimits::max_distance_fraction,
                      [](auto& some, const Skirt& skirt, FittedMesh& mesh) {
                        const double lost = some.between(0.15, 0.3);
                        mesh.mesh = skirt.mesh(1.0, [&](double, double row) { return row < lost; });
                      }));
}

TEST(Lemma, AMeshOfWhichAHundredthIsFarFromTheModelIsRefused) {
  EXPECT_TRUE(
      refuses("flap", &ComparisonLimits::max_distance_fraction, [](auto& some, const Skirt& skirt, FittedMesh& mesh) {
        const auto first = static_cast<Index>(mesh.mesh.positions.size());
        const double side_m = some.between(0.4, 0.8) * skirt.height_m;
        mesh.mesh.positions.insert(mesh.mesh.positions.end(),
                                   {{0.0, 0.5, 0.0}, {side_m, 0.5, 0.0}, {0.0, 0.5, side_m}});
        mesh.mesh.triangles.push_back({first, first + 1, first + 2});
      }));
}

TEST(Lemma, AMeshThatCrossesItselfMoreThanTheModelIsRefused) {
  EXPECT_TRUE(refuses(
      "crossings", &ComparisonLimits::max_added_crossing_fraction, [](auto& some, const Skirt&, FittedMesh& mesh) {
        mesh.crossings =
            static_cast<std::size_t>(some.between(0.03, 0.4) * static_cast<double>(mesh.mesh.triangles.size()));
      }));
}

TEST(Lemma, AMeshInShredsIsRefusedEvenIfTheModelIs) {
  EXPECT_TRUE(sim::holds("shreds", [] {
    sim::Numbers some(*rc::gen::arbitrary<unsigned>());
    const sim::Mesh model = Skirt(some).mesh();
    FittedMesh mesh = fitted(model, model);
    mesh.crossings = static_cast<std::size_t>(some.between(0.51, 2.0) * static_cast<double>(model.triangles.size()));
    RC_ASSERT(is_refused(model, mesh.crossings, mesh, only(&ComparisonLimits::max_crossing_fraction)));
    mesh.crossings /= 5;
    RC_ASSERT(!is_refused(model, mesh.crossings, mesh, {}));
  }));
}

TEST(Comparison, AModelThatCrossesItselfMayDoSoAtMoreTrianglesOfAFinerMesh) {
  sim::Numbers some(1);
  const Skirt skirt(some);
  const sim::Mesh model = skirt.mesh();
  FittedMesh finer = fitted(skirt.mesh(2.0), model);
  const std::size_t crossings = model.triangles.size() / 5;
  finer.crossings = 2 * crossings;
  EXPECT_FALSE(is_refused(model, crossings, finer, {}));
  EXPECT_TRUE(is_refused(model, 0, finer, {}));
}

}  // namespace
}  // namespace taut::app
