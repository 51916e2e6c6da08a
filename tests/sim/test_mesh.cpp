#include <gtest/gtest.h>

#include <limits>

#include "sim/mesh/grid.hpp"
#include "sim/mesh/mesh.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::sim {
namespace {

const Vec3 origin = {0, 0, 0};
const Vec3 right = {1, 0, 0};
const Vec3 up = {0, 1, 0};
const Vec3 diagonal = {1, 1, 0};

TEST(WeldAndValidate, KeepsACleanMeshAsItIs) {
  const Mesh input = {{origin, right, up, diagonal}, {{0, 1, 2}, {2, 1, 3}}, {}};
  const ValidatedMesh out = weld_and_validate(input);
  EXPECT_EQ(out.mesh.positions, input.positions);
  EXPECT_EQ(out.mesh.triangles, input.triangles);
  EXPECT_EQ(out.report.input_vertices, 4u);
  EXPECT_EQ(out.report.welded_vertices, 0u);
}

TEST(WeldAndValidate, WeldsATriangleSoupAtEqualPositions) {
  const Mesh soup = {{origin, right, up, up, right, diagonal}, {{0, 1, 2}, {3, 4, 5}}, {}};
  const ValidatedMesh out = weld_and_validate(soup);
  EXPECT_EQ(out.mesh.positions, (std::vector<Vec3>{origin, right, up, diagonal}));
  EXPECT_EQ(out.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_EQ(out.report.welded_vertices, 2u);
  EXPECT_EQ(out.report.unused_vertices, 0u);
}

TEST(WeldAndValidate, TakesMinusZeroForZero) {
  const Mesh soup = {{origin, right, up, {-0.0, 0.0, -0.0}}, {{0, 1, 2}, {3, 1, 2}}, {}};
  const ValidatedMesh out = weld_and_validate(soup);
  EXPECT_EQ(out.report.welded_vertices, 1u);
  EXPECT_EQ(out.report.duplicate_triangles, 1u);
}

TEST(WeldAndValidate, DropsWhatHasNoAreaAndReportsIt) {
  const Mesh input = {
      {origin, right, up, {2, 0, 0}}, {{0, 1, 2}, {0, 1, 3}, {0, 0, 1}, {1, 2, 0}, {2, 1, 0}}, {}};
  const ValidatedMesh out = weld_and_validate(input);
  EXPECT_EQ(out.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(out.report.degenerate_triangles, 2u);
  EXPECT_EQ(out.report.duplicate_triangles, 2u);
  EXPECT_EQ(out.report.unused_vertices, 1u);
}

TEST(WeldAndValidate, RenumbersAroundUnusedVertices) {
  const Mesh input = {{{9, 9, 9}, origin, {8, 8, 8}, right, up}, {{1, 3, 4}}, {}};
  const ValidatedMesh out = weld_and_validate(input);
  EXPECT_EQ(out.mesh.positions, (std::vector<Vec3>{origin, right, up}));
  EXPECT_EQ(out.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(out.report.unused_vertices, 2u);
}

TEST(WeldAndValidate, TellsWhatBecameOfEachVertex) {
  const Vec3 aside = {2, 0, 0};
  // Vertex 0 is unused, 4 is welded to 1, 6 belongs only to a triangle without area, 7 lies at 1 and is unused.
  const Mesh input = {
      {{9, 9, 9}, right, up, origin, right, diagonal, aside, right}, {{3, 1, 2}, {2, 4, 5}, {3, 1, 6}}, {}};
  const ValidatedMesh out = weld_and_validate(input);
  EXPECT_EQ(out.result_vertices, (std::vector<Index>{no_vertex, 0, 1, 2, 0, 3, no_vertex, no_vertex}));
  for (const Index v : {1U, 2U, 3U, 4U, 5U}) {
    EXPECT_EQ(out.mesh.positions[out.result_vertices[v]], input.positions[v]);
  }
}

TEST(WeldAndValidate, TellsWhatBecameOfNearVertices) {
  const Mesh input = {
      {origin, right, up, {1.0001, 0, 0}, diagonal, {0, 1.0001, 0}}, {{0, 1, 2}, {5, 3, 4}}, {}};
  EXPECT_EQ(weld_and_validate(input, {.weld_distance_m = 0.01}).result_vertices,
            (std::vector<Index>{0, 1, 2, 1, 3, 2}));
}

TEST(WeldAndValidate, KeepsTinyTriangles) {
  const double s = 1e-9;
  const ValidatedMesh out = weld_and_validate({{origin, {s, 0, 0}, {0, s, 0}}, {{0, 1, 2}}, {}});
  EXPECT_EQ(out.mesh.triangles.size(), 1u);
}

// A closed ring of triangles around a vertex, as in the middle of a cloth.
Mesh closed_fan(const Vec3& middle, double lift, bool shares_vertices) {
  Mesh mesh;
  const std::vector<Vec3> rim = {{1, 0, lift}, {0, 1, lift}, {-1, 0, lift}, {0, -1, lift}};
  if (shares_vertices) {
    mesh.positions = {middle, rim[0], rim[1], rim[2], rim[3]};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
    return mesh;
  }
  for (Index k = 0; k < 4; ++k) {
    mesh.positions.insert(mesh.positions.end(), {middle, rim[k], rim[(k + 1) % 4]});
    mesh.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  return mesh;
}

Mesh both(Mesh a, const Mesh& b) {
  const auto first = static_cast<Index>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const Triangle& t : b.triangles) {
    a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return a;
}

TEST(WeldAndValidate, KeepsLayersThatTouchApart) {
  for (const bool shares : {true, false}) {
    const Mesh layers = both(closed_fan(origin, 0.5, shares), closed_fan(origin, -0.5, shares));
    const ValidatedMesh out = weld_and_validate(layers);
    EXPECT_EQ(out.mesh.positions.size(), 10u);
    EXPECT_EQ(out.report.unwelded_vertices, 1u);
    EXPECT_EQ(out.report.welded_vertices, layers.positions.size() - 10u);
    EXPECT_EQ(out.report.unused_vertices, 0u);
    EXPECT_EQ(out.mesh.triangles.size(), 8u);
  }
}

// Only shared vertices in the file tell which triangles belong together if layers touch along a whole line.
TEST(WeldAndValidate, KeepsLayersThatTouchAlongALineApart) {
  Mesh layer = {{{0, 0, 0},
                 {1, 0, 0},
                 {-1, 1, 0},
                 {0, 1, 0},
                 {1, 1, 0},
                 {2, 1, 0},
                 {0, -1, 0},
                 {1, -1, 0},
                 {-1, -1, 0},
                 {2, 0, 0},
                 {-1, 0, 0}},
                {},
                {}};
  layer.triangles = {{0, 1, 3}, {1, 4, 3}, {0, 3, 2}, {0, 2, 10}, {0, 10, 8}, {0, 8, 6},
                     {0, 6, 1}, {1, 6, 7}, {1, 7, 9}, {1, 9, 5},  {1, 5, 4}};
  Mesh above = layer;
  for (Vec3& p : above.positions) {
    p.z = (p.y == 0 && p.x >= 0 && p.x <= 1) ? 0.0 : 0.5;
  }
  const ValidatedMesh out = weld_and_validate(both(layer, above));
  EXPECT_EQ(out.report.unwelded_vertices, 2u);
  EXPECT_EQ(out.mesh.positions.size(), 22u);
}

TEST(WeldAndValidate, DoesNotTearWhatTheFileJoins) {
  const Mesh hourglass = {{origin, {1, 0, 1}, {0, 1, 1}, {-1, -1, 1}, {1, 0, -1}, {0, 1, -1}, {-1, -1, -1}},
                          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}},
                          {}};
  EXPECT_EQ(weld_and_validate(hourglass).mesh.positions.size(), 7u);
}

TEST(WeldAndValidate, WeldsWhatIsNearOnlyWhereAsked) {
  const double gap = 1e-4;
  const Mesh seam = {
      {origin, right, up, {0, 1 + gap, 0}, {1 + gap, 0, 0}, diagonal}, {{0, 1, 2}, {3, 4, 5}}, {}};
  EXPECT_EQ(weld_and_validate(seam).mesh.positions.size(), 6u);
  const ValidatedMesh out = weld_and_validate(seam, {.weld_distance_m = 2e-4});
  EXPECT_EQ(out.mesh.positions, (std::vector<Vec3>{origin, right, up, diagonal}));
  EXPECT_EQ(out.report.near_vertices, 2u);
  EXPECT_EQ(out.report.welded_vertices, 0u);
  EXPECT_EQ(out.report.unused_vertices, 0u);
}

TEST(WeldAndValidate, TurnsTheFewTrianglesThatFaceTheOtherWay) {
  const Mesh input = {{origin, right, diagonal, up, {0, 2, 0}}, {{0, 2, 1}, {0, 2, 3}, {2, 4, 3}}, {}};
  const ValidatedMesh out = weld_and_validate(input);
  EXPECT_EQ(out.report.turned_triangles, 1u);
  EXPECT_EQ(out.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {2, 4, 3}}));
}

std::string error_text(const Mesh& mesh) {
  try {
    weld_and_validate(mesh);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

TEST(WeldAndValidate, RefusesBadMeshesWithTheReason) {
  EXPECT_EQ(error_text({{origin, right, up}, {{0, 1, 3}}, {}}),
            "triangle 0 uses vertex 3, but there are only 3 vertices");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_text({{origin, {0, nan, 0}, up}, {{0, 1, 2}}, {}}), "vertex 1 has a coordinate that is not finite");
  EXPECT_EQ(error_text({{origin, right}, {{0, 1, 1}}, {}}), "no triangle with an area remains of 1 triangles");
  EXPECT_EQ(error_text({}), "no triangle with an area remains of 0 triangles");
}

TEST(Grid, HasItsSizeAndFacesTheViewer) {
  GridSettings settings;
  settings.columns = 4;
  settings.rows = 3;
  settings.width_m = 3.0;
  settings.height_m = 1.0;
  settings.top_centre_m = {0, 2, 0};
  const Mesh mesh = make_grid(settings);
  ASSERT_EQ(mesh.positions.size(), 12u);
  EXPECT_EQ(mesh.positions[0], Vec3(-1.5, 2, 0));
  EXPECT_EQ(mesh.positions[11], Vec3(1.5, 1, 0));
  EXPECT_EQ(mesh.quads.size(), 6u);
  EXPECT_NEAR(surface_area(mesh), 3.0, 1e-12);
  for (const Triangle& t : mesh.triangles) {
    EXPECT_GT(doubled_area_vector(mesh.positions, t).z, 0.0);
  }
  settings.plane = GridPlane::horizontal;
  const Mesh lying = make_grid(settings);
  EXPECT_EQ(lying.positions[11], Vec3(1.5, 2, 1));
  for (const Triangle& t : lying.triangles) {
    EXPECT_GT(doubled_area_vector(lying.positions, t).y, 0.0);
  }
}

TEST(Grid, RefusesWhatIsNoGrid) {
  EXPECT_THROW(make_grid({.columns = 1}), std::invalid_argument);
  EXPECT_THROW(make_grid({.width_m = 0.0}), std::invalid_argument);
}

/// A strip of squares from x = 0 on, two vertices wide: its ends, its sides and its corners are borders.
Mesh strip(double from_x, double to_x, const Vec3& risen, int squares = 3) {
  Mesh mesh;
  for (int k = 0; k <= squares; ++k) {
    const double y = 0.1 * k;
    mesh.positions.insert(mesh.positions.end(), {Vec3(from_x, y, 0.0), Vec3(to_x, y, 0.0) + risen});
  }
  for (Index k = 0; k < 2 * static_cast<Index>(squares); k += 2) {
    mesh.triangles.insert(mesh.triangles.end(), {{k, k + 1, k + 3}, {k, k + 3, k + 2}});
  }
  return mesh;
}

Mesh together(const std::vector<Mesh>& parts) {
  Mesh all;
  for (const Mesh& part : parts) {
    const auto first = static_cast<Index>(all.positions.size());
    all.positions.insert(all.positions.end(), part.positions.begin(), part.positions.end());
    for (const auto& [a, b, c] : part.triangles) {
      all.triangles.push_back({a + first, b + first, c + first});
    }
  }
  return all;
}

std::size_t sewn(const std::vector<Mesh>& parts, double distance_m = 1e-3) {
  return weld_and_validate(together(parts), {.sewing_distance_m = distance_m}).report.sewn_vertices;
}

TEST(Sewing, JoinsBordersOfDifferentParts) {
  const Vec3 level(0.0);
  EXPECT_EQ(sewn({strip(0.0, 0.1, level), strip(0.1005, 0.2, level)}), 4U);
  EXPECT_EQ(sewn({strip(0.0, 0.1, level), strip(0.1015, 0.2, level)}), 0U);
  EXPECT_EQ(sewn({strip(0.0, 0.1, level), strip(0.1005, 0.2, level)}, 0.0), 0U);
  const ValidatedMesh out = weld_and_validate(together({strip(0.0, 0.1, level), strip(0.1005, 0.2, level)}),
                                              {.sewing_distance_m = 1e-3});
  EXPECT_EQ(out.mesh.positions.size(), 12U);
  EXPECT_EQ(out.mesh.triangles.size(), 12U);
  EXPECT_EQ(out.report.unused_vertices, 0U);
}

TEST(Sewing, NeverJoinsAPartToItself) {
  EXPECT_EQ(sewn({strip(0.0, 0.0005, Vec3(0.0))}), 0U);
  // The strip between two others is narrower than the sewing distance, so that its two sides would become one.
  EXPECT_EQ(
      sewn({strip(0.0, 0.1, Vec3(0.0)), strip(0.1003, 0.1006, Vec3(0.0)), strip(0.1009, 0.2, Vec3(0.0))}),
      0U);
}

TEST(Sewing, LeavesLayersApart) {
  Mesh above = strip(0.0, 0.1, Vec3(0.0));
  for (Vec3& p : above.positions) {
    p.z += 5e-4;
  }
  EXPECT_EQ(sewn({strip(0.0, 0.1, Vec3(0.0)), above}), 0U);
  // Two sheets diverge from a seam, by 5 and by 13 degrees.
  EXPECT_EQ(sewn({strip(0.0005, 0.1, Vec3(0.0)), strip(0.0, 0.1, {0.0, 0.0, 0.009})}), 0U);
  EXPECT_EQ(sewn({strip(0.0005, 0.1, Vec3(0.0)), strip(0.0, 0.1, {0.0, 0.0, 0.023})}), 4U);
}

}  // namespace
}  // namespace taut::sim
