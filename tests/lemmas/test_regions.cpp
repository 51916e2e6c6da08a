// Lemmas 1 to 3 of sim/solvers/bounded/bounded.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "check.hpp"
#include "sim/solvers/bounded/contact/plane_gap.hpp"
#include "soups.hpp"

namespace taut::sim::bounded {
namespace {

SoupSettings some_soup() {
  SoupSettings settings;
  settings.seed = *rc::gen::arbitrary<unsigned>();
  settings.cloth_triangles = *rc::gen::inRange(1, 9);
  settings.body_triangles = *rc::gen::inRange(0, 4);
  settings.thickness_m = *rc::gen::element(1.8e-5F, 1e-4F, 1e-3F, 5e-3F);
  settings.move_m = *rc::gen::element(0.0F, 1e-4F, 1e-3F, 1e-2F);
  settings.radius_m = *rc::gen::element(1e-4F, 1e-3F, 4e-3F);
  settings.from_origin_m = *rc::gen::element(0.0F, 0.5F, 2.0F);
  settings.has_normals = *rc::gen::arbitrary<bool>();
  return settings;
}

/// A soup and the regions of its vertices, if all can be kept apart.
struct Kept {
  explicit Kept(const SoupSettings& settings) : soup(make_soup(settings)) {
    constexpr int max_searches = 8;
    for (int search = 0; search < max_searches && !fits; ++search) {
      pairs = pairs_within_reach(soup);
      fits = regions.make(pairs, soup.rows, kernels);
    }
    is_certain = fits && !regions.blocked();
  }

  /// Projects the cloth's predicted motion into the regions, after `go_further` has changed it.
  template <typename GoFurther> Float4Array project_into_region(float time, const GoFurther& go_further) {
    Float4Array current(soup.rows.cloth_count);
    for (std::size_t row = 0; row < current.size(); ++row) {
      current[row] = multiply(soup.rows.moves[row], time);
    }
    go_further(current);
    Float4Array previous(current.size());
    const Float4Array since(current.size());
    held_back += regions.project_into_region(time, {time, 1.0F}, since, previous, current, kernels).size();
    return current;
  }

  /// Adds a random displacement of up to `further_m` along each axis.
  Float4Array project_into_region(float time, float further_m, std::mt19937& random) {
    std::uniform_real_distribution<float> number(-further_m, further_m);
    return project_into_region(time, [&](Float4Array& current) {
      for (std::size_t row = 0; row < current.size(); ++row) {
        if (soup.rows.inverse_masses_per_kg[row] > 0.0F) {
          add(current[row], {number(random), number(random), number(random)});
        }
      }
    });
  }

  ParallelKernels kernels{kernels_for(VectorUnit::best), 1};
  Soup soup;
  std::vector<ContactPair> pairs;
  Regions regions;
  bool fits = false;
  bool is_certain = false;
  std::size_t held_back = 0;
};

/// Returns the exact distance that planes leave the pair at least, less the rounding error.
double left_m(const ContactPair& pair, const Kept& kept, const std::vector<Vec3>& begin_m) {
  const RowMoves& rows = kept.soup.rows;
  PairExtent extent;
  for (const Index row : pair.near.rows) {
    extent.from_origin = std::max(extent.from_origin, vector_length(rows.positions[row]));
    extent.across = std::max(extent.across,
                             vector_length(scaled_sum(rows.positions[row], rows.positions[pair.near.rows[0]], -1.0F)));
    extent.moved = std::max(extent.moved, vector_length(rows.moves[row]) + rows.radii[row]);
  }
  const double error_m = distance_error_m(extent);
  // A plane along a normal may separate the pair by a tenth less than the distance.
  return std::min<double>(0.9 * distance_m(pair.near, begin_m), min_gap_fraction * pair.thickness_m) - error_m;
}

// Lemma 1. The path from one time to the next is checked exactly, at intermediate positions.
TEST(Lemma, WhatStaysWithinItsRegionsCrossesNothingAtAnyTime) {
  std::size_t tried = 0;
  std::size_t held_back = 0;
  ASSERT_TRUE(holds("regions", [&] {
    Kept kept(some_soup());
    if (!kept.is_certain) {
      return;
    }
    ++tried;
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    const float further_m = *rc::gen::element(1e-4F, 3e-3F, 0.1F);
    const std::vector<Vec3> begin_m = soup_positions(kept.soup, 0.0, {});
    std::vector<Vec3> before_m = begin_m;
    for (const float time : {0.15F, 0.4F, 0.41F, 0.8F, 1.0F}) {
      const std::vector<Vec3> now_m =
          soup_positions(kept.soup, time, kept.project_into_region(time, further_m, random));
      constexpr int parts = 8;
      for (int part = 1; part <= parts; ++part) {
        std::vector<Vec3> between_m = now_m;
        for (std::size_t row = 0; row < now_m.size(); ++row) {
          between_m[row] = glm::mix(before_m[row], now_m[row], static_cast<double>(part) / parts);
        }
        RC_ASSERT(crossings(kept.soup, between_m) == 0U);
        for (const ContactPair& pair : kept.pairs) {
          RC_ASSERT(distance_m(pair.near, between_m) >= left_m(pair, kept, begin_m));
        }
      }
      before_m = now_m;
    }
    held_back += kept.held_back;
  }));
  EXPECT_GT(tried, 50U);
  EXPECT_GT(held_back, 200U);
}

// Lemma 2.
TEST(Lemma, BringingBackEndsWithinTheRegionFromAnywhere) {
  std::size_t tried = 0;
  ASSERT_TRUE(holds("bringing back", [&] {
    Kept kept(some_soup());
    if (!kept.fits) {
      return;
    }
    ++tried;
    const RowMoves& rows = kept.soup.rows;
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    const float time = 0.01F * static_cast<float>(*rc::gen::inRange(0, 101));
    const float further_m = *rc::gen::element(0.0F, 1e-6F, 1e-3F, 1.0F, 1e4F);
    const Float4Array since(rows.cloth_count);
    Float4Array previous(rows.cloth_count);
    const Float4Array once = kept.project_into_region(time, further_m, random);
    Float4Array twice = once;
    kept.regions.project_into_region(time, {time, 1.0F}, since, previous, twice, kept.kernels);
    for (std::size_t row = 0; row < rows.cloth_count; ++row) {
      if (rows.inverse_masses_per_kg[row] > 0.0F) {
        const float off_m = vector_length(scaled_sum(once[row], rows.moves[row], -time));
        RC_ASSERT(off_m <= rows.radii[row] * 1.0001F + tolerance_m);
      }
      // A second projection leaves it in place, up to the tolerance of a half-space.
      RC_ASSERT(vector_length(scaled_sum(twice[row], once[row], -1.0F)) <= 20.0F * tolerance_m);
    }
  }));
  EXPECT_GT(tried, 80U);
}

// Lemma 3 for kinematic vertices: they leave their chords by as much as regions allow, while cloth is pressed against
// them. The other terms of the gap are in plane_gap.hpp.
TEST(Lemma, KinematicVerticesNearToTheirChordsAreCrossedByNothing) {
  std::size_t tried = 0;
  ASSERT_TRUE(holds("chords", [&] {
    SoupSettings settings = some_soup();
    settings.body_triangles = 3;
    Kept kept(settings);
    const double off_m = 0.5 * kept.regions.kinematic_gap_m();
    if (!kept.is_certain || !std::isfinite(off_m)) {
      return;
    }
    RC_ASSERT(off_m > 0.0);
    const RowMoves& rows = kept.soup.rows;
    const auto towards_each_other = [&](const ContactPair& pair, bool is_kinematic, const Vec3& way, const auto& move) {
      for (Index k = 0; k < 4; ++k) {
        const Index row = pair.near.rows[k];
        if ((rows.inverse_masses_per_kg[row] > 0.0F) != is_kinematic) {
          move(row, k < pair.near.first_count ? -way : way);
        }
      }
    };
    const std::vector<Vec3> begin_m = soup_positions(kept.soup, 0.0, {});
    for (const ContactPair& pair : kept.pairs) {
      const Vec3 between = glm::normalize(between_m(pair.near, begin_m));
      for (const float time : {0.0F, 0.3F, 0.9F, 1.0F}) {
        const Float4Array current = kept.project_into_region(time, [&](Float4Array& rows_m) {
          towards_each_other(pair, false, 0.1 * between, [&](Index row, const Vec3& by_m) { add(rows_m[row], by_m); });
        });
        const std::vector<Vec3> chord_m = soup_positions(kept.soup, std::max<double>(time, 1e-30), current);
        std::vector<Vec3> beside_m = chord_m;
        towards_each_other(pair, true, off_m * between, [&](Index row, const Vec3& by_m) { beside_m[row] += by_m; });
        RC_ASSERT(crossings(kept.soup, beside_m) == 0U);
        RC_ASSERT(glm::dot(between_m(pair.near, beside_m), between_m(pair.near, chord_m)) > 0.0);
        tried += distance_m(pair.near, chord_m) < 4.0 * off_m ? 1 : 0;
      }
    }
  }));
  EXPECT_GT(tried, 20U) << "that are pressed together";
}

TEST(Lemma, RegionsThatDoNotFitLetNothingMoveButWhatMust) {
  std::size_t tried = 0;
  ASSERT_TRUE(holds("regions that do not fit", [&] {
    SoupSettings settings = some_soup();
    settings.move_m = 0.01F;
    settings.radius_m = 1e-5F;
    Kept kept(settings);
    // A new soup has its first radii again: only the first search counts.
    kept.soup = make_soup(settings);
    if (kept.regions.make(pairs_within_reach(kept.soup), kept.soup.rows, kept.kernels)) {
      return;
    }
    ++tried;
    std::mt19937 random(1);
    const Float4Array current = kept.project_into_region(0.5F, 1.0F, random);
    for (std::size_t row = 0; row < current.size(); ++row) {
      if (kept.soup.rows.inverse_masses_per_kg[row] > 0.0F) {
        RC_ASSERT(vector_length(current[row]) == 0.0F);
      }
    }
  }));
  EXPECT_GT(tried, 20U);
}

// Two parallel edges of level sheets, one beside and above the other; the upper one is to slide past the lower one.
TEST(Regions, LetLayersSlidePastEdgesWithinEachOther) {
  constexpr float thickness_m = 1e-3F;
  RowMoves rows;
  rows.positions.resize(block_size);
  rows.moves.resize(block_size);
  rows.radii.assign(block_size, 2e-3F);
  rows.inverse_masses_per_kg.assign(block_size, 1e4F);
  rows.cloth_count = block_size;
  const std::array<Float4, 4> ends = {
      {{0.0F, 0.9e-3F, 0.0F}, {0.01F, 0.9e-3F, 0.0F}, {0.0F, 0.0F, 3e-3F}, {0.01F, 0.0F, 3e-3F}}};
  std::copy(ends.begin(), ends.end(), rows.positions.begin());
  rows.moves[0] = rows.moves[1] = {0.0F, 0.0F, 6e-3F};
  const ContactPair pair = {{{0, 1, 2, 3}, 2}, thickness_m};
  ParallelKernels kernels(kernels_for(available_vector_units().front()), 1);
  const auto deviation_m = [&](const Float4Array& normals) {
    rows.normals = normals;
    Regions regions;
    RowMoves made = rows;
    EXPECT_TRUE(regions.make(std::span(&pair, 1), made, kernels));
    return regions.deviation(0);
  };
  EXPECT_GT(deviation_m({}), 1e-3F);
  EXPECT_GT(deviation_m(Float4Array(block_size)), 1e-3F) << "unknown";
  EXPECT_LT(deviation_m(Float4Array(block_size, Float4{0.0F, 1e-4F, 0.0F, 1.0F})), 1e-6F);
  EXPECT_LT(deviation_m(Float4Array(block_size, Float4{0.0F, -1e-4F, 0.0F, 1.0F})), 1e-6F);
  EXPECT_GT(deviation_m(Float4Array(block_size, Float4{1e-4F, 0.0F, 0.0F, 1.0F})), 1e-3F) << "along the edges";
}

}  // namespace
}  // namespace taut::sim::bounded
