// Cloth that crosses itself at the start: nothing new crosses outside the patches around these crossings.

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "app/verify/crossing_pairs.hpp"
#include "scenes.hpp"

namespace taut::sim {
namespace {

using TrianglePlace = std::pair<std::optional<std::size_t>, Index>;

std::map<TrianglePlace, Index> map_groups(const FrameReport& report) {
  std::map<TrianglePlace, Index> groups;
  for (const ExcludedTriangle& t : report.excluded_triangles) {
    groups[{t.body, t.triangle}] = t.group;
  }
  return groups;
}

struct Counted {
  std::size_t in_patches = 0;
  std::size_t outside = 0;
};

void count(std::span<const CrossingPair> pairs, std::optional<std::size_t> body, const FrameReport& report,
           Counted& counted) {
  std::map<TrianglePlace, Index> groups = map_groups(report);
  for (const CrossingPair& pair : pairs) {
    const Index first = groups[{std::nullopt, pair.first}], second = groups[{body, pair.second}];
    ++(first > 0 && first == second ? counted.in_patches : counted.outside);
  }
}

Surface make_cloth(const Simulation& simulation) {
  return {simulation.state().current, simulation.garment().mesh.triangles};
}

Counted crossings(const Simulation& simulation) {
  Counted counted;
  count(app::crossing_pairs(make_cloth(simulation)), {}, simulation.frame_report(), counted);
  return counted;
}

void turn(Mesh& mesh, std::mt19937& random) {
  std::uniform_real_distribution<double> of(-1.0, 1.0);
  const Vec3 axis = glm::normalize(Vec3(of(random), of(random), of(random)) + Vec3(0.0, 1e-3, 0.0));
  const double angle = std::numbers::pi * of(random);
  const Vec3 by_m = 0.06 * Vec3(of(random), of(random), of(random));
  for (Vec3& p : mesh.positions) {
    p = std::cos(angle) * p + std::sin(angle) * glm::cross(axis, p) +
        (1.0 - std::cos(angle)) * glm::dot(axis, p) * axis + by_m;
  }
}

/// Two sheets that go through each other at random, above a ball.
ContactScene pierced_sheets(unsigned seed) {
  std::mt19937 random(seed);
  Mesh first = make_mesh({11, 11, 0.3, 0.3}), second = make_mesh({10, 13, 0.3, 0.3});
  turn(first, random);
  turn(second, random);
  ContactScene scene = {.mesh = both(std::move(first), second)};
  scene.bounded.max_stretch = 0.05;
  scene.surroundings.forces.wind.speed_m_per_s = 0.5;
  scene.surroundings.bodies = {{.name = "ball", .shape = Sphere{{0.0, -0.4, 0.0}, 0.12}}};
  return scene;
}

TEST(Patches, NothingNewCrossesOutsideThem) {
  std::size_t began = 0, ended = 0, most = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    Simulation simulation = begin(pierced_sheets(seed));
    const std::size_t at_start = app::crossing_pairs(make_cloth(simulation)).size();
    Counted found;
    for (int frame = 1; frame <= 30; ++frame) {
      simulation.advance_frame();
      found = crossings(simulation);
      ASSERT_EQ(found.outside, 0U) << "seed " << seed << ", frame " << frame;
      ASSERT_EQ(simulation.frame_report().contact.crossing_pairs, found.in_patches) << "seed " << seed;
      ASSERT_TRUE(simulation.frame_report().bound_kept) << "seed " << seed << ", frame " << frame;
    }
    began += at_start;
    ended += found.in_patches;
    most = std::max(most, at_start);
  }
  EXPECT_GT(began, 600U);
  EXPECT_GT(most, 30U);
  EXPECT_GT(ended, 0U);
}

/// A sheet whose corner goes through a level sheet.
ContactScene corner_through() {
  ContactScene scene = {.mesh = both(make_mesh({17, 17, 0.4, 0.4}),
                                     make_mesh({9, 9, 0.2, 0.2, GridPlane::vertical, {0.0037, 0.1873, 0.0021}}))};
  scene.bounded.max_stretch = 0.05;
  return scene;
}

/// Returns these triangles and all that share a vertex with one of them.
std::set<Index> with_ring(const std::set<Index>& triangles, const Mesh& mesh) {
  std::set<Index> vertices, ring;
  for (const Index t : triangles) {
    vertices.insert(mesh.triangles[t].begin(), mesh.triangles[t].end());
  }
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& of = mesh.triangles[t];
    if (std::any_of(of.begin(), of.end(), [&](Index v) { return vertices.contains(v); })) {
      ring.insert(t);
    }
  }
  return ring;
}

TEST(Patches, AreTwoRingsAroundWhatCrossesAndTheShareOfTheirArea) {
  Simulation simulation = begin(corner_through());
  const Mesh mesh = simulation.garment().mesh;
  std::set<Index> expected;
  for (const CrossingPair& pair : app::crossing_pairs(make_cloth(simulation))) {
    expected.insert({pair.first, pair.second});
  }
  expected = with_ring(with_ring(expected, mesh), mesh);
  simulation.advance_frame();
  std::set<Index> found;
  double area = 0.0, all = 0.0;
  for (const ExcludedTriangle& t : simulation.frame_report().excluded_triangles) {
    found.insert(t.triangle);
    EXPECT_EQ(t.group, simulation.frame_report().excluded_triangles.front().group);
  }
  EXPECT_EQ(found, expected);
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const double size = glm::length(doubled_area_vector(mesh.positions, mesh.triangles[t]));
    all += size;
    area += found.contains(t) ? size : 0.0;
  }
  EXPECT_NEAR(simulation.frame_report().contact.excluded_area_fraction, area / all, 1e-12);
  EXPECT_GT(area, 0.0);
}

// A sheet rests so near to another that their distance is not resolved above rounding in single precision.
TEST(Patches, CountWhatTouchesAtRest) {
  const auto share_at = [](double apart_m) {
    ContactScene scene = {.mesh = both(make_mesh({5, 5, 0.2, 0.2}),
                                       make_mesh({3, 3, 0.02, 0.02, GridPlane::horizontal, {0.003, apart_m, 0.002}}))};
    Simulation simulation = begin(scene);
    simulation.advance_frame();
    EXPECT_TRUE(simulation.frame_report().excluded_triangles.empty());
    return simulation.frame_report().contact.excluded_area_fraction;
  };
  EXPECT_GT(share_at(1.5e-6), 0.0404 / 4.04);
  EXPECT_EQ(share_at(3e-6), 0.0);
}

// Each of two layers is pierced by a small sheet of its own, and one falls onto the other.
TEST(Patches, OfSeveralGroupsAreKeptApart) {
  const auto pierced = [](double height_m) {
    return both(make_mesh({11, 11, 0.2, 0.2, GridPlane::horizontal, {0.0, height_m, 0.0}}),
                make_mesh({4, 4, 0.03, 0.03, GridPlane::vertical, {0.004, height_m + 0.015, 0.003}}));
  };
  ContactScene scene = {.mesh = both(pierced(0.0), pierced(0.05))};
  scene.bounded.max_stretch = 0.05;
  for (Index v = 0; v < 137; ++v) {
    scene.pins.push_back(v);
  }
  Simulation simulation = begin(scene);
  for (int frame = 1; frame <= 30; ++frame) {
    simulation.advance_frame();
    ASSERT_EQ(crossings(simulation).outside, 0U) << frame;
    if (frame == 1) {
      const std::vector<ExcludedTriangle>& excluded_triangles = simulation.frame_report().excluded_triangles;
      EXPECT_NE(excluded_triangles.front().group, excluded_triangles.back().group);
    }
  }
  EXPECT_LT(simulation.frame_report().contact.min_distance_m, 0.0011);
}

// One sheet is lifted out of the other by its pins. Contact then keeps them apart like all other cloth.
TEST(Patches, AreFreeWhenNothingCrossesInThem) {
  ContactScene scene = corner_through();
  for (Index v = 0; v < 17; ++v) {
    scene.pins.insert(scene.pins.end(), {v, 16 * 17 + v});
  }
  const auto upper = static_cast<Index>(17 * 17);
  MovingPins lifted = {.vertices = {}, .motion = {.shift = {{0.0, 0.5, 0.0}, 0.0, 0.2}}};
  lifted.motion.shift.until_s = 0.1;
  for (Index v = 0; v < 9; ++v) {
    scene.pins.push_back(upper + v);
    lifted.vertices.push_back(upper + v);
  }
  scene.surroundings.moving_pins = {lifted};
  std::sort(scene.pins.begin(), scene.pins.end());
  Simulation simulation = begin(scene);
  simulation.advance_frame();
  EXPECT_GT(simulation.frame_report().contact.excluded_area_fraction, 0.0);
  for (int frame = 2; frame <= 30; ++frame) {
    simulation.advance_frame();
    ASSERT_EQ(crossings(simulation).outside, 0U) << frame;
  }
  EXPECT_EQ(simulation.frame_report().contact.excluded_area_fraction, 0.0);
  EXPECT_TRUE(simulation.frame_report().excluded_triangles.empty());
  EXPECT_EQ(simulation.frame_report().contact.crossing_pairs, 0U);
}

TEST(Patches, OfBodiesAndAfterACheckpointAreTheSame) {
  ContactScene scene = pierced_sheets(3);
  scene.surroundings.bodies = {{.name = "box", .shape = box(), .motion = {.shift = {{0.0, 0.3, 0.0}, 0.0, 0.5}}}};
  Simulation through = begin(scene);
  for (int frame = 1; frame <= 4; ++frame) {
    through.advance_frame();
    Counted found = crossings(through);
    std::vector<Vec3> box_m(8);
    positions_at(scene.surroundings.bodies[0], through.state().time_s, box_m);
    const std::vector<Triangle>& triangles = std::get<BodyMesh>(scene.surroundings.bodies[0].shape).data->triangles;
    count(app::crossing_pairs(make_cloth(through), {box_m, triangles}), 0, through.frame_report(), found);
    ASSERT_EQ(found.outside, 0U) << frame;
    ASSERT_EQ(found.in_patches, through.frame_report().contact.crossing_pairs) << frame;
    EXPECT_GT(found.in_patches, 10U);
  }
  Simulation resumed = begin(scene);
  resumed.restore(through.save());
  for (int frame = 5; frame <= 10; ++frame) {
    through.advance_frame();
    resumed.advance_frame();
    ASSERT_EQ(hash(through.state()), hash(resumed.state())) << frame;
    EXPECT_EQ(through.frame_report(), resumed.frame_report()) << frame;
  }
  EXPECT_FALSE(through.frame_report().excluded_triangles.empty());
}

}  // namespace
}  // namespace taut::sim
