// Models that follow a simulation mesh that was fitted to them.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <sstream>

#include "app/base/errors.hpp"
#include "app/caches/frame_sink.hpp"
#include "app/models/mending/model_fitting.hpp"
#include "app/models/mending/tuning.hpp"
#include "app/models/reading/file_mesh.hpp"
#include "app/scene/scene_file.hpp"
#include "garment_shapes.hpp"
#include "loading_shapes.hpp"
#include "sim/mesh/extent.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/surface.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using sim::Vec3;

/// A shirt with a lining that faces inwards, at this distance inside it.
sim::Mesh lined_shirt(double apart_m) {
  sim::Mesh both = test::shirt();
  const sim::Mesh outer = both;
  const std::vector<Vec3> normals = vertex_normals(outer.positions, outer.triangles);
  const auto first = static_cast<sim::Index>(outer.positions.size());
  for (std::size_t v = 0; v < outer.positions.size(); ++v) {
    both.positions.push_back(outer.positions[v] - apart_m * normals[v]);
  }
  for (const sim::Triangle& t : outer.triangles) {
    both.triangles.push_back({t[0] + first, t[2] + first, t[1] + first});
  }
  return both;
}

double max_distance(std::span<const Vec3> a, std::span<const Vec3> b) {
  double farthest_m = a.size() == b.size() ? 0.0 : INFINITY;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
    farthest_m = std::max(farthest_m, glm::distance(a[k], b[k]));
  }
  return farthest_m;
}

struct ModelFitting : testing::Test {
  Scene lined() {
    Scene scene;
    const sim::Mesh model = lined_shirt(0.002);
    vertices = model.positions.size();
    scene.garment.file = folder.write("lined.obj", obj_text(model, model.positions));
    scene.garment.max_triangles = 1500;
    return scene;
  }

  /// A sheet of 0.5 m that is fitted, of two materials. The texture coordinates are those of the drawing plane, turned,
  /// and those of its right half are this far from those of the left.
  Scene printed_sheet(double halves_apart) {
    constexpr int columns = 10;
    const sim::Mesh grid =
        sim::make_grid({.columns = columns + 1, .rows = columns + 1, .width_m = 0.5, .height_m = 0.5});
    std::ostringstream obj;
    for (const Vec3& at : grid.positions) obj << "v " << at.x << ' ' << at.y << ' ' << at.z << '\n';
    for (const double apart : {0.0, halves_apart}) {
      for (const Vec3& at : grid.positions) {
        obj << "vt " << print_cosine * at.x + print_sine * at.y + apart << ' '
            << print_cosine * at.y - print_sine * at.x << '\n';
      }
    }
    for (const bool is_right : {false, true}) {
      obj << "usemtl " << (is_right ? "right" : "left") << '\n';
      for (const sim::Triangle& t : grid.triangles) {
        const auto [a, b, c] = sim::corner_positions(t, grid.positions);
        if ((a.x + b.x + c.x > 0.0) != is_right) continue;
        obj << 'f';
        for (const sim::Index v : t) obj << ' ' << v + 1 << '/' << v + 1 + (is_right ? grid.positions.size() : 0);
        obj << '\n';
      }
    }
    Scene scene;
    scene.garment.file = folder.write("sheet.obj", obj.str());
    scene.garment.up = ModelAxis::y;
    scene.garment.mesh = MeshChoice::fitted;
    scene.garment.max_triangles = 400;
    return scene;
  }

  static constexpr double print_cosine = 0.8, print_sine = 0.6;

  /// Triangles 2 m long and 0.1 micrometres wide. Fitting leaves no mesh of them.
  Scene slivers() {
    sim::Mesh model;
    for (sim::Index k = 0; k < 40; ++k) {
      model.positions.insert(model.positions.end(),
                             {{0.01 * k, 0.0, 0.0}, {0.01 * k + 1.0, 1e-7, 0.0}, {0.01 * k + 2.0, 0.0, 1e-7}});
      model.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    }
    Scene scene;
    scene.garment.file = folder.write("slivers.obj", obj_text(model, model.positions));
    return scene;
  }

  /// Needles that all cross each other at the same place.
  Scene crossing_needles(int count) {
    sim::Mesh model;
    for (int k = 0; k < count; ++k) {
      const double angle = std::numbers::pi * k / count;
      const Vec3 end(std::cos(angle), 0.0, std::sin(angle));
      const auto first = static_cast<sim::Index>(model.positions.size());
      model.positions.insert(model.positions.end(), {-end, end, 0.5 * end + Vec3(0.0, 1e-3, 0.0)});
      model.triangles.push_back({first, first + 1, first + 2});
    }
    Scene scene;
    scene.garment.file = folder.write("needles.obj", obj_text(model, model.positions));
    return scene;
  }

  test::TemporaryFolder folder;
  std::size_t vertices = 0;
};

TEST_F(ModelFitting, OfTwoWallsOneIsSimulatedAndBothFollow) {
  const LoadedGarment loaded = load_garment(lined());
  ASSERT_TRUE(loaded.following);
  EXPECT_EQ(loaded.following->mesh.positions.size(), vertices);
  EXPECT_LE(loaded.garment->mesh.triangles.size(), 1500U);
  EXPECT_GE(loaded.garment->mesh.triangles.size(), 1000U);
  EXPECT_NEAR(sim::surface_area(loaded.garment->mesh), 0.5 * sim::surface_area(loaded.following->mesh),
              0.05 * sim::surface_area(loaded.garment->mesh));
  EXPECT_LT(max_distance(loaded.shown_m(loaded.garment->mesh.positions), loaded.following->mesh.positions), 1e-9);
  EXPECT_CONTAINS(test::remarks(loaded), "is simulated, and the model follows it");
}

TEST_F(ModelFitting, FrontAndBackOfThickClothesStayTogether) {
  for (const sim::Mesh& model : {test::thick(test::shirt()), test::thick(test::strap_dress())}) {
    EXPECT_EQ(fit_mesh(model).sheets, 1U);
  }
}

TEST_F(ModelFitting, AModelThatIsFitIsSimulatedAndOneIsWhereThatIsAskedFor) {
  Scene scene = lined();
  scene.garment.mesh = MeshChoice::model;
  EXPECT_FALSE(load_garment(scene).following);
  const sim::Mesh shirt = test::shirt();
  scene.garment.mesh = MeshChoice::automatic;
  scene.garment.file = folder.write("shirt.obj", obj_text(shirt, shirt.positions));
  EXPECT_FALSE(load_garment(scene).following);
  scene.garment.mesh = MeshChoice::fitted;
  EXPECT_TRUE(load_garment(scene).following);
  scene.garment.subdivisions = 1;
  EXPECT_CONTAINS(test::error_message<InputError>([&] { load_garment(scene); }), "garment.triangles says how fine");
}

TEST_F(ModelFitting, ACoarseModelGetsAFinerMeshAndIsDrawnAsFinely) {
  const sim::Mesh skirt = test::skirt();
  ASSERT_TRUE(is_coarse(skirt));
  Scene scene;
  scene.garment.file = folder.write("skirt.obj", obj_text(skirt, skirt.positions));
  scene.garment.max_triangles = 6000;
  const LoadedGarment loaded = load_garment(scene);
  ASSERT_TRUE(loaded.following);
  EXPECT_GT(loaded.garment->mesh.triangles.size(), 4000U);
  EXPECT_GE(loaded.shown_mesh().triangles.size(), loaded.garment->mesh.triangles.size());
  const WrittenCloth written(loaded);
  EXPECT_EQ(written.vertices(), skirt.positions.size());
  EXPECT_LT(max_distance(written.positions(loaded.shown_m(loaded.garment->mesh.positions)), loaded.file_rest_m), 1e-9);
}

TEST_F(ModelFitting, TheFileIsWrittenWhereTheMeshWent) {
  const LoadedGarment loaded = load_garment(lined());
  const WrittenCloth cloth(loaded);
  EXPECT_EQ(cloth.vertices(), vertices);
  std::vector<Vec3> moved_m = loaded.garment->mesh.positions;
  std::vector<Vec3> expected_m;
  for (const sim::Index vertex : loaded.following->file_vertices.mesh_vertex) {
    expected_m.push_back(loaded.following->mesh.positions[vertex]);
  }
  const auto move = [](const Vec3& p) { return Vec3(p.z, p.y + 2.0, -p.x); };
  std::transform(moved_m.begin(), moved_m.end(), moved_m.begin(), move);
  std::transform(expected_m.begin(), expected_m.end(), expected_m.begin(), move);
  EXPECT_LT(max_distance(cloth.positions(loaded.shown_m(moved_m)), expected_m), 1e-9);
}

TEST_F(ModelFitting, AStartThatWasExportedIsTheSameShape) {
  Scene scene = lined();
  const LoadedGarment loaded = load_garment(scene);
  sim::Simulation simulation = make_simulation(scene, loaded);
  for (int frame = 0; frame < 10; ++frame) {
    simulation.advance_frame();
  }
  scene.garment.start = folder.write("end.obj", WrittenCloth(loaded).obj(loaded.shown_m(simulation.state().current)));
  const LoadedGarment again = load_garment(scene);
  ASSERT_TRUE(again.start_m);
  EXPECT_GT(max_distance(loaded.garment->mesh.positions, *again.start_m), 0.01);
  double sum_m = 0.0;
  for (std::size_t v = 0; v < again.start_m->size(); ++v) {
    sum_m += glm::distance(simulation.state().current[v], (*again.start_m)[v]);
  }
  EXPECT_LT(sum_m / static_cast<double>(again.start_m->size()), 0.003)
      << "folds of the mesh are finer than the model's";
}

TEST_F(ModelFitting, ANumberOfTheFileIsTheNearestVertexOfTheMesh) {
  Scene scene = lined();
  scene.pins = std::vector<PinSelector>{sim::Index{7}};
  const LoadedGarment loaded = load_garment(scene);
  ASSERT_EQ(loaded.pins.size(), 1U);
  const Vec3& in_file = loaded.following->mesh.positions[loaded.following->file_vertices.mesh_vertex[7]];
  EXPECT_LT(glm::distance(loaded.garment->mesh.positions[loaded.pins[0]], in_file), 0.03);
}

TEST_F(ModelFitting, ThreadsRunAlongTheModelsTextureCoordinates) {
  const LoadedGarment loaded = load_garment(printed_sheet(0.0));
  const sim::Mesh& mesh = loaded.garment->mesh;
  ASSERT_EQ(loaded.garment->warps.size(), mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = sim::corner_positions(mesh.triangles[t], mesh.positions);
    const Vec3 along = glm::normalize(b - a);
    const Vec3 across = glm::cross(glm::normalize(glm::cross(b - a, c - a)), along);
    const Vec3 warp = loaded.garment->warps[t].x * along + loaded.garment->warps[t].y * across;
    EXPECT_NEAR(std::abs(glm::dot(warp, Vec3(-print_sine, print_cosine, 0.0))), 1.0, 1e-6) << t;
  }
}

TEST_F(ModelFitting, TheSimulatedMeshIsShownInTheModelsColours) {
  constexpr double apart = 3.0;
  LoadedGarment loaded = load_garment(printed_sheet(apart));
  show_simulated(loaded);
  const sim::Mesh& mesh = loaded.shown_mesh();
  EXPECT_EQ(&mesh, &loaded.garment->mesh);
  EXPECT_EQ(loaded.shown_m(mesh.positions), mesh.positions);
  EXPECT_EQ(WrittenCloth(loaded).positions(mesh.positions), mesh.positions);
  ASSERT_EQ(loaded.colours.corner_uv.size(), 3 * mesh.triangles.size());
  ASSERT_EQ(loaded.colours.material_of_face.size(), mesh.triangles.size());
  std::array<std::size_t, 2> triangles = {0, 0};
  for (std::size_t corner = 0; corner < loaded.colours.corner_uv.size(); ++corner) {
    const std::size_t t = corner / 3;
    const Vec3& at = mesh.positions[mesh.triangles[t][corner % 3]];
    const std::string& material = loaded.colours.materials[loaded.colours.material_of_face[t]].name;
    const bool is_right = material == "right";
    const double print_u = print_cosine * at.x + print_sine * at.y + (is_right ? apart : 0.0);
    // Beyond the middle a triangle has the coordinates of its own piece's border.
    EXPECT_NEAR(loaded.colours.corner_uv[corner].x, print_u, 0.05) << material << ' ' << t;
    EXPECT_NEAR(loaded.colours.corner_uv[corner].y, print_cosine * at.y - print_sine * at.x, 0.05) << t;
    ++triangles[is_right ? 1 : 0];
  }
  EXPECT_GT(std::min(triangles[0], triangles[1]), mesh.triangles.size());
}

TEST_F(ModelFitting, AModelThatIsStretchedTooMuchCannotBeShown) {
  const LoadedGarment loaded = load_garment(printed_sheet(0.0));
  const auto is_shown = [&](double stretch) {
    std::vector<Vec3> shown_m = loaded.following->mesh.positions;
    for (Vec3& place_m : shown_m) place_m *= 1.0 + stretch;
    const sim::Stretch measured = loaded.following->shape_limits->measure_stretch(shown_m);
    return test::error_message<ModelOverstretched>([&] { require_fit_to_show(measured); }).empty();
  };
  EXPECT_TRUE(is_shown(0.9 * mending::max_shown_stretch));
  EXPECT_FALSE(is_shown(1.1 * mending::max_shown_stretch));
}

TEST_F(ModelFitting, WhatCrossesInTooManyPlacesIsNotSimulatedItself) {
  EXPECT_EQ(load_garment(crossing_needles(70)).following, nullptr) << "2415 pairs";
  EXPECT_CONTAINS(test::error_message<InputError>([&] { load_garment(crossing_needles(90)); }),
                  "nor can it be simulated itself: it crosses itself in 4005 places");
}

TEST_F(ModelFitting, SaysThatNoMeshIsLeft) {
  Scene scene = slivers();
  scene.garment.mesh = MeshChoice::fitted;
  EXPECT_CONTAINS(test::error_message<InputError>([&] { load_garment(scene); }), "no mesh can be fitted to it");
  scene.garment.mesh = MeshChoice::automatic;
  EXPECT_EQ(load_garment(scene).following, nullptr);
}

}  // namespace
}  // namespace taut::app
