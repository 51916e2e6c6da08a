#include "app/bench/entrants.hpp"

#include <fmt/core.h>

#include "app/bench/cases.hpp"
#include "app/bench/engines/bullet_engine.hpp"
#include "app/bench/engines/taut_engine.hpp"

namespace taut::app {
namespace {

struct Division {
  int substeps;
  int iterations;
};

std::string in_words(const Division& division) {
  return fmt::format("{} substep{} x {} iteration{}", division.substeps, division.substeps == 1 ? "" : "s",
                     division.iterations, division.iterations == 1 ? "" : "s");
}

constexpr sim::BoundKind usual = sim::BoundedSettings{}.bound;

std::vector<Entrant> bounded_entrants(const std::vector<double>& bounds, const std::string& name = "bounded",
                                      const std::vector<Setting>& changes = {}, sim::BoundKind held = usual) {
  std::vector<Entrant> entrants;
  for (const double bound : bounds) {
    entrants.push_back({name, fmt::format("{} within {:g} %", name_of(held), 100.0 * bound), bound, held,
                        [=](const GarmentInScene& cloth, const Scene& scene) {
                          return make_taut_engine(cloth,
                                                  with_settings(asked_for(scene, bound, held), changes));
                        }});
  }
  return entrants;
}

struct Ablation {
  std::string name;
  std::vector<Setting> settings;
};

// A part of the bounded solver that can be taken away, and how.
std::vector<Ablation> ablations() {
  return {
      {"no tethers", {{"solver.tethers", "false"}}},
      {"no bending", {{"cloth.bending_rigidity", "0"}}},
      {"no vectors", {{"solver.vector_unit", "scalar"}}},
      {"no softness", {{"cloth.compression_stiffness", "1e6"}}},
  };
}

// The paper to the letter: every spring rigid both ways. One step a frame as the paper has it, and short
// steps with one sweep each, of which it does not speak but which serve it better.
std::vector<Entrant> strong_entrants(bool full) {
  const std::vector<Division> quick = {{1, 50}, {20, 1}, {80, 1}, {160, 1}};
  const std::vector<Division> all = {{1, 10}, {1, 50}, {1, 200}, {1, 800}, {10, 1},  {20, 1},
                                     {40, 1}, {80, 1}, {120, 1}, {160, 1}, {240, 1}, {320, 1}};
  std::vector<Entrant> entrants;
  for (const Division& division : full ? all : quick) {
    const std::vector<Setting> settings = {{"solver.kind", "strong"},
                                           {"solver.substeps", std::to_string(division.substeps)},
                                           {"solver.iterations", std::to_string(division.iterations)},
                                           {"solver.compression", "1.0"},
                                           {"solver.flexural", "1.0"}};
    entrants.push_back(
        {"strong", in_words(division), {}, {}, [settings](const GarmentInScene& cloth, const Scene& scene) {
           return make_taut_engine(cloth, with_settings(scene, settings));
         }});
  }
  return entrants;
}

Entrant bullet_entrant(const Division& division) {
  return {"bullet", in_words(division), {}, {}, [division](const GarmentInScene& cloth, const Scene& scene) {
            return make_bullet_engine(*cloth.garment, cloth.pins, scene.surroundings,
                                      1.0 / scene.simulation.frame_rate_hz,
                                      {division.substeps, division.iterations});
          }};
}

// Two iterations a substep served best or within a tenth of it wherever it was tried: so this series is fine,
// and a few others are there to show it.
std::vector<Entrant> bullet_entrants(bool full) {
  if (bullet_version().empty()) {
    return {};
  }
  const std::vector<Division> quick = {{20, 2}, {40, 2}, {50, 2}, {60, 2}, {90, 1}, {160, 4}};
  const std::vector<Division> all = {{1, 100}, {10, 10}, {10, 2},  {16, 2},  {20, 1}, {20, 2},  {25, 2},
                                     {32, 2},  {40, 2},  {50, 2},  {64, 2},  {80, 2}, {100, 2}, {128, 2},
                                     {160, 2}, {200, 2}, {250, 2}, {320, 2}, {90, 1}, {40, 4},  {160, 4}};
  std::vector<Entrant> entrants;
  for (const Division& division : full ? all : quick) {
    entrants.push_back(bullet_entrant(division));
  }
  return entrants;
}

}  // namespace

std::vector<std::string> engine_names() {
  return {"bounded", "bullet", "strong"};
}

std::vector<Entrant> entrants_of(const std::string& engine, const std::vector<double>& bounds, bool full) {
  if (engine == "bounded") {
    return bounded_entrants(bounds);
  }
  return engine == "strong" ? strong_entrants(full) : bullet_entrants(full);
}

Scene asked_for(Scene scene, double bound, sim::BoundKind held) {
  SolverChoice& solver = scene.simulation.solver;
  solver.kind = sim::SolverKind::bounded;
  solver.substeps = {};
  solver.bounded.max_stretch = bound;
  solver.bounded.bound = held;
  return scene;
}

std::vector<Entrant> ablation_entrants(const std::vector<double>& bounds) {
  std::vector<Entrant> entrants = bounded_entrants(bounds);
  const auto add = [&entrants](const std::vector<Entrant>& more) {
    entrants.insert(entrants.end(), more.begin(), more.end());
  };
  for (const sim::BoundKind kind : sim::all_bound_kinds) {
    if (kind != usual) {
      add(bounded_entrants(bounds, name_of(kind), {}, kind));
    }
  }
  for (const auto& [name, settings] : ablations()) {
    add(bounded_entrants(bounds, name, settings));
  }
  return entrants;
}

}  // namespace taut::app
