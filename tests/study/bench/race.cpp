#include "race.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "app/base/errors.hpp"
#include "app/base/progress.hpp"
#include "app/base/words.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/scene/scene_format.hpp"
#include "sim/simulation.hpp"

namespace taut::app {
namespace {

using Settings = std::vector<std::string>;

Scene with_settings(Scene scene, const Settings& settings) {
  std::vector<Override> overrides;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    overrides.push_back({setting.substr(0, equals), setting.substr(equals + 1), setting});
  }
  apply_overrides(simulation_format(), overrides, scene);
  return scene;
}

// Gives the cloth the entrant's fabric, which may differ from the fabric that it was loaded with.
GarmentInScene set_material(const sim::Material& material, GarmentInScene cloth) {
  if (cloth.garment->material != material) {
    cloth.garment = sim::share(sim::with_material(*cloth.garment, material));
  }
  return cloth;
}

class TautEngine : public Engine {
 public:
  TautEngine(const GarmentInScene& cloth, const Scene& scene)
      : simulation_(make_simulation(scene, set_material(scene.material, cloth))) {}

  FrameCost advance_frame() override {
    const Stopwatch clock(CLOCK_PROCESS_CPUTIME_ID);
    simulation_.advance_frame(throw_if_interrupted);
    const double cpu_ms = clock.elapsed_ms();
    return {cpu_ms, simulation_.frame_report().substeps, simulation_.frame_report().bound_kept};
  }
  std::span<const sim::Vec3> positions() const override { return simulation_.state().current; }

 private:
  sim::Simulation simulation_;
};

Entrant taut_entrant(const std::string& engine, const std::string& name, std::optional<double> bound,
                     const Settings& settings) {
  return {engine, name, bound, [settings](const GarmentInScene& cloth, const Scene& scene) {
            return make_taut_engine(cloth, with_settings(scene, settings));
          }};
}

// Numbers of substeps and iterations.
using Division = std::pair<int, int>;

std::string in_words(const Division& division) { return fmt::format("{} x {}", division.first, division.second); }

std::vector<Entrant> bounded_entrants(const std::vector<double>& bounds, const std::string& name = "bounded",
                                      const Settings& changes = {}) {
  std::vector<Entrant> entrants;
  for (const double bound : bounds) {
    Settings settings = {"solver.kind=bounded", fmt::format("solver.max_stretch={}", bound)};
    settings.insert(settings.end(), changes.begin(), changes.end());
    entrants.push_back(taut_entrant(name, fmt::format("within {:g} %", 100.0 * bound), bound, settings));
  }
  return entrants;
}

// The paper's method to the letter, with every spring rigid both ways: one step per frame as in the paper, and short
// steps with one sweep each, which the paper does not mention and which work better.
std::vector<Entrant> strong_entrants(bool full) {
  const std::vector<Division> quick = {{1, 50}, {20, 1}, {80, 1}, {160, 1}};
  const std::vector<Division> all = {{1, 10}, {1, 50}, {1, 200}, {1, 800}, {10, 1},  {20, 1},
                                     {40, 1}, {80, 1}, {120, 1}, {160, 1}, {240, 1}, {320, 1}};
  std::vector<Entrant> entrants;
  for (const Division& division : full ? all : quick) {
    entrants.push_back(taut_entrant(
        "strong", in_words(division), {},
        {"solver.kind=strong", fmt::format("solver.substeps={}", division.first),
         fmt::format("solver.iterations={}", division.second), "solver.compression=1.0", "solver.flexural=1.0"}));
  }
  return entrants;
}

// Two iterations per substep were the best, or within a tenth of it, in all trials. So this series is fine, and a few
// others show that.
std::vector<Entrant> bullet_entrants(bool full) {
  const std::vector<Division> quick = {{20, 2}, {40, 2}, {50, 2}, {60, 2}, {90, 1}, {160, 4}};
  const std::vector<Division> all = {{1, 100}, {10, 10}, {10, 2},  {16, 2},  {20, 1}, {20, 2},  {25, 2},
                                     {32, 2},  {40, 2},  {50, 2},  {64, 2},  {80, 2}, {100, 2}, {128, 2},
                                     {160, 2}, {200, 2}, {250, 2}, {320, 2}, {90, 1}, {40, 4},  {160, 4}};
  std::vector<Entrant> entrants;
  for (const Division& division : full ? all : quick) {
    entrants.push_back({"bullet", in_words(division), {}, [division](const GarmentInScene& cloth, const Scene& scene) {
                          return make_bullet_engine(*cloth.garment, cloth.pins, scene.surroundings,
                                                    1.0 / scene.simulation.frame_rate_hz,
                                                    {division.first, division.second});
                        }});
  }
  return entrants;
}

RunEnd end_so_far(const std::vector<FrameSample>& frames, const RaceSettings& settings) {
  // Too few frames decide nothing: the first ones fill the caches, and cloth starts unstretched.
  if (frames.size() < 6) {
    return RunEnd::finished;
  }
  const double sum_ms = std::accumulate(frames.begin(), frames.end(), 0.0,
                                        [](double sum, const FrameSample& frame) { return sum + frame.cost.cpu_ms; });
  return sum_ms > settings.slowest_frame_ms * static_cast<double>(frames.size()) ? RunEnd::too_slow
         : frames.back().springs.max > settings.hopeless_stretch                 ? RunEnd::hopeless
                                                                                 : RunEnd::finished;
}

void advance(Engine& engine, const sim::Garment& garment, const RaceSettings& settings, Run& run) {
  try {
    const FrameCost cost = engine.advance_frame();
    run.frames.push_back({cost, sim::measure_stretch(garment.springs, engine.positions()),
                          sim::measure_surface_stretch(garment, engine.positions())});
    run.end = end_so_far(run.frames, settings);
  } catch (const sim::Diverged&) {
    run.end = RunEnd::diverged;
  }
}

}  // namespace

std::unique_ptr<Engine> make_taut_engine(const GarmentInScene& cloth, const Scene& scene) {
  Scene sleepless = scene;
  sleepless.simulation.rest.speed_m_per_s = 0.0;
  return std::make_unique<TautEngine>(cloth, sleepless);
}

const std::vector<RaceScene>& race_scenes() {
  static const std::vector<RaceScene> scenes = {
      {"hanging", {}},
      {"shaken", {"pins.motion.amplitude=[0.1, 0.0, 0.0]", "pins.motion.frequency=1.0"}},
      {"wind", {"wind.speed=10.0", "wind.direction=[0.3, 0.0, 1.0]"}},
  };
  return scenes;
}

const std::vector<RaceSize>& race_sizes() {
  static const std::vector<RaceSize> sizes = {
      {1028, 1028, 0}, {5280, 5280, 0}, {10600, 10600, 0}, {42400, 10600, 1}, {84480, 5280, 2}};
  return sizes;
}

Scene make_race_scene(const RaceScene& race_scene, const RaceSize& size) {
  Scene scene = find_scene("tshirt-gravity", {});
  scene.garment.file = scene.garment.file.parent_path() / fmt::format("tshirt_{}.obj", size.model);
  return with_settings(
      with_settings(std::move(scene), {fmt::format("garment.subdivisions={}", size.subdivisions),
                                       R"(pins.at=["front_neckline", "back_neckline"])", "solver.contact=false"}),
      race_scene.settings);
}

std::vector<std::string> engine_names() { return {"bounded", "bullet", "strong"}; }

std::vector<Entrant> list_entrants(const std::string& engine, const std::vector<double>& bounds, bool full) {
  return engine == "bounded"  ? bounded_entrants(bounds)
         : engine == "strong" ? strong_entrants(full)
                              : bullet_entrants(full);
}

std::vector<Entrant> ablation_entrants(const std::vector<double>& bounds) {
  const std::vector<std::pair<std::string, std::string>> parts = {
      {"bounded", ""},
      {"springs", "solver.bound=\"springs\""},
      {"no tethers", "solver.tethers=false"},
      {"no bending", "cloth.bending_rigidity=0"},
      {"no vectors", "solver.vector_unit=\"scalar\""},
      {"no softness", "cloth.compression_stiffness=1e6"},
  };
  std::vector<Entrant> entrants;
  for (const auto& [name, setting] : parts) {
    const auto some = bounded_entrants(bounds, name, setting.empty() ? Settings{} : Settings{setting});
    entrants.insert(entrants.end(), some.begin(), some.end());
  }
  return entrants;
}

const char* to_name(RunEnd end) {
  constexpr std::array names = {"finished", "diverged", "too slow", "hopeless"};
  return names[static_cast<std::size_t>(end)];
}

std::vector<Run> race(const std::vector<Entrant>& entrants, const GarmentInScene& cloth, const Scene& scene,
                      const RaceSettings& settings) {
  // Enough consecutive frames to find an engine's data in the caches again, as if it ran alone.
  constexpr int frames_in_a_turn = 10;
  std::vector<Run> runs;
  std::vector<std::unique_ptr<Engine>> engines;
  for (const Entrant& entrant : entrants) {
    runs.push_back({entrant, {}, RunEnd::finished});
    engines.push_back(entrant.make(cloth, scene));
  }
  for (int begin = 0; begin < settings.frames; begin += frames_in_a_turn) {
    const int end = std::min(begin + frames_in_a_turn, settings.frames);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      for (int frame = begin; frame < end && runs[i].end == RunEnd::finished; ++frame) {
        advance(*engines[i], *cloth.garment, settings, runs[i]);
      }
    }
  }
  return runs;
}

RunFacts summarise_run(const Run& run) {
  RunFacts facts;
  std::vector<double> times_ms;
  std::vector<int> substeps;
  for (const FrameSample& frame : run.frames) {
    times_ms.push_back(frame.cost.cpu_ms);
    substeps.push_back(frame.cost.substeps);
    facts.stretch = std::max(facts.stretch, frame.springs.max);
    facts.p99_stretch = std::max(facts.p99_stretch, frame.springs.p99);
    facts.surface_stretch = std::max(facts.surface_stretch, frame.surface.max);
    facts.p99_surface_stretch = std::max(facts.p99_surface_stretch, frame.surface.p99);
    facts.not_certified += frame.cost.is_certified ? 0 : 1;
  }
  if (!times_ms.empty()) {
    facts.median_ms = quantile(times_ms, 0.5);
    facts.mean_ms = std::accumulate(times_ms.begin(), times_ms.end(), 0.0) / static_cast<double>(times_ms.size());
    facts.p99_ms = quantile(times_ms, 0.99);
    facts.median_substeps = quantile(substeps, 0.5);
  }
  return facts;
}

int frames_over(const Run& run, double bound) {
  return static_cast<int>(std::count_if(run.frames.begin(), run.frames.end(),
                                        [&](const FrameSample& frame) { return !(frame.springs.max <= bound); }));
}

const Run* best_run(std::span<const Run> runs, const std::string& engine, double bound) {
  const auto rank = [&](const Run& run) {
    const bool is_finished = run.end == RunEnd::finished;
    const bool keeps = is_finished && frames_over(run, bound) == 0;
    return std::tuple(!keeps, !is_finished, keeps ? summarise_run(run).median_ms : summarise_run(run).stretch);
  };
  const Run* best = nullptr;
  for (const Run& run : runs) {
    if (run.entrant.engine == engine && run.entrant.bound.value_or(bound) == bound && !run.frames.empty() &&
        (best == nullptr || rank(run) < rank(*best))) {
      best = &run;
    }
  }
  return best;
}

}  // namespace taut::app
