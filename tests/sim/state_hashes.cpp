// Prints hashes of the states in which a few small simulations end; together they go through every part of the method.

#include <cinttypes>
#include <cstdio>
#include <string>

#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

using namespace taut::sim;

namespace {

Mesh bumpy_sheet(Index columns = 24, Index rows = 17) {
  GridSettings grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.top_centre_m = {0.0, 1.2, 0.0};
  Mesh mesh = make_grid(grid);
  mesh.quads.clear();
  const double bump = 24.0 / columns;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double offset = static_cast<double>((v * 2654435761U) % 1000) / 1000.0 - 0.5;
    mesh.positions[v] += bump * Vec3(0.013 * offset, -0.009 * offset, 0.02 * offset);
  }
  return mesh;
}

Surroundings storm_over_obstacles() {
  Surroundings surroundings;
  surroundings.forces.wind.speed_m_per_s = 7.0;
  surroundings.forces.wind.gust_amplitude = 0.5;
  surroundings.forces.wind.gust_turn = 0.2;
  surroundings.forces.artificial_forces = {{100, {0.0, 0.1, 0.2}}};
  surroundings.bodies = {{.shape = Plane{}, .friction = 0.4},
                         {.shape = Sphere{{0.1, 0.5, -0.3}, 0.25}, .friction = 0.2},
                         {.shape = Capsule{{-0.5, 0.3, -0.4}, {0.5, 0.4, -0.4}, 0.1, 0.05}, .friction = 0.3}};
  surroundings.pin_motion = {{0.05, 0.0, 0.02}, 1.5};
  return surroundings;
}

struct Cloth {
  std::shared_ptr<const Garment> garment;
  std::vector<Index> pins;
};

void print_hash(const char* name, const Cloth& cloth, const SolverMethod& method,
                const Surroundings& surroundings, int frames) {
  SimulationSettings settings;
  settings.solver.method = method;
  Simulation simulation(cloth.garment, cloth.pins, settings, surroundings);
  for (int frame = 0; frame < frames; ++frame) {
    simulation.advance_frame();
  }
  std::printf("%016" PRIx64 " %s\n", hash(simulation.state()), name);
}

void print_bounded(BoundKind bound, const Cloth& square, const Cloth& sheet) {
  const auto print = [bound](const char* name, const Cloth& cloth, const SolverMethod& method,
                             const Surroundings& surroundings, int frames) {
    print_hash((std::string("bounded ") + to_name(bound) + ", " + name).c_str(), cloth, method, surroundings, frames);
  };
  BoundedSettings bounded;
  bounded.bound = bound;
  bounded.max_stretch = 0.02;
  print("9x9 under gravity", square, bounded, {}, 60);
  print("irregular sheet in a storm over obstacles", sheet, bounded, storm_over_obstacles(), 60);
  bounded.contact = true;
  print("same storm with contact", sheet, bounded, storm_over_obstacles(), 60);
  bounded.contact = false;
  bounded.vector_unit = VectorUnit::scalar;
  print("same storm without vectors", sheet, bounded, storm_over_obstacles(), 60);

  bounded.vector_unit = VectorUnit::best;
  const Cloth fine_sheet = {share(make_garment(bumpy_sheet(73, 73))), {0, 72}};
  for (const int threads : {1, 2, 4}) {
    bounded.threads = threads;
    print(("fine sheet, threads: " + std::to_string(threads)).c_str(), fine_sheet, bounded,
          storm_over_obstacles(), 1);
  }
}

}  // namespace

int main() {
  const Cloth square = {share(make_garment(make_grid({}))), {0, 8}};
  MappingSettings opposite;
  opposite.flexural_rule = FlexuralRule::opposite_vertex;
  const Cloth sheet = {share(make_garment(bumpy_sheet())), {0, 23}};
  const Cloth sheet_opposite = {share(make_garment(bumpy_sheet(), opposite)), {0, 23}};

  const StrongSettings strong;
  StrongSettings soft;
  soft.rigidity = {0.1, 0.02};
  const IdealSettings ideal;
  ProvotSettings provot;
  provot.stiffness.structural_n_per_m = 50.0;
  provot.max_stretch = 0.1;

  print_hash("strong, 9x9 under gravity", square, strong, {}, 60);
  print_hash("ideal, 9x9 under gravity", square, ideal, {}, 60);
  print_hash("provot, 9x9 under gravity", square, provot, {}, 60);
  print_hash("strong, irregular sheet in a storm over obstacles", sheet, soft, storm_over_obstacles(), 60);
  print_hash("strong, opposite-vertex rule, same storm", sheet_opposite, soft, storm_over_obstacles(), 60);

  for (const BoundKind bound : all_bound_kinds) {
    print_bounded(bound, square, sheet);
  }

  const SpringStiffness weak = {.structural_n_per_m = 50.0};
  const FastProjectionSettings projection = {.max_strain = 0.01};
  print_hash("vassilev, 9x9 under gravity", square, VassilevSettings{weak, 0.02}, {}, 30);
  print_hash("vassilev, irregular sheet in a storm over obstacles", sheet, VassilevSettings{{}, 0.02},
             storm_over_obstacles(), 6);
  print_hash("fast-projection, 9x9 under gravity", square, projection, {}, 30);
  print_hash("fast-projection, same storm", sheet, projection, storm_over_obstacles(), 6);
  print_hash("implicit, 9x9 under gravity", square, ImplicitSettings{}, {}, 30);
  print_hash("implicit, same storm", sheet, ImplicitSettings{}, storm_over_obstacles(), 6);
}
