// Bending in physical terms, and its levels of detail.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "sheets.hpp"
#include "sim/simulation.hpp"
#include "sim/solvers/bounded/bending.hpp"

namespace taut::sim {
namespace {

using namespace bounded;

TEST(Flexural, FlatShapesAreNotBent) {
  for (const Mesh& mesh : {sheet(7, 1.0), irregular_sheet(12, 1.0)}) {
    const Garment garment = make_garment(mesh);
    const auto elements = flexural_elements(garment);
    EXPECT_GT(20 * elements.size(), 19 * garment.springs.count(SpringKind::flexural));
    for (const FlexuralElement& e : elements) {
      Vec3 deflection(0.0);
      for (std::size_t k = 0; k < 4; ++k) {
        deflection += e.weights[k] * mesh.positions[e.vertices[k]];
      }
      EXPECT_LT(glm::length(deflection), 1e-12);
    }
  }
}

constexpr double rolled_curvature_per_m = 0.5;

std::vector<Vec3> roll(const Mesh& flat, double axis_angle_rad) {
  const double curvature_per_m = rolled_curvature_per_m;
  const Vec3 along(std::cos(axis_angle_rad), std::sin(axis_angle_rad), 0.0);
  const Vec3 across(-along.y, along.x, 0.0);
  std::vector<Vec3> positions;
  for (const Vec3& p : flat.positions) {
    const double angle = glm::dot(p, across) * curvature_per_m;
    positions.push_back(glm::dot(p, along) * along + across * (std::sin(angle) / curvature_per_m) +
                        Vec3(0, 0, (1.0 - std::cos(angle)) / curvature_per_m));
  }
  return positions;
}

/// The bending energy of the sheet rolled to a cylinder, in J: B kappa^2 area / 2.
double rolling_energy_j(const Garment& garment, double rigidity_n_m) {
  double area_m2 = 0.0;
  for (const double m : garment.masses_kg) {
    area_m2 += m / garment.material.areal_density_kg_per_m2;
  }
  return 0.5 * rigidity_n_m * rolled_curvature_per_m * rolled_curvature_per_m * area_m2;
}

/// The bending energy of a sheet rolled to a cylinder, over B kappa^2 area / 2.
double cylinder_energy_ratio(const Mesh& flat, double axis_angle_rad) {
  const Garment garment = make_garment(flat);
  const std::vector<Vec3> positions = roll(flat, axis_angle_rad);
  double energy = 0.0;
  for (const FlexuralElement& e : flexural_elements(garment)) {
    Vec3 deflection(0.0);
    for (std::size_t k = 0; k < 4; ++k) {
      deflection += e.weights[k] * positions[e.vertices[k]];
    }
    energy += 0.5 * e.stiffness_per_rigidity * glm::dot(deflection, deflection);
  }
  return energy / rolling_energy_j(garment, 1.0);
}

TEST(Flexural, ASheetResistsRollingWithItsRigidityForEveryMesh) {
  double sum = 0.0;
  for (const Index count : {9, 17, 33}) {
    EXPECT_NEAR(cylinder_energy_ratio(sheet(count, 1.0), 0.0), 1.0, 0.02) << count;
    for (const double angle : {0.0, 0.4, 0.8, 1.2, 1.6, 2.0, 2.4, 2.8}) {
      const double ratio = cylinder_energy_ratio(irregular_sheet(count, 1.0), angle);
      EXPECT_GT(ratio, 0.4) << count << ' ' << angle;
      EXPECT_LT(ratio, 1.9) << count << ' ' << angle;
      sum += ratio / 24.0;
    }
  }
  EXPECT_NEAR(sum, 1.0, 0.15);
}

TEST(Flexural, LayersOfOtherMaterialsWeighAndBendAsTheseDo) {
  const Mesh one = irregular_sheet(9, 1.0);
  const auto count = static_cast<Index>(one.positions.size());
  Mesh two = one;
  for (const Vec3& p : one.positions) two.positions.push_back(p + Vec3(0, 0, 1));
  for (const auto& [a, b, c] : one.triangles) two.triangles.push_back({count + a, count + b, count + c});
  Material soft, stiff;
  stiff.areal_density_kg_per_m2 = 3.0 * soft.areal_density_kg_per_m2;
  stiff.bending_rigidity_n_m = 10.0 * soft.bending_rigidity_n_m;
  stiff.thickness_m = 2.0 * soft.thickness_m;
  std::vector<std::uint8_t> layer_of(2 * count, 0);
  std::fill(layer_of.begin() + count, layer_of.end(), std::uint8_t{1});
  const Garment layers = with_other_materials(make_garment(two, {}, soft), layer_of, {stiff});
  const Garment alone = make_garment(one, {}, stiff);
  for (Index v = 0; v < count; ++v) EXPECT_DOUBLE_EQ(layers.masses_kg[count + v], alone.masses_kg[v]);
  EXPECT_EQ(layers.material.thickness_m, stiff.thickness_m) << "the thickest is kept apart";
  EXPECT_EQ(min_density_kg_per_m2(layers), soft.areal_density_kg_per_m2);
  double own = 0.0, of_alone = 0.0;
  for (const FlexuralElement& e : flexural_elements(layers)) {
    own += e.vertices[2] < count ? 0.0 : e.stiffness_per_rigidity * soft.bending_rigidity_n_m;
  }
  for (const FlexuralElement& e : flexural_elements(alone)) {
    of_alone += e.stiffness_per_rigidity * stiff.bending_rigidity_n_m;
  }
  EXPECT_NEAR(own, of_alone, 1e-9 * of_alone);
  stiff.tensile_warp_n_per_m = stiff.tensile_weft_n_per_m = stiff.shear_n_per_m = 1000.0;
  EXPECT_THROW(with_other_materials(make_garment(two, {}, soft), layer_of, {stiff}), std::invalid_argument);
}

/// The same ratio from accelerations: -1/2 x . M a, because bending is linear.
double cylinder_energy_ratio(const Garment& garment, Bending& bending, double rigidity_n_m, double axis_angle_rad) {
  const Layout layout = make_layout(garment, make_pins(garment, {}));
  const std::vector<Vec3> positions = roll(garment.mesh, axis_angle_rad);
  Float4Array rows(layout.row_count());
  Float4Array accelerations(layout.row_count());
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    rows[row] = to_float4(positions[layout.vertex_indices[row]]);
  }
  ParallelKernels kernels(kernels_for(VectorUnit::best), 1);
  bending.add_accelerations(rows, kernels, accelerations);
  double energy = 0.0;
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    const Vec3 force = garment.masses_kg[layout.vertex_indices[row]] * to_vec3(accelerations[row]);
    energy -= 0.5 * glm::dot(to_vec3(rows[row]), force);
  }
  return energy / rolling_energy_j(garment, rigidity_n_m);
}

TEST(Bending, WavesTooFastToFollowAreSlowedAndWideFoldsKeepTheirRigidity) {
  constexpr double rigidity_n_m = 1e-4;
  for (const Mesh& mesh : {sheet(49, 1.0), irregular_sheet(49, 1.0)}) {
    const Garment garment = make_garment(mesh);
    const Pins pins = make_pins(garment, {});
    const Layout layout = make_layout(garment, pins);
    Bending whole(garment, pins, layout, rigidity_n_m, 1e9);
    ASSERT_EQ(whole.level_count(), 1u);
    const double allowed_per_s = whole.max_rate_per_s() / 12.0;
    Bending shared(garment, pins, layout, rigidity_n_m, allowed_per_s);
    EXPECT_GE(shared.level_count(), 3u);
    EXPECT_LE(shared.max_rate_per_s(), 5.5 * allowed_per_s);
    double sum = 0.0;
    for (const double angle : {0.2, 0.7, 1.3, 1.9, 2.5}) {
      const double ratio = cylinder_energy_ratio(garment, shared, rigidity_n_m, angle);
      EXPECT_GT(ratio, 0.4) << angle;
      EXPECT_LT(ratio, 1.9) << angle;
      sum += ratio / 5.0;
    }
    EXPECT_NEAR(sum, 1.0, 0.25);
  }
}

/// Returns how far, in m, the free end of a strip hangs down if a third of its length is pinned level.
double droop_m(Mesh mesh, double rigidity_n_m) {
  constexpr double pinned_m = 0.04;
  const double top_m = mesh.positions.front().y;
  const double bottom_m = mesh.positions.back().y;
  std::vector<Index> pinned;
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    if (top_m - mesh.positions[v].y < pinned_m + 1e-6) {
      pinned.push_back(v);
    }
  }
  const double level_m = mesh.positions.front().z;
  Surroundings lying;
  lying.forces.gravity_m_per_s2 = {0.0, 0.0, -9.81};
  lying.forces.air_drag_per_s = 2.0;
  SimulationSettings settings;
  settings.solver.method = BoundedSettings{.max_stretch = 0.01};
  const Material material = {.bending_rigidity_n_m = rigidity_n_m};
  const std::vector<Vec3> flat = mesh.positions;
  Simulation simulation(share(make_garment(std::move(mesh), {}, material)), pinned, settings, lying);
  for (int frame = 0; frame < 360; ++frame) {
    simulation.advance_frame();
  }
  double sum_m = 0.0;
  int count = 0;
  for (Index v = 0; v < flat.size(); ++v) {
    if (flat[v].y - bottom_m < 0.003) {
      sum_m += level_m - simulation.state().current[v].z;
      ++count;
    }
  }
  return sum_m / count;
}

TEST(Bending, TheSameFabricHangsAlikeForEveryMesh) {
  for (const double rigidity_n_m : {2e-5, 5e-5}) {
    std::vector<double> droops_m;
    for (const Index count : {7, 13, 25, 49}) {
      droops_m.push_back(droop_m(sheet(count, 0.12), rigidity_n_m));
    }
    const auto [least, most] = std::minmax_element(droops_m.begin(), droops_m.end());
    EXPECT_LT(*most, 1.13 * *least) << rigidity_n_m;
    EXPECT_LT(*most, 0.079) << "stiff enough not to hang straight down";
  }
  EXPECT_LT(droop_m(sheet(13, 0.12), 2e-4), 0.8 * droop_m(sheet(13, 0.12), 5e-5));
}

/// Returns a strip's bending length, for triangles of this edge length, divided by its fabric's bending length, (B /
/// weight)^(1/3). The cantilever test defines it (Peirce 1930): a length l that is clamped at one end and hangs down by
/// the angle a has the bending length l (cos(a / 2) / (8 tan a))^(1/3).
double bending_length_ratio(const Material& material, double edge_m) {
  const double weight_n_per_m2 = material.areal_density_kg_per_m2 * 9.81;
  const double theory_m = std::cbrt(material.bending_rigidity_n_m / weight_n_per_m2);
  const double rows_clamped = std::max(3.0, std::round(0.01 / edge_m));
  const double rows = std::round(2.0 * theory_m / edge_m);
  Mesh mesh;
  {
    GridSettings grid;
    grid.plane = GridPlane::horizontal;
    grid.columns = static_cast<Index>(std::lround(0.03 / edge_m)) + 1;
    grid.rows = static_cast<Index>(rows_clamped + rows) + 1;
    grid.width_m = edge_m * (grid.columns - 1);
    grid.height_m = edge_m * (grid.rows - 1);
    mesh = make_grid(grid);
  }
  const double clamp_m = mesh.positions.front().z + edge_m * rows_clamped;
  std::vector<Index> clamped;
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v].z < clamp_m + 0.1 * edge_m) {
      clamped.push_back(v);
    }
  }
  Surroundings air;
  air.forces.air_drag_per_s = 3.0;
  SimulationSettings settings;
  settings.solver.method = BoundedSettings{.max_stretch = 0.01};
  const Vec3 flat_end = mesh.positions.back();
  Simulation simulation(share(make_garment(std::move(mesh), {}, material)), clamped, settings, air);
  for (int frame = 0; frame < 240; ++frame) {
    simulation.advance_frame();
  }
  const Vec3 end = simulation.state().current.back();
  const double angle = std::atan2(flat_end.y - end.y, end.z - clamp_m);
  return edge_m * rows * std::cbrt(std::cos(0.5 * angle) / (8.0 * std::tan(angle))) / theory_m;
}

TEST(Bending, AStiffFabricStandsOutAsFarAsItsBendingLengthSays) {
  for (const double rigidity_n_m : {1e-5, 1e-4, 1e-3}) {
    for (const double edge_m : {0.01, 0.005, 0.0025}) {
      const Material material = {.areal_density_kg_per_m2 = 0.25, .bending_rigidity_n_m = rigidity_n_m};
      EXPECT_NEAR(bending_length_ratio(material, edge_m), 1.0, 0.1) << rigidity_n_m << ' ' << edge_m;
    }
  }
}

}  // namespace
}  // namespace taut::sim
