#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <string>
#include <vector>

#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/pins.hpp"
#include "sim/springs.hpp"

namespace taut::sim {
namespace {

Springs map_springs(const Mesh& mesh, FlexuralRule rule = FlexuralRule::angular) {
  MappingSettings settings;
  settings.flexural_rule = rule;
  return map_to_springs(mesh, make_adjacency(mesh), settings);
}

Mesh make_test_grid(Index columns, Index rows) {
  GridSettings settings;
  settings.columns = columns;
  settings.rows = rows;
  return make_grid(settings);
}

using Drawing = std::vector<std::string>;

/// Draws a 5x5 grid: `centre` as o, and every mass point that a spring of the kind joins to it as x.
Drawing draw_springs_at(const Springs& springs, SpringKind kind, Index centre) {
  Drawing drawing(5, ".....");
  drawing[centre / 5][centre % 5] = 'o';
  for (std::size_t s = springs.begin_index(kind); s < springs.end_index(kind); ++s) {
    const auto [a, b] = springs.ends[s];
    if (a == centre || b == centre) {
      const Index other = a == centre ? b : a;
      drawing[other / 5][other % 5] = 'x';
    }
  }
  return drawing;
}

// The paper's Figure 1, seen from the middle, from a corner and from beside the border.

TEST(MappingOfA5x5Grid, StructuralSpringsJoinHorizontalAndVerticalNeighbours) {
  const Springs springs = map_springs(make_test_grid(5, 5));
  EXPECT_EQ(draw_springs_at(springs, SpringKind::structural, 12), (Drawing{".....",  //
                                                                           "..x..",  //
                                                                           ".xox.",  //
                                                                           "..x..",  //
                                                                           "....."}));
  EXPECT_EQ(draw_springs_at(springs, SpringKind::structural, 0), (Drawing{"ox...",  //
                                                                          "x....",  //
                                                                          ".....",  //
                                                                          ".....",  //
                                                                          "....."}));
}

TEST(MappingOfA5x5Grid, ShearSpringsJoinDiagonalNeighbours) {
  const Springs springs = map_springs(make_test_grid(5, 5));
  EXPECT_EQ(draw_springs_at(springs, SpringKind::shear, 12), (Drawing{".....",  //
                                                                      ".x.x.",  //
                                                                      "..o..",  //
                                                                      ".x.x.",  //
                                                                      "....."}));
  EXPECT_EQ(draw_springs_at(springs, SpringKind::shear, 10), (Drawing{".....",  //
                                                                      ".x...",  //
                                                                      "o....",  //
                                                                      ".x...",  //
                                                                      "....."}));
}

TEST(MappingOfA5x5Grid, FlexuralSpringsSkipOneMassPoint) {
  const Springs springs = map_springs(make_test_grid(5, 5));
  EXPECT_EQ(draw_springs_at(springs, SpringKind::flexural, 12), (Drawing{"..x..",  //
                                                                         ".....",  //
                                                                         "x.o.x",  //
                                                                         ".....",  //
                                                                         "..x.."}));
  EXPECT_EQ(draw_springs_at(springs, SpringKind::flexural, 6), (Drawing{".....",  //
                                                                        ".o.x.",  //
                                                                        ".....",  //
                                                                        ".x...",  //
                                                                        "....."}));
}

TEST(MappingOfA5x5Grid, HasTheNumbersOfFigure1) {
  const Springs springs = map_springs(make_test_grid(5, 5));
  EXPECT_EQ(springs.count(SpringKind::structural), 2u * 5 * 4);
  EXPECT_EQ(springs.count(SpringKind::shear), 2u * 4 * 4);
  EXPECT_EQ(springs.count(SpringKind::flexural), 2u * 5 * 3);
}

TEST(Mapping, RestLengthsAreTheModelsOwn) {
  const Mesh mesh = make_test_grid(3, 3);
  const Springs springs = map_springs(mesh);
  ASSERT_GT(springs.size(), 0u);
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const auto [a, b] = springs.ends[s];
    EXPECT_EQ(springs.rest_lengths_m[s], glm::length(mesh.positions[a] - mesh.positions[b]));
  }
}

TEST(Mapping, JoinsNoTwoVerticesTwice) {
  for (const FlexuralRule rule : {FlexuralRule::angular, FlexuralRule::opposite_vertex}) {
    Mesh triangles = make_test_grid(6, 4);
    triangles.quads.clear();
    for (const Mesh& mesh : {make_test_grid(6, 4), triangles}) {
      const Springs springs = map_springs(mesh, rule);
      const std::set<Edge> distinct(springs.ends.begin(), springs.ends.end());
      EXPECT_EQ(distinct.size(), springs.size());
      for (const Edge& e : springs.ends) {
        EXPECT_LT(e[0], e[1]);
      }
    }
  }
}

/// Six triangles around vertex 0, the rim at these angles in degrees.
Mesh fan(const std::vector<double>& angles_deg, bool closed) {
  Mesh mesh;
  mesh.positions.push_back({0, 0, 0});
  for (const double angle : angles_deg) {
    const double rad = angle * 3.14159265358979 / 180.0;
    mesh.positions.push_back({std::cos(rad), std::sin(rad), 0});
  }
  const auto rim = static_cast<Index>(angles_deg.size());
  for (Index k = 0; k + (closed ? 0 : 1) < rim; ++k) {
    mesh.triangles.push_back({0, 1 + k, 1 + (k + 1) % rim});
  }
  return mesh;
}

std::set<Edge> flexural_springs(const Mesh& mesh, FlexuralRule rule = FlexuralRule::angular) {
  const Springs springs = map_springs(mesh, rule);
  return {springs.ends.begin() + static_cast<std::ptrdiff_t>(springs.begin_index(SpringKind::flexural)),
          springs.ends.end()};
}

TEST(AngularRule, JoinsStraightOppositeNeighboursOfAHexagon) {
  EXPECT_EQ(flexural_springs(fan({0, 60, 120, 180, 240, 300}, true)),
            (std::set<Edge>{{1, 4}, {2, 5}, {3, 6}}));
}

TEST(AngularRule, JoinsNothingBelowTheAngle) {
  // Opposite neighbours of a pentagon's corner are 144 degrees apart.
  EXPECT_TRUE(flexural_springs(fan({0, 72, 144, 216, 288}, true)).empty());
}

TEST(AngularRule, TakesTheStraightestNeighbour) {
  // Vertices at 155, 178 and 200 degrees lie opposite to vertex 1 at 0 degrees; 178 is the straightest. Vertex 1 is
  // also the straightest for the two others.
  const auto springs = flexural_springs(fan({0, 80, 155, 178, 200, 280}, true));
  EXPECT_TRUE(springs.count({1, 4}));
  EXPECT_TRUE(springs.count({1, 3}));  // seen from 155 degrees, nothing lies straighter than 0
  EXPECT_TRUE(springs.count({1, 5}));
  EXPECT_TRUE(springs.count({2, 6}));
}

TEST(AngularRule, TheAngleIsASetting) {
  const Mesh mesh = fan({0, 140, 250}, true);
  MappingSettings settings;
  EXPECT_EQ(map_to_springs(mesh, make_adjacency(mesh), settings).count(SpringKind::flexural), 0u);
  settings.flexural_rule = FlexuralRule::angular;
  settings.min_flexural_angle_rad = 2.4;  // 137.5 degrees
  // Vertices 1 and 2 are 140 degrees apart around the fan's centre, but the rim joins them already.
  EXPECT_EQ(map_to_springs(mesh, make_adjacency(mesh), settings).count(SpringKind::flexural), 0u);
  const Mesh open = {{{0, 0, 0}, {1, 0, 0}, {-0.766, 0.643, 0}, {0, 1, 0}}, {{0, 1, 3}, {0, 3, 2}}, {}};
  EXPECT_EQ(map_to_springs(open, make_adjacency(open), settings).ends.back(), (Edge{1, 2}));
}

TEST(OppositeVertexRule, JoinsAcrossInteriorEdgesOnly) {
  EXPECT_EQ(flexural_springs(fan({0, 60, 120}, false), FlexuralRule::opposite_vertex),
            (std::set<Edge>{{1, 3}}));
}

TEST(OppositeVertexRule, LeavesNonManifoldEdgesAlone) {
  const Mesh three_pages = {
      {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, {}};
  EXPECT_TRUE(flexural_springs(three_pages, FlexuralRule::opposite_vertex).empty());
}

TEST(Mapping, OneTriangleHasThreeStructuralSprings) {
  const Springs springs = map_springs({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}});
  EXPECT_EQ(springs.ends, (std::vector<Edge>{{0, 1}, {0, 2}, {1, 2}}));
  EXPECT_EQ(springs.structural_count, 3u);
}

TEST(Adjacency, ListsEdgesAndTheirTriangles) {
  const Mesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}, {}};
  const Adjacency adjacency = make_adjacency(mesh);
  EXPECT_EQ(adjacency.edges, (std::vector<Edge>{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}}));
  ASSERT_EQ(adjacency.edge_triangles.size(), 5u);
  EXPECT_EQ(adjacency.edge_triangles[0].size(), 1u);
  ASSERT_EQ(adjacency.edge_triangles[2].size(), 2u);
  EXPECT_EQ(adjacency.edge_triangles[2][1], 1u);
  ASSERT_EQ(adjacency.vertex_edges[1].size(), 3u);
  EXPECT_EQ(adjacency.vertex_edges[1][0], 0u);
  EXPECT_EQ(adjacency.vertex_edges[1][2], 3u);
}

TEST(Garment, SharesTheMassEvenly) {
  const Garment garment = make_garment(make_test_grid(3, 3), {}, {.areal_density_kg_per_m2 = 0.2});
  double total = 0.0;
  for (const double mass : garment.masses_kg) {
    total += mass;
  }
  EXPECT_NEAR(total, 0.2, 1e-15);
  EXPECT_NEAR(garment.masses_kg[4], 4 * garment.masses_kg[0], 1e-15);
  EXPECT_NEAR(garment.masses_kg[0], garment.masses_kg[2], 1e-15);
}

TEST(Garment, WithAnotherMaterialEqualsOneMadeOfIt) {
  const Material denim = {.areal_density_kg_per_m2 = 0.4, .bending_rigidity_n_m = 5e-5, .friction = 0.6};
  const Garment made = make_garment(make_test_grid(3, 3), {}, denim);
  const Garment changed = with_material(make_garment(make_test_grid(3, 3)), denim);
  EXPECT_EQ(changed.material, denim);
  EXPECT_EQ(changed.masses_kg, made.masses_kg);
  EXPECT_THROW(with_material(made, {.friction = -0.1}), std::invalid_argument);
}

TEST(Pins, AreSortedAndUniqueAndHaveInfiniteMass) {
  const Garment garment = make_garment(make_test_grid(3, 3));
  const Pins pins = make_pins(garment, {2, 0, 2});
  EXPECT_EQ(pins.vertices, (std::vector<Index>{0, 2}));
  EXPECT_EQ(pins.inverse_masses_per_kg[2], 0.0);
  EXPECT_EQ(pins.inverse_masses_per_kg[1], 1.0 / garment.masses_kg[1]);
  EXPECT_THROW(make_pins(garment, {9}), std::invalid_argument);
}

TEST(Garment, SharesATrianglesMassAmongItsCorners) {
  const Mesh mesh = {{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}, {}};
  const Garment garment = make_garment(mesh, {}, {.areal_density_kg_per_m2 = 0.5});
  for (const double mass : garment.masses_kg) {
    EXPECT_NEAR(mass, 0.5, 1e-15);
  }
}

TEST(Garment, GivesVerticesOfNeedlesALeastMass) {
  Mesh mesh = make_test_grid(9, 9);
  const Garment even = make_garment(mesh);
  const auto corner = static_cast<Index>(mesh.positions.size());
  // A triangle of almost no area lies outside, at a corner of the grid.
  mesh.positions.push_back(mesh.positions[0] + Vec3(0.0, 1e-6, 1e-6));
  mesh.triangles.push_back({0, 1, corner});
  const Garment garment = make_garment(mesh);
  EXPECT_GT(garment.masses_kg[corner], 0.03 * even.masses_kg[40]);
  EXPECT_LT(garment.masses_kg[corner], 0.05 * even.masses_kg[40]);
  EXPECT_NEAR(garment.masses_kg[40], even.masses_kg[40], 1e-12);
}

TEST(Garment, RefusesImpossibleMaterials) {
  EXPECT_THROW(make_garment(make_test_grid(3, 3), {}, {.areal_density_kg_per_m2 = 0.0}), std::invalid_argument);
  EXPECT_THROW(make_garment(make_test_grid(3, 3), {}, {.thickness_m = -0.001}), std::invalid_argument);
}

}  // namespace
}  // namespace taut::sim
