// What app/garments/README.md says of sewing, for random patterns.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "app/bodies/body_loading.hpp"
#include "app/garments/dressing/wearing.hpp"
#include "app/garments/sewing/placing.hpp"
#include "app/garments/sewing/sewing.hpp"
#include "check.hpp"
#include "numbers.hpp"
#include "sim/contact/crossing_pairs.hpp"

namespace taut::app {
namespace {

using sim::Index;
using sim::Vec2;
using sim::Vec3;

/// A panel with four edges, some of them bent: wider below than above, about a point of the floor.
PatternPanel panel(sim::Numbers& some, const std::string& name, double top_m, double bottom_m, double height_m,
                   double turned_rad) {
  const std::vector<Vec2> corners = {
      {-0.5 * bottom_m, -height_m}, {0.5 * bottom_m, -height_m}, {0.5 * top_m, 0.0}, {-0.5 * top_m, 0.0}};
  PatternPanel made{name, {}};
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec2 &from = corners[k], &to = corners[(k + 1) % 4];
    const Vec2 across = Vec2(to.y - from.y, from.x - to.x), bent = 0.5 * (from + to) + some.between(0.0, 0.05) * across;
    made.edges_m.push_back(some.is_so() && k == 0 ? std::vector<Vec2>{from, bent, to} : std::vector<Vec2>{from, to});
  }
  made.rotation[0] = {std::cos(turned_rad), 0.0, -std::sin(turned_rad)};
  made.rotation[2] = {std::sin(turned_rad), 0.0, std::cos(turned_rad)};
  return made;
}

/// A tube of two to five panels around a vertical axis, sewn along their sides, each with an ease of its own.
SewingPattern tube(sim::Numbers& some, double top_m, double height_m) {
  const auto count = static_cast<std::size_t>(some.between(2.0, 5.999));
  SewingPattern pattern;
  const double near_m = some.between(0.1, 0.3), flare = some.between(1.0, 1.5);
  for (std::size_t p = 0; p < count; ++p) {
    const double turned_rad = 2.0 * M_PI * static_cast<double>(p) / static_cast<double>(count);
    const double width_m = top_m / static_cast<double>(count), own_height_m = height_m * some.between(1.0, 1.1);
    pattern.panels.push_back(
        panel(some, "panel " + std::to_string(p), width_m, flare * width_m, own_height_m, turned_rad));
    pattern.panels.back().translation_m = near_m * pattern.panels.back().rotation[2] + Vec3(0.0, 1.0, 0.0);
    pattern.stitches.push_back({{p, 1}, {(p + 1) % count, 3}});
  }
  return pattern;
}

TEST(Lemma, SeamVerticesPairUp) {
  EXPECT_TRUE(sim::holds("pairs", [] {
    sim::Numbers some(*rc::gen::arbitrary<unsigned>());
    const SewingPattern pattern = tube(some, some.between(0.5, 1.2), some.between(0.3, 0.9));
    const CutPieces pieces = cut_pieces(pattern, static_cast<int>(some.between(100.0, 1000.0)));
    RC_ASSERT(pieces.seams.size() == pattern.stitches.size());
    for (std::size_t s = 0; s < pieces.seams.size(); ++s) {
      const Seam& seam = pieces.seams[s];
      double first_m = 0.0, second_m = 0.0;
      for (std::size_t k = 0; k < seam.size(); ++k) {
        RC_ASSERT(pieces.panel_of[seam[k].first] == pattern.stitches[s].first.panel);
        RC_ASSERT(pieces.panel_of[seam[k].second] == pattern.stitches[s].second.panel);
        if (k == 0) continue;
        first_m += glm::distance(pieces.flat_m[seam[k].first], pieces.flat_m[seam[k - 1].first]);
        second_m += glm::distance(pieces.flat_m[seam[k].second], pieces.flat_m[seam[k - 1].second]);
      }
      RC_ASSERT(std::abs(first_m - polyline_length(pattern.line_of(pattern.stitches[s].first))) < 1e-5);
      RC_ASSERT(std::abs(second_m - polyline_length(pattern.line_of(pattern.stitches[s].second))) < 1e-5);
      // The sides run alike: upper ends meet upper ends.
      const auto height_m = [&](Index v) { return pieces.placed_m[v].y; };
      RC_ASSERT((height_m(seam.front().first) > height_m(seam.back().first)) ==
                (height_m(seam.front().second) > height_m(seam.back().second)));
    }
  }));
}

struct OnBody : testing::Test {
  OnBody() {
    BodySource source;
    source.file = std::filesystem::path(TAUT_ASSETS_FOLDER) / "bodies/mannequin_female_34.glb";
    source.dress = 90;
    scene.bodies.push_back({.body = {.name = "mannequin", .shape = sim::BodyMesh{}}, .source = source});
    scene.simulation.solver.bounded.max_stretch = 0.01;
    bodies = load_bodies(scene);
  }

  Scene scene;
  LoadedBodies bodies;
};

TEST_F(OnBody, PlacedPiecesCrossNothing) {
  const Wearer wearer = *dressed_body(bodies).wearer;
  const std::vector<Vec3> thin_m = placed_m(wearer.places, compute_thin_shape(*wearer.rig, wearer.pose));
  const std::vector<sim::Triangle>& triangles = std::get<sim::BodyMesh>(bodies.all[0].shape).data->triangles;
  EXPECT_TRUE(sim::holds("placed", [&] {
    sim::Numbers some(*rc::gen::arbitrary<unsigned>());
    const SewingPattern pattern = tube(some, some.between(0.6, 1.2), some.between(0.3, 0.6));
    CutPieces pieces = cut_pieces(pattern, 200);
    bring_to_body(pattern, bodies, pieces);
    part_and_draw_in({thin_m, triangles}, *wearer.measures.neck_m, pieces);
    const sim::Surface cloth = {pieces.placed_m, pieces.triangles};
    RC_ASSERT(sim::find_crossing_pairs(cloth).empty());
    RC_ASSERT(sim::find_crossing_pairs(cloth, {thin_m, triangles}).empty());
  }));
}

TEST(Lemma, JoinsKeepBoundAndDistance) {
  int closed = 0;
  EXPECT_TRUE(sim::holds("joins", [&] {
    sim::Numbers some(*rc::gen::arbitrary<unsigned>());
    const SewingPattern pattern = tube(some, some.between(0.3, 0.6), some.between(0.2, 0.4));
    Scene scene;
    scene.simulation.solver.bounded.max_stretch = 0.01;
    CutPieces pieces = cut_pieces(pattern, 120);
    LoadedBodies nobody;
    bring_to_body(pattern, nobody, pieces);
    place_pieces(pieces, scene, nobody);
    const SewnPieces sewn =
        close_seams(pieces, scene, nobody, 0.0, [&](double, const sim::Garment& cloth, const auto& at_m) {
          RC_ASSERT(sim::find_crossing_pairs({at_m, cloth.mesh.triangles}).empty());
          RC_ASSERT(sim::measure_surface_stretch(cloth, at_m).max <= 0.01 + 1e-6);
        });
    closed += sewn.gap_m == 0.0 ? 1 : 0;
    // Joined cloth rests as it is cut: the shorter side of a seam counts.
    const sim::Garment& cloth = sewn.garment;
    for (std::size_t t = 0; t < pieces.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [a, b] = std::pair(pieces.triangles[t][k], pieces.triangles[t][(k + 1) % 3]);
        const double flat_m = glm::distance(pieces.flat_m[a], pieces.flat_m[b]);
        RC_ASSERT(glm::distance(cloth.mesh.cut_m[t][k], cloth.mesh.cut_m[t][(k + 1) % 3]) == flat_m);
        const sim::Edge edge = {std::min(sewn.vertex_of[a], sewn.vertex_of[b]),
                                std::max(sewn.vertex_of[a], sewn.vertex_of[b])};
        const auto ends = std::span(cloth.springs.ends).first(cloth.springs.structural_count);
        const auto spring = std::ranges::lower_bound(ends, edge);
        RC_ASSERT(spring != ends.end() && *spring == edge);
        RC_ASSERT(cloth.springs.rest_lengths_m[static_cast<std::size_t>(spring - ends.begin())] <= flat_m);
      }
    }
  }));
  EXPECT_GE(closed, 95) << "of a hundred tubes";
}

TEST(Lemma, AJoinThatWouldStretchClothIsNotMade) {
  EXPECT_TRUE(sim::holds("tight", [&] {
    sim::Numbers some(*rc::gen::arbitrary<unsigned>());
    const double girth_m = some.between(0.4, 0.8), radius_m = girth_m / (2.0 * M_PI);
    SewingPattern pattern;
    const double width_m = 0.25 * girth_m * some.between(0.96, 0.985);
    for (std::size_t p = 0; p < 4; ++p) {
      pattern.panels.push_back(
          panel(some, "panel " + std::to_string(p), width_m, width_m, 0.2, 0.5 * M_PI * static_cast<double>(p)));
      pattern.panels.back().translation_m = (radius_m + 0.03) * pattern.panels.back().rotation[2] + Vec3(0.0, 1.0, 0.0);
      pattern.stitches.push_back({{p, 1}, {(p + 1) % 4, 3}});
    }
    Scene scene;
    scene.simulation.solver.bounded.max_stretch = 0.01;
    LoadedBodies around;
    around.all.push_back({"post", sim::Capsule{{0.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, radius_m, radius_m}});
    const SewnPieces sewn = close_seams(cut_pieces(pattern, 120), scene, around, 0.0,
                                        [&](double, const sim::Garment& cloth, const auto& at_m) {
                                          RC_ASSERT(sim::measure_surface_stretch(cloth, at_m).max <= 0.01 + 1e-6);
                                        });
    RC_ASSERT(sewn.gap_m > 0.0);
  }));
}

TEST_F(OnBody, WhatIsWornGoesAroundTheBody) {
  sim::Numbers fixed(1);
  SewingPattern pattern = {{panel(fixed, "front", 0.4, 0.6, 0.4, 0.0), panel(fixed, "back", 0.4, 0.6, 0.4, M_PI)},
                           {{{0, 1}, {1, 3}}, {{1, 1}, {0, 3}}}};
  for (PatternPanel& each : pattern.panels) each.translation_m = 0.2 * each.rotation[2] + Vec3(0.0, 1.05, 0.0);
  const SewnGarment worn = sew({"skirt.json", pattern}, scene, bodies, {300, 60}, [](const std::string&) {});
  const std::vector<Vec3>& worn_m = worn.sewn.garment.mesh.positions;
  const Vec3 waist_m = *dressed_body(bodies).wearer->measures.waist_m;
  EXPECT_TRUE(sim::holds("worn", [&] {
    sim::Numbers some(*rc::gen::arbitrary<unsigned>());
    SewnGarment moved = worn;
    std::vector<Vec3>& moved_m = moved.sewn.garment.mesh.positions;
    const Vec3 by_m = some.between(0.0, 2.0) * some.vector(1.0);
    std::ranges::transform(worn_m, moved_m.begin(), [&](const Vec3& p) { return p + by_m; });
    try {
      require_worn(scene, bodies, moved);
    } catch (const SewingFailed&) {
      return;
    }
    const sim::Extent box = sim::compute_extent(moved_m);
    RC_ASSERT(box.lower.x < waist_m.x && waist_m.x < box.upper.x && box.lower.z < waist_m.z &&
              waist_m.z < box.upper.z && box.upper.y > 0.6);
  }));
}

}  // namespace
}  // namespace taut::app
