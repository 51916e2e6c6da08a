#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/garments/fitting/fitted_mesh.hpp"
#include "app/garments/fitting/sheets.hpp"
#include "app/verify/crossing_pairs.hpp"
#include "sim/mesh/topology.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

using sim::Index;
using sim::Vec3;

/// A grid of quads cut in two. `place` maps columns and rows, both from 0 to 1, to positions.
template <class Place> sim::Mesh patch(Index columns, Index rows, const Place& place) {
  sim::Mesh mesh;
  for (Index r = 0; r <= rows; ++r) {
    for (Index c = 0; c <= columns; ++c) {
      mesh.positions.push_back(place(static_cast<double>(c) / columns, static_cast<double>(r) / rows));
    }
  }
  for (Index r = 0; r < rows; ++r) {
    for (Index c = 0; c < columns; ++c) {
      const Index a = r * (columns + 1) + c, b = a + columns + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  }
  return mesh;
}

void add(const sim::Mesh& part, sim::Mesh& all) {
  const auto first = static_cast<Index>(all.positions.size());
  all.positions.insert(all.positions.end(), part.positions.begin(), part.positions.end());
  for (const sim::Triangle& t : part.triangles) {
    all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
}

/// Point of a circle around the y axis, at this fraction of a turn. A full turn gives the first point again, so that
/// the ends can be welded.
Vec3 around(double turn, double radius, double y) {
  const double angle = turn == 1.0 ? 0.0 : -2.0 * std::numbers::pi * turn;
  return {radius * std::cos(angle), y, radius * std::sin(angle)};
}
sim::Mesh tube(Index columns, Index rows, double radius, double top = 0.8) {
  return patch(columns, rows, [&](double u, double v) { return around(u, radius, v * top); });
}
sim::Mesh sheet(Index columns, Index rows, double width, double height, Vec3 corner = Vec3(0.0)) {
  return patch(columns, rows, [&](double u, double v) { return corner + Vec3(u * width, v * height, 0.0); });
}

struct Judged {
  FittedMesh fitted;
  sim::Topology topology;
  double angle_deg = 0.0;                         ///< smallest angle of a triangle, 1st percentile
  double min_length_m = 0.0, max_length_m = 0.0;  ///< edges, 1st and 99th percentile
  double area_m2 = 0.0;
};

double min_angle(const sim::Mesh& mesh, const sim::Triangle& t) {
  double smallest = 180.0;
  for (int k = 0; k < 3; ++k) {
    const Vec3 x = mesh.positions[t[(k + 1) % 3]] - mesh.positions[t[k]];
    const Vec3 y = mesh.positions[t[(k + 2) % 3]] - mesh.positions[t[k]];
    smallest = std::min(smallest, std::atan2(glm::length(glm::cross(x, y)), glm::dot(x, y)) * 180.0 / std::numbers::pi);
  }
  return smallest;
}

/// Fits a model and requires all promises that hold for every model.
Judged fit(const sim::Mesh& soup, const FittingSettings& settings = {.max_triangles = 3000}) {
  Judged judged;
  judged.fitted = fit_mesh(sim::weld_and_validate(soup).mesh, settings);
  const sim::Mesh& mesh = judged.fitted.mesh;
  judged.topology = sim::measure_topology(mesh, sim::make_adjacency(mesh));
  std::vector<double> angles, lengths;
  for (const sim::Triangle& t : mesh.triangles) {
    angles.push_back(min_angle(mesh, t));
    lengths.push_back(glm::distance(mesh.positions[t[0]], mesh.positions[t[1]]));
  }
  std::sort(angles.begin(), angles.end());
  std::sort(lengths.begin(), lengths.end());
  judged.angle_deg = angles.at(angles.size() / 100);
  judged.min_length_m = lengths.at(lengths.size() / 100);
  judged.max_length_m = lengths.at(lengths.size() * 99 / 100);
  judged.area_m2 = sim::surface_area(mesh);
  EXPECT_EQ(judged.topology.non_manifold_edges, 0U);
  EXPECT_EQ(judged.topology.non_manifold_vertices, 0U);
  EXPECT_EQ(judged.topology.misoriented_edges, 0U);
  EXPECT_GT(judged.angle_deg, 20.0);
  EXPECT_LE(mesh.triangles.size(), settings.max_triangles);
  EXPECT_TRUE(crossing_pairs({mesh.positions, mesh.triangles}).empty());
  EXPECT_EQ(judged.fitted.crossings, 0U);
  return judged;
}

std::ptrdiff_t carried(const Judged& judged) { return std::ranges::count(judged.fitted.is_simulated, 0); }

constexpr double tube_area_m2 = 2.0 * std::numbers::pi * 0.2 * 0.8;

/// A tube of two walls that are joined at its hems.
sim::Mesh thick_tube(double thickness) {
  return patch(60, 44, [&](double u, double v) {
    const double row = std::round(v * 44.0);
    // Rows 0 to 21 go up outside and rows 22 to 43 down inside; row 44 is the first again.
    const bool is_outer = row < 22.0 || row == 44.0;
    const double y = row == 44.0 ? 0.0 : (is_outer ? row : 43.0 - row) / 21.0 * 0.8;
    return around(u, is_outer ? 0.2 : 0.2 - thickness, y);
  });
}

TEST(FittedMesh, IsTheOuterWallOfAClosedShell) {
  const Judged judged = fit(thick_tube(0.002));
  EXPECT_EQ(judged.topology.boundary_loops, 2U);
  EXPECT_EQ(judged.topology.euler_characteristic, 0);
  EXPECT_NEAR(judged.area_m2, tube_area_m2, 0.01 * tube_area_m2);
  EXPECT_GT(carried(judged), 2500);
  for (const Vec3& p : judged.fitted.mesh.positions) {
    EXPECT_GT(std::hypot(p.x, p.z), 0.199);
  }
}

/// A quilt that lies flat: two walls at this distance, joined all around.
sim::Mesh quilt(double thickness) {
  const sim::Mesh front = sheet(30, 30, 0.5, 0.5);
  sim::Mesh walls = front, back = sheet(30, 30, 0.5, 0.5, Vec3(0.0, 0.0, -thickness));
  for (sim::Triangle& t : back.triangles) std::swap(t[1], t[2]);
  add(back, walls);
  const auto first = static_cast<Index>(front.positions.size());
  const std::vector<Index> border = border_loops(front).at(0);
  for (std::size_t k = 0; k < border.size(); ++k) {
    const Index a = border[k], b = border[(k + 1) % border.size()];
    walls.triangles.push_back({b, a, a + first});
    walls.triangles.push_back({b, a + first, b + first});
  }
  return walls;
}

TEST(FittedMesh, IsOneWallOfAQuiltThatLiesFlat) {
  const Judged judged = fit(quilt(0.004));
  EXPECT_EQ(judged.topology.boundary_loops, 1U);
  EXPECT_NEAR(judged.area_m2, 0.25, 0.005);
}

TEST(FittedMesh, FacesOutwards) {
  sim::Mesh inside_out = tube(40, 30, 0.2);
  for (sim::Triangle& t : inside_out.triangles) {
    std::swap(t[1], t[2]);
  }
  for (const sim::Mesh& model : {tube(40, 30, 0.2), inside_out}) {
    const sim::Mesh& mesh = fit(model).fitted.mesh;
    for (const sim::Triangle& t : mesh.triangles) {
      const Vec3 p = mesh.positions[t[0]];
      EXPECT_GT(glm::dot(sim::doubled_area_vector(mesh.positions, t), Vec3(p.x, 0.0, p.z)), 0.0);
    }
  }
}

TEST(FittedMesh, IsTheLargerOfTwoWallsThatAreSeparateParts) {
  sim::Mesh walls = tube(50, 40, 0.198);
  add(tube(60, 40, 0.2), walls);
  const Judged judged = fit(walls);
  EXPECT_EQ(judged.fitted.sheets, 1U);
  EXPECT_NEAR(judged.area_m2, tube_area_m2, 0.01 * tube_area_m2);
  EXPECT_EQ(carried(judged), 4000);
  EXPECT_EQ(judged.fitted.is_simulated.front(), 0);
  EXPECT_EQ(judged.fitted.is_simulated.back(), 1);
}

TEST(FittedMesh, KeepsLayersThatAreFarApart) {
  sim::Mesh layers = tube(60, 40, 0.2);
  add(tube(60, 40, 0.22), layers);
  const Judged judged = fit(layers);
  EXPECT_EQ(judged.fitted.sheets, 2U);
  EXPECT_EQ(carried(judged), 0);
}

TEST(FittedMesh, GoesOnSmoothlyWhereThreeTrianglesMeet) {
  sim::Mesh fin = tube(60, 40, 0.2);
  add(patch(4, 40, [&](double u, double v) { return around(0.25, 0.2 + 0.02 * u, v * 0.8); }), fin);
  const Judged judged = fit(fin);
  EXPECT_EQ(judged.fitted.sheets, 1U);
  EXPECT_EQ(judged.topology.boundary_loops, 2U);
  EXPECT_NEAR(judged.area_m2, tube_area_m2, 0.01 * tube_area_m2);
}

TEST(FittedMesh, CarriesAButtonAndAPocket) {
  sim::Mesh trimmed = tube(60, 40, 0.2);
  // A flat ball that enters the cloth a little.
  add(patch(12, 8,
            [](double u, double v) {
              const double tilt = std::numbers::pi * (v - 0.5);
              return Vec3(0.202, 0.4, 0.0) +
                     Vec3(0.1, 1.0, 1.0) * around(u, 0.01 * std::cos(tilt), 0.01 * std::sin(tilt));
            }),
      trimmed);
  add(patch(10, 10, [](double u, double v) { return around(0.2 + 0.1 * u, 0.203, 0.1 + 0.12 * v); }), trimmed);
  const Judged judged = fit(trimmed);
  EXPECT_EQ(judged.fitted.sheets, 1U);
  EXPECT_NEAR(judged.area_m2, tube_area_m2, 0.01 * tube_area_m2);
  EXPECT_EQ(std::count(judged.fitted.is_simulated.begin(), judged.fitted.is_simulated.begin() + 4800, 1), 4800);
  EXPECT_EQ(std::count(judged.fitted.is_simulated.begin() + 4800, judged.fitted.is_simulated.end(), 1), 0);
}

TEST(FittedMesh, JoinsPanelsWhoseVerticesDoNotMatch) {
  for (const double gap : {0.0, 0.002}) {
    sim::Mesh panels = sheet(20, 33, 0.3, 0.5);
    add(sheet(20, 24, 0.3, 0.5, {0.3 + gap, 0.0, 0.0}), panels);
    const Judged judged = fit(panels);
    EXPECT_EQ(judged.fitted.sheets, 1U);
    EXPECT_EQ(judged.topology.boundary_loops, 1U);
    EXPECT_NEAR(judged.area_m2, 0.3, 0.003);
  }
}

TEST(FittedMesh, LeavesPanelsApartThatDoNotMeet) {
  sim::Mesh panels = sheet(20, 33, 0.3, 0.5);
  add(sheet(20, 24, 0.3, 0.5, {0.31, 0.0, 0.0}), panels);
  EXPECT_EQ(fit(panels).fitted.sheets, 2U);
}

/// A skirt with a band above it, after a gap. The band has this radius and covers this fraction of a turn.
sim::Mesh skirt_below_band(double radius, double gap, double turn = 1.0) {
  sim::Mesh mesh = tube(60, 40, 0.2, 0.6);
  add(patch(50, 6, [&](double u, double v) { return around(turn * u, radius, 0.6 + gap + 0.08 * v); }), mesh);
  return sim::weld_and_validate(mesh).mesh;
}

TEST(FittedMesh, HangsTogetherWhereAPartGoesOnBeyondAGap) {
  for (const sim::Mesh& mesh : {skirt_below_band(0.2, 0.01), skirt_below_band(0.205, 0.0)}) {
    const Judged judged = fit(mesh);
    EXPECT_EQ(judged.fitted.sheets, 1U);
    EXPECT_EQ(judged.topology.boundary_loops, 2U);
    EXPECT_TRUE(why_not_fit_for_simulation(mesh, 0)->starts_with("parts of it lie apart along "));
  }
  EXPECT_EQ(fit(skirt_below_band(0.2, 0.03)).fitted.sheets, 2U) << "too far";
  EXPECT_EQ(fit(skirt_below_band(0.2, 0.01, 0.2)).fitted.sheets, 2U) << "a short piece of both borders";
  EXPECT_EQ(fit(skirt_below_band(0.19, -0.1)).fitted.sheets, 2U) << "another hem within it";
}

TEST(FittedMesh, HangsTogetherWhereOnlyOneBorderContinuesAlongMostOfIt) {
  EXPECT_EQ(fit(skirt_below_band(0.2, 0.01, 0.95)).fitted.sheets, 1U) << "a band with an opening behind";
}

TEST(FittedMesh, DropsASmallPartBesideOthersAndSimulatesOneByItself) {
  for (const bool is_beside : {true, false}) {
    sim::Mesh model = tube(60, 40, 0.2);
    const double radius = is_beside ? 0.21 : 0.3;
    add(patch(4, 8, [&](double u, double v) { return around(0.04 * u, radius, 0.3 + 0.1 * v); }), model);
    const Judged judged = fit(model);
    EXPECT_EQ(judged.fitted.sheets, is_beside ? 1U : 2U);
    EXPECT_EQ(judged.fitted.dropped_sheets, is_beside ? 1U : 0U);
  }
}

TEST(FittedMesh, KeepsBordersAndTheirCornersInPlace) {
  // Triangles are needles: columns are 50 times as narrow as rows are high.
  const Judged judged = fit(sheet(500, 10, 0.5, 0.5));
  EXPECT_NEAR(judged.area_m2, 0.25, 0.0002);
  EXPECT_EQ(judged.topology.boundary_loops, 1U);
  for (const Vec3& corner : {Vec3(0.0), Vec3(0.5, 0.0, 0.0), Vec3(0.0, 0.5, 0.0), Vec3(0.5, 0.5, 0.0)}) {
    double min_distance_m = 1.0;
    for (const Vec3& p : judged.fitted.mesh.positions) {
      min_distance_m = std::min(min_distance_m, glm::distance(p, corner));
    }
    EXPECT_LT(min_distance_m, 1e-9);
  }
}

TEST(FittedMesh, HasEdgesOfOneLengthAndFewerTriangles) {
  const sim::Mesh model =
      patch(200, 100, [](double u, double v) { return around(u, 0.2 + 0.01 * std::sin(50.0 * u) * v, v * 0.8); });
  for (const std::size_t most : {2000U, 8000U}) {
    const Judged judged = fit(model, {.max_triangles = most});
    EXPECT_GT(judged.fitted.mesh.triangles.size(), most * 7 / 10);
    EXPECT_GT(judged.min_length_m, 0.6 * judged.fitted.edge_m);
    EXPECT_LT(judged.max_length_m, 1.4 * judged.fitted.edge_m);
  }
}

TEST(FittedMesh, KeepsNarrowStraps) {
  sim::Mesh top = tube(60, 20, 0.15, 0.4);
  for (const double side : {0.03, 0.53}) {
    add(patch(2, 40,
              [&](double u, double v) {
                const Vec3 foot = around(side + u / 30.0, 0.15, 0.4);
                const double turn = std::numbers::pi * v;
                return Vec3(foot.x * std::cos(turn), 0.4 + 0.15 * std::sin(turn), foot.z);
              }),
        top);
  }
  const Judged judged = fit(top);
  EXPECT_EQ(judged.fitted.sheets, 1U);
  EXPECT_EQ(judged.topology.boundary_loops,
            4U);  // the hem, the neck between the straps, and an armhole beside each strap
  const auto highest = std::max_element(judged.fitted.mesh.positions.begin(), judged.fitted.mesh.positions.end(),
                                        [](const Vec3& a, const Vec3& b) { return a.y < b.y; });
  EXPECT_GT(highest->y, 0.54);
}

// Fitting again cannot remove where two tubes cross, and each fit cuts off more of their roundness.
TEST(FittedMesh, IsFittedAgainOnlyIfThatRemovesCrossings) {
  const sim::Mesh upright = sim::weld_and_validate(tube(60, 40, 0.2)).mesh;
  sim::Mesh crossing = upright, lying = upright;
  for (Vec3& p : lying.positions) p = Vec3(p.y - 0.4, p.x + 0.4, p.z + 0.1);
  add(lying, crossing);
  const FittedMesh alone = fit_mesh(upright, {.max_triangles = 500});
  const FittedMesh both = fit_mesh(crossing, {.max_triangles = 1000});
  EXPECT_GT(both.crossings, 0U);
  EXPECT_GT(sim::surface_area(both.mesh), 0.995 * 2.0 * sim::surface_area(alone.mesh));
}

TEST(FittedMesh, HasTheSameBitsEachTime) {
  const sim::Mesh model = thick_tube(0.003);
  EXPECT_EQ(fit(model).fitted.mesh.positions, fit(model).fitted.mesh.positions);
}

TEST(FittedMesh, IsAsGoodOfAFewLargeTriangles) {
  const sim::Mesh model{
      {{-1.0, 0.0, -1.0}, {1.0, 0.0, -1.0}, {0.0, 0.0, 1.0}, {0.0, 1.0, -1.5}}, {{0, 2, 1}, {0, 1, 3}}, {}};
  const Judged judged = fit(model);
  EXPECT_GT(judged.fitted.mesh.triangles.size(), 1500U);
  EXPECT_NEAR(judged.area_m2, sim::surface_area(model), 0.01 * sim::surface_area(model));
}

// A hole with three sides, here a micrometre long: no collapse can remove its edges.
TEST(Remeshing, LeavesNoEdgeWithoutLength) {
  sim::Mesh model = sheet(20, 20, 0.5, 0.5);
  const std::size_t hole = 2 * (10 * 20 + 10);
  const sim::Triangle t = model.triangles[hole];
  model.positions[t[1]] = model.positions[t[0]] + Vec3(1e-6, 0.0, 0.0);
  model.positions[t[2]] = model.positions[t[0]] + Vec3(0.0, 1e-6, 0.0);
  model.triangles.erase(model.triangles.begin() + static_cast<std::ptrdiff_t>(hole));
  constexpr double edge_m = 0.03;
  const sim::Mesh mesh = remesh(model, edge_m, 1000000);
  for (const sim::Triangle& corners : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_GT(glm::distance(mesh.positions[corners[k]], mesh.positions[corners[(k + 1) % 3]]), 0.1 * edge_m);
    }
  }
  EXPECT_NEAR(sim::surface_area(mesh), 0.25, 0.01);
}

TEST(Remeshing, LeavesLayersThatTouchInTheirPlaces) {
  sim::Mesh layers = tube(60, 40, 0.2);
  add(tube(60, 40, 0.201), layers);
  const sim::Mesh mesh = remesh(sim::weld_and_validate(layers).mesh, 0.05, 1000000);
  sim::Groups parts = sim::connect_vertices(mesh.positions.size(), mesh.triangles);
  std::map<Index, std::set<bool>> is_outer;
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    is_outer[parts.find(v)].insert(std::hypot(mesh.positions[v].x, mesh.positions[v].z) > 0.2004);
  }
  EXPECT_EQ(is_outer.size(), 2U);
  for (const auto& [part, sides] : is_outer) EXPECT_EQ(sides.size(), 1U) << "one layer was drawn onto the other";
}

TEST(Remeshing, EndsWhenItsBudgetIsSpent) {
  EXPECT_THROW(remesh(sheet(20, 20, 0.5, 0.5), 0.03, 500), std::invalid_argument);
}

// Two sheets that share a line count as two, although four triangles meet at each edge of the line. Neither has a
// border there.
TEST(Sheets, BothOfTwoGoOnWhereTheyCross) {
  sim::Mesh cross = sheet(20, 20, 0.5, 0.5, Vec3(-0.25, 0.0, 0.0));
  const auto second = static_cast<Index>(cross.positions.size());
  add(patch(20, 20, [](double u, double v) { return Vec3(0.0, v * 0.5, u * 0.5 - 0.25); }), cross);
  for (sim::Triangle& t : cross.triangles) {
    for (Index& v : t) {
      v = v >= second && (v - second) % 21 == 10 ? v - second : v;
    }
  }
  const Sheets sheets = cut_into_sheets(cross);
  EXPECT_EQ(sheets.count, 2U);
  EXPECT_EQ(std::count(sheets.beyond.begin(), sheets.beyond.end(), sim::no_vertex), 2 * 80);
}

TEST(Sheets, ManyTrianglesAtOneEdgeAreTwoByTwo) {
  sim::Mesh fan{{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, {}, {}};
  for (Index k = 0; k < 500; ++k) {
    const double angle = 0.002 * k;
    fan.positions.emplace_back(std::cos(angle), 0.5, std::sin(angle));
    fan.triangles.push_back({0, 1, k + 2});
  }
  EXPECT_EQ(cut_into_sheets(fan).count, 250U);
}

TEST(WhyNotFit, SaysWhatIsWrong) {
  const auto reason = [](const sim::Mesh& model, std::size_t crossings = 0) {
    return why_not_fit_for_simulation(sim::weld_and_validate(model).mesh, crossings).value_or("");
  };
  EXPECT_EQ(reason(tube(60, 40, 0.2)), "");
  EXPECT_EQ(reason(tube(60, 40, 0.2), 7), "it crosses itself in 7 places");
  EXPECT_EQ(reason(tube(120, 80, 0.2)), "it has 19200 triangles");
  EXPECT_EQ(reason(sheet(500, 10, 0.5, 0.5)), "10000 of its 10000 triangles are needles");
  const sim::Mesh fine = sim::weld_and_validate(sheet(60, 60, 0.054, 0.054)).mesh;
  EXPECT_FALSE(why_not_fit_for_simulation(fine, 0, 0.0008).has_value());
  EXPECT_EQ(why_not_fit_for_simulation(fine, 0, 0.001).value_or(""),
            "7320 of its edges are shorter than the cloth is thick");
  EXPECT_EQ(reason(thick_tube(0.002)), "it has two walls over 100 % of its area");
  sim::Mesh walls = tube(50, 40, 0.198);
  add(tube(60, 40, 0.2), walls);
  EXPECT_EQ(reason(walls), "parts of 4000 triangles lie on others");
}

}  // namespace
}  // namespace taut::app
