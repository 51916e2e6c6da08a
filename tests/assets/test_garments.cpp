// Checks the files of the committed garments, whatever program made them.

#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "app/verify/crossing_pairs.hpp"
#include "garment_file.hpp"
#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/extent.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::test {
namespace {

using sim::Edge;
using sim::Index;
using sim::Triangle;
using sim::Vec3;

const std::filesystem::path assets = TAUT_ASSETS_DIR;
constexpr double metres_per_uv = 1.5;

/// A pattern file: the outlines of its pieces, in mm. Each outline goes around its piece.
struct PatternFile {
  explicit PatternFile(const std::string& name)
      : table(toml::parse_file((assets / "patterns/tshirt" / (name + ".toml")).string())) {}

  std::vector<glm::dvec2> line(const std::string& piece, const std::string& side) const {
    std::vector<glm::dvec2> points;
    for (const toml::node& point : *table[piece][side]["points_mm"].as_array()) {
      points.emplace_back(point.as_array()->at(0).value<double>().value(),
                          point.as_array()->at(1).value<double>().value());
    }
    return points;
  }
  double length_m(const std::string& piece, const std::string& side) const {
    const std::vector<glm::dvec2> points = line(piece, side);
    double length_mm = 0.0;
    for (std::size_t k = 1; k < points.size(); ++k) length_mm += glm::distance(points[k - 1], points[k]);
    return 1e-3 * length_mm;
  }
  double area_m2(const std::string& piece, const std::vector<const char*>& sides) const {
    std::vector<glm::dvec2> outline;
    for (const char* side : sides) {
      for (const glm::dvec2& point : line(piece, side)) outline.push_back(1e-3 * point);
    }
    double doubled_m2 = 0.0;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const glm::dvec2 &a = outline[k], &b = outline[(k + 1) % outline.size()];
      doubled_m2 += a.x * b.y - a.y * b.x;
    }
    return 0.5 * std::abs(doubled_m2);
  }
  /// Area of the whole garment: the front and the back are stored as halves, and there are two sleeves.
  double area_m2() const {
    const std::vector<const char*> half = {"hem", "side_seam", "armhole", "shoulder_seam", "neckline"};
    return 2.0 * (area_m2("front", half) + area_m2("back", half) +
                  area_m2("sleeve", {"cuff", "underarm_front", "cap_front", "cap_back", "underarm_back"}));
  }

  toml::table table;
};

/// Edge lengths and angles of a mesh.
struct MeshQuality {
  explicit MeshQuality(const sim::Mesh& mesh) {
    const sim::Adjacency adjacency = sim::make_adjacency(mesh);
    double sum_m = 0.0;
    for (const auto& [a, b] : adjacency.edges) {
      const double length_m = glm::distance(mesh.positions[a], mesh.positions[b]);
      min_edge_m = std::min(min_edge_m, length_m);
      max_edge_m = std::max(max_edge_m, length_m);
      sum_m += length_m;
    }
    mean_edge_m = sum_m / static_cast<double>(adjacency.edges.size());
    for (const Triangle& t : mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& at = mesh.positions[t[k]];
        const Vec3 a = mesh.positions[t[(k + 1) % 3]] - at, b = mesh.positions[t[(k + 2) % 3]] - at;
        const double angle_deg = glm::degrees(std::acos(glm::dot(a, b) / (glm::length(a) * glm::length(b))));
        min_angle_deg = std::min(min_angle_deg, angle_deg);
      }
    }
  }

  double min_angle_deg = 180.0;
  double min_edge_m = 1e9, mean_edge_m = 0.0, max_edge_m = 0.0;
};

std::size_t count_crossings(const sim::Mesh& mesh) {
  return app::crossing_pairs({mesh.positions, mesh.triangles}).size();
}

/// Volume between the surface and its middle, by signed tetrahedra. The middle stands in for the missing caps.
double volume_m3(const sim::Mesh& mesh) {
  Vec3 middle(0.0);
  for (const Vec3& p : mesh.positions) middle += p / static_cast<double>(mesh.positions.size());
  double sextuple = 0.0;
  for (const Triangle& t : mesh.triangles) {
    sextuple += glm::dot(mesh.positions[t[0]] - middle, sim::doubled_area_vector(mesh.positions, t));
  }
  return sextuple / 6.0;
}

void expect_one_surface_with_four_openings(const sim::Mesh& mesh) {
  const sim::Topology topology = sim::measure_topology(mesh, sim::make_adjacency(mesh));
  EXPECT_EQ(topology.components, 1U);
  EXPECT_EQ(topology.boundary_loops, 4U);
  EXPECT_EQ(topology.euler_characteristic, -2);
  EXPECT_EQ(topology.non_manifold_edges, 0U);
  EXPECT_EQ(topology.non_manifold_vertices, 0U);
  EXPECT_EQ(topology.misoriented_edges, 0U);
}

/// Flat pieces of a garment: its triangles, and the texture coordinates of their corners.
struct FlatPieces {
  explicit FlatPieces(const std::string& name)
      : mesh(read_obj(assets / "garments" / (name + ".obj"))),
        adjacency(sim::make_adjacency(mesh)),
        corner_uv(read_corner_uv(assets / "garments" / (name + ".obj"))) {}

  const glm::vec2& place(Index triangle, Index vertex) const {
    const Triangle& t = mesh.triangles[triangle];
    return corner_uv.at(3 * triangle + (t[1] == vertex ? 1 : t[2] == vertex ? 2 : 0));
  }
  double area_m2(Index triangle) const {
    const glm::dvec2 a(corner_uv[3 * triangle]), b(corner_uv[3 * triangle + 1]), c(corner_uv[3 * triangle + 2]);
    return 0.5 * metres_per_uv * metres_per_uv * ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
  }
  /// Sewn edges: the texture coordinates of their ends differ between the two triangles.
  std::vector<Edge> seams() const {
    std::vector<Edge> edges;
    for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
      const auto pair = adjacency.edge_triangles[e];
      const auto [a, b] = adjacency.edges[e];
      if (pair.size() == 2 && (place(pair[0], a) != place(pair[1], a) || place(pair[0], b) != place(pair[1], b))) {
        edges.push_back(adjacency.edges[e]);
      }
    }
    return edges;
  }

  sim::Mesh mesh;
  sim::Adjacency adjacency;
  std::vector<glm::vec2> corner_uv;
};

class Texture : public testing::TestWithParam<const char*> {
 protected:
  FlatPieces pieces{std::string("tshirt_") + GetParam()};
};

TEST_P(Texture, ShowsThePiecesUprightAndToScale) {
  ASSERT_EQ(pieces.corner_uv.size(), 3 * pieces.mesh.triangles.size());
  double flat_m2 = 0.0;
  for (Index t = 0; t < pieces.mesh.triangles.size(); ++t) {
    const double area_m2 = 0.5 * glm::length(sim::doubled_area_vector(pieces.mesh.positions, pieces.mesh.triangles[t]));
    EXPECT_NEAR(pieces.area_m2(t) / area_m2, 1.0, 0.06) << "triangle " << t;
    flat_m2 += pieces.area_m2(t);
  }
  EXPECT_NEAR(flat_m2 / sim::surface_area(pieces.mesh), 1.0, 0.01);
  for (std::size_t c = 0; c < pieces.corner_uv.size(); ++c) {
    const glm::vec2& uv = pieces.corner_uv[c];
    EXPECT_TRUE(uv.x > 0.0F && uv.x < 1.0F && uv.y > 0.0F && uv.y < 1.0F);
    // The texture shows the front as seen from in front: the wearer's left is on the right, and up is up.
    const Vec3& p = pieces.mesh.positions[pieces.mesh.triangles[c / 3][c % 3]];
    if (uv.x < 0.45F && uv.y > 0.55F && std::abs(p.x) < 0.1) {
      EXPECT_NEAR(p.x, metres_per_uv * (static_cast<double>(uv.x) - 0.25), 0.05);
      if (uv.y < 0.9F) {
        EXPECT_GT(p.z, 0.0);
      }
    }
  }
}

// The seams of each side: the armhole, the shoulder seam from it to the neck, the side seam to the hem and the
// underarm seam to the cuff.
TEST_P(Texture, IsCutAtTheSeamsAlone) {
  const std::vector<Edge> seams = pieces.seams();
  std::map<Index, std::vector<Index>> ends;
  sim::Groups groups(pieces.mesh.positions.size());
  for (const auto& [a, b] : seams) {
    ends[a].push_back(b);
    ends[b].push_back(a);
    groups.join(a, b);
  }
  std::set<Index> sides;
  std::size_t loose = 0;
  for (const auto& [vertex, others] : ends) {
    sides.insert(groups.find(vertex));
    loose += others.size() == 1 ? 1 : 0;
  }
  EXPECT_EQ(sides.size(), 2U);
  EXPECT_EQ(loose, 6U);
  EXPECT_EQ(seams.size(), ends.size()) << "one closed line on each side";
  const auto landmarks =
      read_landmarks(assets / "garments" / (std::string("tshirt_") + GetParam() + ".landmarks.toml"));
  for (const char* name : {"left_shoulder_seam", "right_shoulder_seam", "left_side_seam", "right_side_seam"}) {
    const std::vector<Index>& walk = landmarks.at(name);
    for (std::size_t i = 1; i < walk.size(); ++i) {
      EXPECT_TRUE(std::binary_search(seams.begin(), seams.end(),
                                     Edge{std::min(walk[i - 1], walk[i]), std::max(walk[i - 1], walk[i])}))
          << name;
    }
  }
}

/// Name of the piece that shows this texture coordinate.
std::string piece_at(const glm::vec2& uv) {
  return uv.y > 0.42F ? (uv.x < 0.5F ? "front" : "back") : uv.x < 0.5F ? "left_sleeve" : "right_sleeve";
}

TEST_P(Texture, HasAllSeamsAsLongAsDrafted) {
  const double middle_m = sim::compute_extent(pieces.mesh.positions).upper.y - 0.15;
  std::map<std::string, double> lengths_m;
  for (std::size_t e = 0; e < pieces.adjacency.edges.size(); ++e) {
    const auto [a, b] = pieces.adjacency.edges[e];
    const auto pair = pieces.adjacency.edge_triangles[e];
    if (pair.size() != 2) continue;
    for (const auto& [own, other] : {std::pair(pair[0], pair[1]), std::pair(pair[1], pair[0])}) {
      const glm::dvec2 from(pieces.place(own, a)), to(pieces.place(own, b)), beyond(pieces.place(other, a));
      if (from == beyond && to == glm::dvec2(pieces.place(other, b))) continue;
      const std::string piece = piece_at(from), next = piece_at(beyond);
      // Seams between front and back: shoulder seams are above the armholes.
      const bool is_side = pieces.mesh.positions[a].y < middle_m;
      const bool is_left = pieces.mesh.positions[a].x > 0.0;
      const bool is_sleeve = piece != "front" && piece != "back";
      const bool is_beside_sleeve = next != "front" && next != "back";
      const std::string name = is_sleeve && is_beside_sleeve ? piece + ", underarm"
                               : is_sleeve                   ? piece + ", cap at " + next
                               : is_beside_sleeve
                                   ? piece + ", armhole, " + next
                                   : piece + (is_side ? ", side, " : ", shoulder, ") + (is_left ? "left" : "right");
      lengths_m[name] += metres_per_uv * glm::distance(from, to);
    }
  }
  const PatternFile pattern(std::string(GetParam()).starts_with("female") ? "teagan_" + std::string(GetParam())
                                                                          : "teagan");
  std::map<std::string, double> drafted_m;
  for (const std::string side : {"left", "right"}) {
    for (const std::string piece : {"front", "back"}) {
      drafted_m[piece + ", side, " + side] = pattern.length_m(piece, "side_seam");
      drafted_m[piece + ", shoulder, " + side] = pattern.length_m(piece, "shoulder_seam");
      drafted_m[piece + ", armhole, " + side + "_sleeve"] = pattern.length_m(piece, "armhole");
      drafted_m[side + "_sleeve, cap at " + piece] = pattern.length_m("sleeve", "cap_" + piece);
    }
    drafted_m[side + "_sleeve, underarm"] =
        pattern.length_m("sleeve", "underarm_front") + pattern.length_m("sleeve", "underarm_back");
  }
  ASSERT_EQ(lengths_m.size(), drafted_m.size());
  for (const auto& [seam, length_m] : drafted_m) EXPECT_NEAR(lengths_m[seam], length_m, 0.0005) << seam;
}

INSTANTIATE_TEST_SUITE_P(TShirt, Texture, testing::Values("10600", "5280", "1028", "female_34", "female_42"),
                         [](const auto& size) { return std::string(size.param); });

class Garment : public testing::TestWithParam<std::size_t> {
 protected:
  Garment() {
    const std::string name = "tshirt_" + std::to_string(GetParam());
    mesh = read_obj(assets / "garments" / (name + ".obj"));
    landmarks = read_landmarks(assets / "garments" / (name + ".landmarks.toml"));
    adjacency = sim::make_adjacency(mesh);
  }

  const std::vector<Index>& landmark(const std::string& name) const { return landmarks.at(name); }

  const Vec3& at(Index vertex) const { return mesh.positions.at(vertex); }

  /// Number of triangles at the edge between two vertices; 0 if there is no edge.
  std::size_t triangles_between(Index a, Index b) const {
    const Edge edge = {std::min(a, b), std::max(a, b)};
    const auto found = std::lower_bound(adjacency.edges.begin(), adjacency.edges.end(), edge);
    if (found == adjacency.edges.end() || *found != edge) {
      return 0;
    }
    return adjacency.edge_triangles[static_cast<std::size_t>(found - adjacency.edges.begin())].size();
  }

  /// Requires that every step of the walk is an edge with this number of triangles.
  void expect_walk(const std::string& name, bool is_loop, std::size_t triangles) const {
    const std::vector<Index>& walk = landmark(name);
    ASSERT_GE(walk.size(), 3U) << name;
    for (std::size_t i = is_loop ? 0 : 1; i < walk.size(); ++i) {
      const Index from = walk[i == 0 ? walk.size() - 1 : i - 1];
      ASSERT_EQ(triangles_between(from, walk[i]), triangles) << name << ", step " << i;
    }
  }

  double vector_length(const std::string& name, bool is_loop) const {
    const std::vector<Index>& walk = landmark(name);
    double length_m = is_loop ? glm::length(at(walk.front()) - at(walk.back())) : 0.0;
    for (std::size_t i = 1; i < walk.size(); ++i) {
      length_m += glm::length(at(walk[i]) - at(walk[i - 1]));
    }
    return length_m;
  }

  Vec3 mean_position(const std::string& name) const {
    Vec3 sum(0.0);
    for (const Index v : landmark(name)) {
      sum += at(v);
    }
    return sum / static_cast<double>(landmark(name).size());
  }

  sim::Mesh mesh;
  sim::Adjacency adjacency;
  std::map<std::string, std::vector<Index>> landmarks;
};

TEST_P(Garment, HasExactlyTheTrianglesOfItsName) { EXPECT_EQ(mesh.triangles.size(), GetParam()); }

TEST_P(Garment, IsOneOrientedSurfaceWithFourOpenings) { expect_one_surface_with_four_openings(mesh); }

TEST_P(Garment, NeedsNoRepair) {
  const sim::MeshReport report = sim::weld_and_validate(mesh).report;
  EXPECT_EQ(report.welded_vertices, 0U);
  EXPECT_EQ(report.unused_vertices, 0U);
  EXPECT_EQ(report.degenerate_triangles, 0U);
  EXPECT_EQ(report.duplicate_triangles, 0U);
}

TEST_P(Garment, HasTheOutsideOutside) {
  EXPECT_GT(volume_m3(mesh), 0.03);
  // Cloth faces forwards on the chest and backwards on the back.
  for (const Triangle& t : mesh.triangles) {
    const Vec3 centre = (at(t[0]) + at(t[1]) + at(t[2])) / 3.0;
    if (std::abs(centre.x) < 0.1 && std::abs(centre.y - 1.3) < 0.1) {
      EXPECT_GT(sim::doubled_area_vector(mesh.positions, t).z * centre.z, 0.0);
    }
  }
}

TEST_P(Garment, HasNoNeedles) { EXPECT_GE(MeshQuality(mesh).min_angle_deg, 10.0); }

TEST_P(Garment, DoesNotPassThroughItself) { EXPECT_EQ(count_crossings(mesh), 0U); }

TEST_P(Garment, HasEvenEdges) {
  const MeshQuality quality(mesh);
  // A coarse mesh needs short edges along curved seams to keep their drafted length.
  EXPECT_GT(quality.min_edge_m, (GetParam() == 1028 ? 0.2 : 0.4) * quality.mean_edge_m);
  EXPECT_LT(quality.max_edge_m, 1.8 * quality.mean_edge_m);
}

TEST_P(Garment, IsIrregular) {
  // Nearly every vertex of a regular grid has six edges.
  std::size_t other_than_six = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    other_than_six += adjacency.vertex_edges[v].size() != 6 ? 1 : 0;
  }
  EXPECT_GT(static_cast<double>(other_than_six), 0.25 * static_cast<double>(mesh.positions.size()));
}

TEST_P(Garment, HasTheAreaOfItsPattern) {
  const double flat_area_m2 = PatternFile("teagan").area_m2();
  EXPECT_NEAR(sim::surface_area(mesh), flat_area_m2, 0.01 * flat_area_m2);
}

TEST_P(Garment, StandsAtWearingHeightAndFacesForwards) {
  for (const Vec3& p : mesh.positions) {
    EXPECT_GT(p.y, 0.90);
    EXPECT_LT(p.y, 1.70);
    EXPECT_LT(std::abs(p.x), 0.45);
    EXPECT_LT(std::abs(p.z), 0.22);
  }
  EXPECT_GT(mean_position("front_neckline").z, 0.01);
  EXPECT_LT(mean_position("back_neckline").z, -0.02);
  EXPECT_GT(mean_position("left_cuff").x, 0.2);
  EXPECT_LT(mean_position("right_cuff").x, -0.2);
  EXPECT_LT(mean_position("hem").y, 1.03);
}

TEST_P(Garment, HasContiguousSeams) {
  for (const char* seam : {"left_shoulder_seam", "right_shoulder_seam", "left_side_seam", "right_side_seam"}) {
    expect_walk(seam, false, 2);
  }
}

TEST_P(Garment, HasItsBordersNamed) {
  std::size_t named = 0;
  for (const char* border : {"hem", "left_cuff", "right_cuff"}) {
    expect_walk(border, true, 1);
    named += landmark(border).size();
  }
  for (const char* border : {"front_neckline", "back_neckline"}) {
    expect_walk(border, false, 1);
    named += landmark(border).size() - 1;
  }
  EXPECT_EQ(named, sim::measure_topology(mesh, adjacency).boundary_edges);
}

TEST_P(Garment, HasSeamsThatMeet) {
  // Shoulder seams end where the front and back necklines meet. Side seams begin at the hem.
  EXPECT_EQ(landmark("left_shoulder_seam").back(), landmark("front_neckline").front());
  EXPECT_EQ(landmark("left_shoulder_seam").back(), landmark("back_neckline").back());
  EXPECT_EQ(landmark("right_shoulder_seam").back(), landmark("front_neckline").back());
  EXPECT_EQ(landmark("right_shoulder_seam").back(), landmark("back_neckline").front());
  for (const char* seam : {"left_side_seam", "right_side_seam"}) {
    const std::vector<Index>& hem = landmark("hem");
    EXPECT_NE(std::find(hem.begin(), hem.end(), landmark(seam).front()), hem.end()) << seam;
  }
}

TEST_P(Garment, HasSeamsAsLongAsThePattern) {
  // Lengths of the pattern, in metres. Coarse edges cut the corners of curved borders.
  for (const char* side : {"left_", "right_"}) {
    EXPECT_NEAR(vector_length(std::string(side) + "shoulder_seam", false), 0.10716, 0.0005);
    EXPECT_NEAR(vector_length(std::string(side) + "side_seam", false), 0.43626, 0.0005);
    EXPECT_NEAR(vector_length(std::string(side) + "cuff", true), 0.43096, 0.008);
  }
  EXPECT_NEAR(vector_length("hem", true), 1.04312, 0.02);
  EXPECT_NEAR(vector_length("front_neckline", false), 0.35938, 0.007);
  EXPECT_NEAR(vector_length("back_neckline", false), 0.27958, 0.007);
}

TEST_P(Garment, IsAboutSymmetrical) {
  const auto mirrored = [](const Vec3& p) { return Vec3(-p.x, p.y, p.z); };
  for (const char* seam : {"shoulder_seam", "side_seam"}) {
    const std::vector<Index>& left = landmark(std::string("left_") + seam);
    const std::vector<Index>& right = landmark(std::string("right_") + seam);
    EXPECT_EQ(left.size(), right.size()) << seam;
    EXPECT_LT(glm::length(at(left.front()) - mirrored(at(right.front()))), 0.02) << seam;
    EXPECT_LT(glm::length(at(left.back()) - mirrored(at(right.back()))), 0.02) << seam;
  }
  EXPECT_LT(glm::length(mean_position("left_cuff") - mirrored(mean_position("right_cuff"))), 0.02);
}

class OtherSize : public testing::TestWithParam<const char*> {};

TEST_P(OtherSize, IsAsSoundAsTheFirst) {
  const std::string wearer = GetParam();
  const sim::Mesh mesh = read_obj(assets / "garments" / ("tshirt_" + wearer + ".obj"));
  const auto landmarks = read_landmarks(assets / "garments" / ("tshirt_" + wearer + ".landmarks.toml"));
  const PatternFile pattern("teagan_" + wearer);
  EXPECT_EQ(mesh.triangles.size(), 5280U);
  expect_one_surface_with_four_openings(mesh);
  EXPECT_EQ(count_crossings(mesh), 0U);
  EXPECT_GT(volume_m3(mesh), 0.03);
  EXPECT_GE(MeshQuality(mesh).min_angle_deg, 10.0);
  EXPECT_NEAR(sim::surface_area(mesh) / pattern.area_m2(), 1.0, 0.01);
  for (const char* line : {"left_shoulder_seam", "right_shoulder_seam", "back_neckline", "front_neckline", "hem",
                           "left_cuff", "right_cuff", "left_side_seam", "right_side_seam"}) {
    EXPECT_TRUE(landmarks.contains(line)) << line;
  }
  for (const Index v : landmarks.at("left_shoulder_seam")) {
    EXPECT_NEAR(mesh.positions.at(v).y, pattern.table["wearer"]["neck_point_height_m"].value<double>().value(), 0.06)
        << "at the wearer's height";
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, OtherSize, testing::Values("female_34", "female_42"),
                         [](const auto& size) { return std::string(size.param); });

INSTANTIATE_TEST_SUITE_P(TShirt, Garment, testing::Values(10600, 5280, 1028),
                         [](const auto& triangles) { return std::to_string(triangles.param); });

}  // namespace
}  // namespace taut::test
