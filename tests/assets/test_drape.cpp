// One shirt at four mesh resolutions: the same fabric hangs alike on all of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "garment_file.hpp"
#include "sim/simulation.hpp"

namespace taut::test {
namespace {

const std::filesystem::path assets = TAUT_ASSETS_DIR;

/// Measures of a shape over its surface, which do not depend on the mesh.
struct Shape {
  double mean_height_m = 0.0;
  double min_height_m = 0.0;
  double width_m = 0.0;  ///< standard deviations of the positions along x, y and z
  double height_m = 0.0;
  double depth_m = 0.0;
};

Shape make_shape(const sim::Garment& garment, std::span<const sim::Vec3> positions) {
  sim::Vec3 mean(0.0);
  double mass_kg = 0.0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    mean += garment.masses_kg[v] * positions[v];
    mass_kg += garment.masses_kg[v];
  }
  mean /= mass_kg;
  sim::Vec3 squares(0.0);
  double min_height_m = mean.y;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    squares += garment.masses_kg[v] * (positions[v] - mean) * (positions[v] - mean);
    min_height_m = std::min(min_height_m, positions[v].y);
  }
  squares /= mass_kg;
  return {mean.y, min_height_m, std::sqrt(squares.x), std::sqrt(squares.y), std::sqrt(squares.z)};
}

Shape hung(const std::string& triangles, sim::BoundKind bound, double max_stretch) {
  const std::filesystem::path garments = assets / "garments";
  const sim::Mesh mesh = read_obj(garments / ("tshirt_" + triangles + ".obj"));
  const auto landmarks = read_landmarks(garments / ("tshirt_" + triangles + ".landmarks.toml"));
  std::set<sim::Index> pins;
  for (const char* const seam : {"left_shoulder_seam", "right_shoulder_seam", "back_neckline"}) {
    pins.insert(landmarks.at(seam).begin(), landmarks.at(seam).end());
  }
  const sim::Garment garment = sim::make_garment(mesh);
  sim::SimulationSettings settings;
  settings.solver.method = sim::BoundedSettings{.bound = bound, .max_stretch = max_stretch};
  sim::Surroundings surroundings;
  surroundings.forces.air_drag_per_s = 2.0;
  sim::Simulation simulation(sim::share(garment), {pins.begin(), pins.end()}, settings, surroundings);
  for (int frame = 0; frame < 360; ++frame) {
    simulation.advance_frame();
  }
  return make_shape(garment, simulation.state().current);
}

/// Tolerances between a model and the finest one: height_m for heights, others as fractions of the extents.
struct Tolerance {
  std::string triangles;
  double height_m;
  double width, height, depth;
};

// Triangles that hardly stretch lock where cloth curves both ways. With edges of 4 cm, front and back stay further
// apart than with finer ones.
void expect_alike(sim::BoundKind bound, double max_stretch) {
  const Shape fine = hung("10600", bound, max_stretch);
  for (const auto& [triangles, height_m, width, height, depth] : {Tolerance{"5280", 0.004, 0.05, 0.01, 0.115},
                                                                  {"2640", 0.010, 0.05, 0.02, 0.18},
                                                                  {"1028", 0.016, 0.11, 0.03, 0.9}}) {
    const Shape coarse = hung(triangles, bound, max_stretch);
    EXPECT_NEAR(coarse.mean_height_m, fine.mean_height_m, height_m) << triangles;
    EXPECT_NEAR(coarse.min_height_m, fine.min_height_m, height_m) << triangles;
    EXPECT_NEAR(coarse.width_m, fine.width_m, width * fine.width_m) << triangles;
    EXPECT_NEAR(coarse.height_m, fine.height_m, height * fine.height_m) << triangles;
    EXPECT_NEAR(coarse.depth_m, fine.depth_m, depth * fine.depth_m) << triangles;
  }
}

TEST(Drape, OneFabricHangsAlikeOnAllModels) {
  for (const sim::BoundKind bound : sim::all_bound_kinds) {
    for (const double max_stretch : {0.05, 0.01}) {
      expect_alike(bound, max_stretch);
    }
  }
}

TEST(Drape, BothKindsOfBoundsHangAlike) {
  const Shape springs = hung("10600", sim::BoundKind::springs, 0.01);
  const Shape surface = hung("10600", sim::BoundKind::surface, 0.01);
  EXPECT_NEAR(surface.mean_height_m, springs.mean_height_m, 0.005);
  EXPECT_NEAR(surface.width_m, springs.width_m, 0.05 * springs.width_m);
  EXPECT_NEAR(surface.height_m, springs.height_m, 0.01 * springs.height_m);
  EXPECT_NEAR(surface.depth_m, springs.depth_m, 0.05 * springs.depth_m);
}

}  // namespace
}  // namespace taut::test
