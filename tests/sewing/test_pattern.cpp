// Sewing patterns in JSON: every kind of edge, and messages about faulty files.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/base/errors.hpp"
#include "app/garments/sewing/cutting.hpp"
#include "app/garments/sewing/pattern.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using sim::Vec2;
using sim::Vec3;

const std::string square = R"("vertices": [[0, 0], [10, 0], [10, 10], [0, 10]])";

std::string edges(const std::string& first_curvature) {
  return R"("edges": [{"endpoints": [0, 1])" + (first_curvature.empty() ? "" : ", \"curvature\": " + first_curvature) +
         R"(}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}])";
}

std::string pattern_text(const std::string& panels, const std::string& stitches = "",
                         const std::string& properties = "{}") {
  return R"({"pattern": {"panels": {)" + panels + R"(}, "stitches": [)" + stitches +
         "]}, \"properties\": " + properties + '}';
}

struct Pattern : testing::Test {
  SewingPattern read(const std::string& text) const { return read_sewing_pattern(folder.write("pattern.json", text)); }
  /// The first edge of a square, from (0, 0) to (10, 0) cm, in m.
  std::vector<Vec2> line(const std::string& curvature, const std::string& properties = "{}") const {
    return read(pattern_text(R"("a": {)" + square + ", " + edges(curvature) + '}', "", properties))
        .panels[0]
        .edges_m[0];
  }
  std::string error(const std::string& text) const {
    return test::error_message<InputError>([&] { read(text); });
  }
  std::string error_of_edge(const std::string& curvature) const {
    return test::error_message<InputError>([&] { line(curvature); });
  }

  test::TemporaryFolder folder;
};

Vec2 compute_middle(const std::vector<Vec2>& line) { return evenly_along(line, 2)[1]; }

void expect_near(const Vec2& found, const Vec2& expected) {
  EXPECT_LT(glm::distance(found, expected), 1e-4) << found.x << ' ' << found.y;
}

TEST_F(Pattern, ReadsStraightEdgesInCentimetres) {
  const std::vector<Vec2> found = line("");
  ASSERT_EQ(found.size(), 2u);
  expect_near(found[1], {0.1, 0.0});
  expect_near(line("", R"({"units_in_meter": 1000})")[1], {0.01, 0.0});
}

TEST_F(Pattern, ReadsCurvesOfBezierRelativeToTheEdgeOrAsTheyStand) {
  expect_near(compute_middle(line("[0.5, 0.2]")), {0.05, 0.01});
  expect_near(compute_middle(line(R"({"type": "quadratic", "params": [[0.5, 0.2]]})")), {0.05, 0.01});
  expect_near(compute_middle(line("[5, 2]", R"({"curvature_coords": "absolute"})")), {0.05, 0.01});
  expect_near(compute_middle(line(R"({"type": "cubic", "params": [[0.25, 0.2], [0.75, 0.2]]})")), {0.05, 0.015});
}

TEST_F(Pattern, ReadsArcsToBothSidesAndThePolylinesOfOtherPrograms) {
  // A circle of radius 6.25 through both ends and (5, -2.5).
  const auto arc = [&](const char* large, const char* right) {
    return line(std::string(R"({"type": "circle", "params": [6.25, )") + large + ", " + right + "]}");
  };
  expect_near(compute_middle(arc("0", "1")), {0.05, -0.025});
  expect_near(compute_middle(arc("0", "0")), {0.05, 0.025});
  expect_near(compute_middle(arc("1", "1")), {0.05, -0.1});
  expect_near(compute_middle(arc("1", "false")), {0.05, 0.1});
  EXPECT_NEAR(polyline_length(arc("0", "1")), 0.0625 * 2.0 * std::asin(0.8), 5e-5);
  expect_near(compute_middle(line(R"({"type": "polyline", "params": [[0.5, 0.5]]})")), {0.05, 0.05});
}

TEST_F(Pattern, PlacesPanelsAsMayaTurnsThem) {
  const PatternPanel panel = read(pattern_text(R"("a": {)" + square + ", " + edges("") +
                                               R"(, "rotation": [90, 0, 90], "translation": [1, 2, 3]})"))
                                 .panels[0];
  // A rotation about x from (10, 20, 0) to (10, 0, 20), then one about z to (0, 10, 20).
  EXPECT_LT(glm::distance(panel.placed_m({0.1, 0.2}), Vec3(0.01, 0.12, 0.23)), 1e-12);
}

TEST_F(Pattern, PassesOverComments) {
  EXPECT_EQ(
      read("// a square\n" + pattern_text(R"("a": {)" + square + ", " + edges("") + "} /* alone */")).panels.size(),
      1u);
}

TEST_F(Pattern, SaysWhereAFileIsWrong) {
  const std::string panel = R"("a": {)" + square + ", " + edges("") + '}';
  EXPECT_NE(error("{\"pattern\": {").find("parse error at line 1"), std::string::npos);
  EXPECT_NE(error("[1, 2]").find("the file: found [1,2], expected a member 'pattern'"), std::string::npos);
  EXPECT_NE(error(pattern_text("")).find("pattern.panels: found {}, expected 1 to 500 panels"), std::string::npos);
  EXPECT_NE(error(pattern_text(R"("a": {"vertices": [[0, 0], [1, "x"]], "edges": []})"))
                .find("pattern.panels.a.vertices[1]: found [1,\"x\"], expected 2 numbers"),
            std::string::npos);
  EXPECT_NE(error(pattern_text(R"("a": {)" + square + R"(, "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 9]}]})"))
                .find("pattern.panels.a.edges[1].endpoints[1]: found 9, expected the number of a vertex, "
                      "from 0 to 3"),
            std::string::npos);
  EXPECT_NE(error(pattern_text(R"("a": {)" + square + R"(, "edges": [{"endpoints": [0, 1]}, {"endpoints": [2, 3]}]})"))
                .find("expected an edge from vertex 1"),
            std::string::npos);
  EXPECT_NE(error(pattern_text(R"("a": {)" + square + R"(, "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}]})"))
                .find("expected a closed outline"),
            std::string::npos);
  EXPECT_NE(error(pattern_text(panel, R"([{"panel": "b", "edge": 0}, {"panel": "a", "edge": 0}])"))
                .find("pattern.stitches[0][0].panel: found \"b\", expected the name of a panel"),
            std::string::npos);
  EXPECT_NE(error(pattern_text(panel, R"([{"panel": "a", "edge": 4}, {"panel": "a", "edge": 0}])"))
                .find("pattern.stitches[0][0].edge: found 4, expected the number of an edge of that panel, "
                      "from 0 to 3"),
            std::string::npos);
  EXPECT_NE(error(pattern_text(panel, R"([{"panel": "a", "edge": 1}, {"panel": "a", "edge": 1}])"))
                .find("expected two different edges"),
            std::string::npos);
  EXPECT_NE(error(pattern_text(panel, "", R"({"units_in_meter": 0})"))
                .find("properties.units_in_meter: found 0, expected how many units are a metre"),
            std::string::npos);
  EXPECT_NE(error(pattern_text(panel, "", R"({"units_in_meter": 0.1})")).find("expected a panel of at most 20 m"),
            std::string::npos);
  EXPECT_NE(error_of_edge(R"({"type": "spline", "params": []})")
                .find("edges[0].curvature.type: found \"spline\", expected \"quadratic\""),
            std::string::npos);
  EXPECT_NE(error_of_edge(R"({"type": "circle", "params": [5, 2, 0]})").find("expected a radius above 0"),
            std::string::npos);
  EXPECT_NE(error_of_edge(R"({"type": "cubic", "params": [[1, 1]]})").find("a list of points, at least 2"),
            std::string::npos);
}

std::string nest(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

TEST_F(Pattern, RefusesWhatIsNestedTooDeeply) {
  const std::string panel = R"("a": {)" + square + ", " + edges("") + '}';
  for (const std::size_t depth : {500U, 100000U}) {
    EXPECT_CONTAINS(error(nest(depth)), "nested more than 100 deep");
    EXPECT_CONTAINS(error(pattern_text(panel, nest(depth))), "nested more than 100 deep");
    EXPECT_CONTAINS(error_of_edge(nest(depth)), "nested more than 100 deep");
  }
  EXPECT_LT(error_of_edge(nest(90)).size(), 400U);
}

TEST_F(Pattern, RefusesLengthsThatNobodyWears) {
  EXPECT_CONTAINS(error_of_edge(R"({"type": "cubic", "params": [[1e9, 1e9], [2e9, 0]]})"), "a panel of at most 20 m");
  EXPECT_CONTAINS(error_of_edge(R"({"type": "circle", "params": [1e300, 0, 1]})"),
                  "a radius above 0 and up to 10000 m");
  EXPECT_CONTAINS(error_of_edge(R"({"type": "cubic", "params": [[1e999, 1]]})"), "number overflow");
  const auto error_text = [&](const std::string& corners, const std::string& more) {
    return error(pattern_text(R"("a": {"vertices": )" + corners + ", " + edges("") + more + '}'));
  };
  EXPECT_CONTAINS(error_text("[[0, 0], [1e-9, 0], [1e-9, 1e-9], [0, 1e-9]]", ""), "at least 1e-05 m apart");
  EXPECT_CONTAINS(error_text("[[0, 0], [0.01, 0], [0.01, 0.01], [0, 0.01]]", ""), "a panel of at least 0.001 m");
  EXPECT_CONTAINS(error_text("[[0, 0], [10, 0], [10, 10], [0, 10]]", R"(, "translation": [1e300, 0, 0])"),
                  "a place at most 100 m from the origin");
}

TEST_F(Pattern, SaysWhatIsWrongInItsOwnWords) {
  for (const std::string text : {"{", "[1e999]", "\xff", "{\"pattern\": 1}"}) {
    EXPECT_NE(error(text), "");
    EXPECT_EQ(error(text).find("exception"), std::string::npos) << error(text);
  }
}

/// Two squares of 20 and 30 cm, one behind the other. The second edge of one is sewn to the fourth of the other.
SewingPattern two_squares() {
  const auto panel = [](const std::string& name, double size_m, double depth_m) {
    PatternPanel made{name, {}};
    const std::vector<Vec2> corners = {{0, 0}, {size_m, 0}, {size_m, size_m}, {0, size_m}};
    for (std::size_t k = 0; k < 4; ++k) {
      made.edges_m.push_back({corners[k], corners[(k + 1) % 4]});
    }
    made.translation_m = {0.0, 0.0, depth_m};
    return made;
  };
  return {{panel("small", 0.2, 0.1), panel("large", 0.3, -0.1)}, {{{0, 1}, {1, 1}}, {{0, 3}, {1, 3}}}};
}

TEST(Cutting, BothSidesOfASeamHaveTheSameNumberOfVerticesAndSpreadTheEase) {
  const CutPieces pieces = cut_pieces(two_squares(), 600);
  ASSERT_EQ(pieces.seams.size(), 2u);
  const Seam& seam = pieces.seams[0];
  for (std::size_t k = 1; k < seam.size(); ++k) {
    const auto step = [&](sim::Index a, sim::Index b) { return glm::distance(pieces.flat_m[a], pieces.flat_m[b]); };
    const double steps = static_cast<double>(seam.size() - 1);
    EXPECT_NEAR(step(seam[k - 1].first, seam[k].first), 0.2 / steps, 1e-6);
    EXPECT_NEAR(step(seam[k - 1].second, seam[k].second), 0.3 / steps, 1e-6);
  }
  // The seam runs upwards on both panels, which stand upright.
  EXPECT_LT(pieces.placed_m[seam.front().first].y, pieces.placed_m[seam.back().first].y);
  EXPECT_LT(pieces.placed_m[seam.front().second].y, pieces.placed_m[seam.back().second].y);
  const auto to_right_m = [&](sim::Index from, sim::Index to) { return pieces.flat_m[to].x - pieces.flat_m[from].x; };
  EXPECT_NEAR(std::abs(to_right_m(seam[0].first, pieces.seams[1][0].first)), 0.2, 1e-6);
  EXPECT_LT(to_right_m(seam[0].first, pieces.seams[1][0].first) * to_right_m(seam[0].second, pieces.seams[1][0].second),
            0.0)
      << "one of them is seen from behind";
}

/// Returns a panel with these corners.
PatternPanel polygon(const std::vector<Vec2>& corners) {
  PatternPanel panel{"panel", {}};
  for (std::size_t k = 0; k < corners.size(); ++k)
    panel.edges_m.push_back({corners[k], corners[(k + 1) % corners.size()]});
  return panel;
}

TEST(Cutting, EdgesAreNeitherFinerNorCoarserThanClothNeeds) {
  const auto count_triangles = [](double side_m, int asked) {
    const SewingPattern square = {{polygon({{0.0, 0.0}, {side_m, 0.0}, {side_m, side_m}, {0.0, side_m}})}, {}};
    return static_cast<double>(cut_pieces(square, asked).triangles.size());
  };
  EXPECT_NEAR(count_triangles(0.05, 4000), 160.0, 60.0) << "a mitten with edges of 6 mm";
  EXPECT_NEAR(count_triangles(2.0, 50), 2566.0, 600.0) << "a tablecloth with edges of 6 cm";
}

TEST(Cutting, CurvesAreCutOffByLessThanHalfAMillimetre) {
  constexpr double radius_m = 0.08, edge_m = 0.02;
  PatternPanel half_disc = polygon({{radius_m, 0.0}, {-radius_m, 0.0}});
  for (int k = 1; k < 200; ++k) {
    const double angle = k * std::numbers::pi / 200.0;
    half_disc.edges_m[0].insert(half_disc.edges_m[0].end() - 1, radius_m * Vec2(std::cos(angle), std::sin(angle)));
  }
  const double area_m2 = 0.5 * std::numbers::pi * radius_m * radius_m;
  const CutPieces pieces = cut_pieces({{half_disc}, {}}, static_cast<int>(area_m2 / (0.433 * edge_m * edge_m)));
  const double middle_m = sim::compute_extent(pieces.placed_m).middle().x;
  const auto is_on_arc = [&](const Vec3& p) {
    return std::abs(glm::length(p - Vec3(middle_m, 0.0, 0.0)) - radius_m) < 1e-4;
  };
  EXPECT_NEAR(static_cast<double>(std::ranges::count_if(pieces.placed_m, is_on_arc)), 18.0, 2.0)
      << "13 are as long as edges";
}

TEST(Cutting, PanelsLieApartInTextureCoordinates) {
  const CutPieces pieces = cut_pieces(two_squares(), 300);
  std::array<sim::Extent, 2> boxes;
  for (std::size_t v = 0; v < pieces.flat_m.size(); ++v) boxes[pieces.panel_of[v]].add({pieces.flat_m[v], 0.0});
  EXPECT_NEAR(boxes[1].lower.x - boxes[0].upper.x, 0.05, 0.01);
}

TEST(Cutting, MakesExactlyAsManyTrianglesAsAreAskedFor) {
  const SewingPattern skirt = read_sewing_pattern(TAUT_ASSETS_FOLDER "/patterns/wardrobe/skirt.json");
  EXPECT_EQ(cut_pieces(skirt, 300, true).triangles.size(), 300u) << "the mesh is one of the last that are tried";
  for (const int triangles : {300, 301, 1028, 5280}) {
    EXPECT_EQ(cut_pieces(two_squares(), triangles, true).triangles.size(), static_cast<std::size_t>(triangles));
  }
  // If every edge is sewn to an edge of another panel, both panels have the same number of edges at their borders.
  SewingPattern closed = two_squares();
  closed.stitches.push_back({{0, 0}, {1, 0}});
  closed.stitches.push_back({{0, 2}, {1, 2}});
  EXPECT_EQ(cut_pieces(closed, 300, true).triangles.size(), 300u);
  EXPECT_THROW(cut_pieces(closed, 301, true), std::invalid_argument);
}

TEST(Cutting, SewsTheWayRoundThatOtherSeamsTellWhereLengthsDoNot) {
  SewingPattern pattern = two_squares();
  // The third seam is equally far from closing in both directions. It joins the upper edges, the one behind shifted
  // by its length.
  pattern.panels[1].translation_m.x = 0.0;
  pattern.stitches.push_back({{0, 2}, {1, 2}});
  for (auto& line : pattern.panels[1].edges_m) {
    for (Vec2& p : line) {
      p *= 2.0 / 3.0;
    }
  }
  pattern.panels[1].edges_m[2] = {{0.2, 0.2}, {0.1, 0.4}, {0.0, 0.2}};
  const CutPieces pieces = cut_pieces(pattern, 600);
  const Seam& seam = pieces.seams[2];
  EXPECT_EQ(pieces.placed_m[seam.front().first].x, pieces.placed_m[seam.front().second].x);
}

TEST(Cutting, SewsPanelsThatAreFarApartTheWayTheirBordersGo) {
  // A hood beside the head and a front before it. The shoulder of the front is nearer to the hood's end for the middle
  // of the front than to its partner.
  PatternPanel front{"front", {}}, hood{"hood", {}};
  const auto outline = [](const std::vector<Vec2>& corners) {
    std::vector<std::vector<Vec2>> edges_m;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      edges_m.push_back({corners[k], corners[(k + 1) % corners.size()]});
    }
    return edges_m;
  };
  front.edges_m = outline({{0.1, 0.0}, {0.0, -0.1}, {0.0, -0.4}, {0.2, -0.4}});
  front.translation_m = {0.0, 0.0, 0.25};
  hood.edges_m = outline({{-0.13, -0.02}, {0.0, 0.02}, {0.0, 0.3}, {-0.1, 0.3}});
  hood.rotation = glm::dmat3(Vec3(0.0, 0.0, -1.0), Vec3(0.0, 1.0, 0.0), Vec3(1.0, 0.0, 0.0));
  hood.translation_m = {0.12, 0.02, -0.02};
  const CutPieces pieces = cut_pieces({{front, hood}, {{{0, 0}, {1, 0}}}}, 300);
  const auto [shoulder, of_hood] = pieces.seams[0].front();
  EXPECT_NEAR(pieces.placed_m[shoulder].x, 0.1, 1e-9);
  EXPECT_NEAR(pieces.placed_m[of_hood].z, -0.02, 1e-9)
      << "its border before the face was taken for that at the shoulder";
}

}  // namespace
}  // namespace taut::app
