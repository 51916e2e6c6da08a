#include <gtest/gtest.h>

#include "app/base/errors.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/hanging/landmarks.hpp"
#include "sim/mesh/grid.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using Selectors = std::vector<PinSelector>;
using Vertices = std::vector<sim::Index>;

// Vertices of the grid:
// 0 1 2
// 3 4 5
struct Pins : testing::Test {
  Pins() : mesh(sim::make_grid(settings)) {}

  Vertices select(const std::optional<Selectors>& pins) const {
    return select_pins(pins, {mesh, landmarks, vertices, &settings});
  }

  sim::GridSettings settings{.columns = 3, .rows = 2};
  sim::Mesh mesh;
  Landmarks landmarks;
  FileVertices vertices{{0, 1, 2, 3, 4, 5}};
};

TEST_F(Pins, NameCornersAndEdgesOfAGrid) {
  EXPECT_EQ(select(Selectors{"top-left", "top-right"}), (Vertices{0, 2}));
  EXPECT_EQ(select(Selectors{"bottom-left", "bottom-right"}), (Vertices{3, 5}));
  EXPECT_EQ(select(Selectors{"top-edge"}), (Vertices{0, 1, 2}));
  EXPECT_EQ(select(Selectors{"bottom-edge"}), (Vertices{3, 4, 5}));
}

TEST_F(Pins, AreTheUpperEdgeOfAGridWhereNoneAreGiven) { EXPECT_EQ(select(std::nullopt), (Vertices{0, 1, 2})); }

TEST_F(Pins, CanBeNone) { EXPECT_TRUE(select(Selectors{}).empty()); }

TEST_F(Pins, CanBeVerticesAndPoints) {
  EXPECT_EQ(select(Selectors{sim::Index{4}, NearestTo{{0.4, -0.9, 0.1}}}), (Vertices{4, 5}));
}

TEST_F(Pins, OfAModelAreItsTopBand) {
  EXPECT_EQ(select_pins(std::nullopt, {mesh, landmarks, vertices}), (Vertices{0, 1, 2}));
}

TEST_F(Pins, RefuseWhatIsNotThere) {
  EXPECT_CONTAINS(test::error_message<InputError>([&] { select(Selectors{sim::Index{6}}); }),
                  "found vertex 6, expected one of the vertices of the file, 0 to 5");
  EXPECT_CONTAINS(test::error_message<InputError>([&] { select(Selectors{"top-lef"}); }), "did you mean 'top-left'?");
}

// A strip of four triangles whose faces name its vertices in another order than the file lists them. Vertices 0 and 8
// belong to no face, though 8 lies at 2. Vertex 7 belongs only to a face without area. Vertex 4 lies at 3 and is
// welded to it.
constexpr const char* strip_obj =
    "v 9 9 9\nv 2 1 0\nv 1 1 0\nv 1 0 0\nv 1 0 0\nv 0 0 0\nv 2 0 0\nv 3 0 0\nv 1 1 0\nv 0 1 0\n"
    "f 6 4 10\nf 4 3 10\nf 5 7 3\nf 7 2 3\nf 6 4 8\n";

struct PinsOfAFile : testing::Test {
  LoadedGarment load(const std::string& name, const std::string& text, const Selectors& pins) const {
    Scene scene;
    scene.garment.file = folder.write(name, text);
    scene.garment.scale = 1.0;
    scene.garment.up = ModelAxis::y;
    scene.pins = pins;
    return load_garment(scene);
  }
  // Position of the vertex with this number in the file.
  sim::Vec3 place_of(const std::string& name, const std::string& text, sim::Index number) const {
    const LoadedGarment loaded = load(name, text, {number});
    return loaded.garment->mesh.positions[loaded.pins.at(0)];
  }

  test::TemporaryFolder folder;
};

TEST_F(PinsOfAFile, AreThoseOfItsOwnNumbers) {
  const sim::Vec3 places[] = {{2, 1, 0}, {1, 1, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}, {2, 0, 0}};
  for (sim::Index i = 0; i < 6; ++i) {
    EXPECT_EQ(place_of("strip.obj", strip_obj, i + 1), places[i]) << i + 1;
  }
  EXPECT_EQ(place_of("strip.obj", strip_obj, 9), sim::Vec3(0, 1, 0));
}

TEST_F(PinsOfAFile, StayWhereTheyAreWhenItIsSubdivided) {
  Scene scene;
  scene.garment.file = folder.write("strip.obj", strip_obj);
  scene.garment.scale = 1.0;
  scene.garment.subdivisions = 2;
  scene.pins = Selectors{sim::Index{9}};
  const LoadedGarment loaded = load_garment(scene);
  EXPECT_EQ(loaded.garment->mesh.positions[loaded.pins.at(0)], sim::Vec3(0, 1, 0));
}

TEST_F(PinsOfAFile, MustBeVerticesThatWereKept) {
  const auto error = [&](sim::Index number) {
    return test::error_message<InputError>([&] { load("strip.obj", strip_obj, {number}); });
  };
  EXPECT_CONTAINS(error(10), "pins.at: found vertex 10, expected one of the vertices of the file, 0 to 9");
  for (const sim::Index dropped : {0U, 7U, 8U}) {
    EXPECT_CONTAINS(error(dropped), "pins.at: vertex " + std::to_string(dropped) + " of the file belongs to no face");
  }
}

TEST_F(PinsOfAFile, CountTheVerticesOfFormatsThatNumberThem) {
  constexpr const char* ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
      "1 1 0\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n3 2 0 3\n";
  constexpr const char* off = "OFF\n4 2 0\n1 1 0\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n3 2 0 3\n";
  const sim::Vec3 places[] = {{1, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (sim::Index i = 0; i < 4; ++i) {
    EXPECT_EQ(place_of("quad.ply", ply, i), places[i]) << i;
    EXPECT_EQ(place_of("quad.off", off, i), places[i]) << i;
  }
}

TEST_F(PinsOfAFile, CountCornersWhereFacesShareNoVertices) {
  constexpr const char* stl =
      "solid quad\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0\nendloop\nendfacet\n"
      "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
      "quad\n";
  EXPECT_EQ(place_of("quad.stl", stl, 4), sim::Vec3(1, 1, 0));
  EXPECT_TRUE(load("quad.stl", stl, {}).file_vertices.are_corners);
  EXPECT_FALSE(load("one.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", {}).file_vertices.are_corners)
      << "a single face shares none with others";
  EXPECT_CONTAINS(test::error_message<InputError>([&] { load("quad.stl", stl, {sim::Index{6}}); }),
                  "expected one of the corners of the file's faces, which share no vertices, 0 to 5");
}

TEST_F(PinsOfAFile, NumberForcesToo) {
  const LoadedGarment loaded = load("strip.obj", strip_obj, {});
  sim::Surroundings surroundings;
  surroundings.forces.artificial_forces = {{.vertex = 1, .force_n = {1, 0, 0}}};
  const auto forces = settle_surroundings(surroundings, loaded, {}).forces.artificial_forces;
  EXPECT_EQ(loaded.garment->mesh.positions[forces.at(0).vertex], sim::Vec3(2, 1, 0));
  surroundings.forces.artificial_forces[0].vertex = 0;
  EXPECT_CONTAINS(test::error_message<InputError>([&] { settle_surroundings(surroundings, loaded, {}); }),
                  "forces.vertex: vertex 0 of the file belongs to no face");
}

// The window holds a vertex of the mesh. A saved scene names it by its number in the file, which any reader finds.
TEST_F(PinsOfAFile, AreFoundAgainFromTheMesh) {
  const LoadedGarment loaded = load("strip.obj", strip_obj, {});
  for (sim::Index v = 0; v < loaded.garment->mesh.positions.size(); ++v) {
    const std::optional<sim::Index> number = loaded.file_vertices.number_of(v);
    ASSERT_TRUE(number.has_value());
    EXPECT_EQ(loaded.file_vertices.find(*number), v);
  }
  EXPECT_FALSE(loaded.file_vertices.number_of(1000).has_value());
}

}  // namespace
}  // namespace taut::app
