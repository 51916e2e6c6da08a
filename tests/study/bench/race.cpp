#include "race.hpp"

#include <fmt/core.h>

#include "app/base/errors.hpp"
#include "app/base/progress.hpp"
#include "app/base/words.hpp"
#include "app/scene/scene_format.hpp"
#include "sim/simulation.hpp"

namespace taut::app {
namespace {

class TautEngine : public Engine {
 public:
  TautEngine(const GarmentInScene& cloth, const Scene& scene) : simulation_(make_simulation(scene, cloth)) {
    simulation_.set_material(scene.material);
  }

  double advance_frame() override {
    const Stopwatch clock(CLOCK_PROCESS_CPUTIME_ID);
    simulation_.advance_frame(throw_if_interrupted);
    return clock.elapsed_ms();
  }
  std::span<const sim::Vec3> positions() const override { return simulation_.state().current; }

 private:
  sim::Simulation simulation_;
};

void advance(Engine& engine, const sim::Garment& garment, double max_frame_ms, Run& run) {
  constexpr std::size_t first_frames = 6;  // they build the engine's structures
  constexpr double hopeless_stretch = 0.5;
  try {
    const double cpu_ms = engine.advance_frame();
    run.frames.push_back({cpu_ms, sim::measure_stretch(garment.springs, engine.positions()).max,
                          sim::measure_surface_stretch(garment, engine.positions()).max});
  } catch (const sim::Diverged&) {
    run.given_up = "diverged";
    return;
  }
  double sum_ms = 0.0;
  for (const RaceFrame& frame : run.frames) sum_ms += frame.cpu_ms;
  if (run.frames.size() < first_frames) return;
  if (sum_ms > max_frame_ms * static_cast<double>(run.frames.size())) run.given_up = "too slow";
  if (run.frames.back().stretch > hopeless_stretch) run.given_up = "hopeless";
}

double median_ms(const Run& run) { return quantile(collect<double>(run.frames, &RaceFrame::cpu_ms), 0.5); }

}  // namespace

std::vector<Entrant> taut_entrants(const std::vector<double>& bounds) {
  std::vector<Entrant> entrants;
  for (const double bound : bounds) {
    const std::vector<Override> changes = {parse_override(fmt::format("solver.max_stretch={}", bound))};
    entrants.push_back({"bounded", fmt::format("within {:g} %", 100.0 * bound), bound,
                        [changes](const GarmentInScene& cloth, Scene scene) {
                          apply_overrides(simulation_format(), changes, scene);
                          return std::make_unique<TautEngine>(cloth, scene);
                        }});
  }
  return entrants;
}

std::vector<Entrant> bullet_entrants() {
  std::vector<Entrant> entrants;
  for (const BulletSettings& settings :
       {BulletSettings{20, 2}, {40, 2}, {50, 2}, {60, 2}, {90, 1}, {100, 2}, {160, 2}, {160, 4}, {320, 2}}) {
    entrants.push_back({"bullet",
                        fmt::format("{} x {}", settings.substeps, settings.iterations),
                        {},
                        [settings](const GarmentInScene& cloth, const Scene& scene) {
                          return make_bullet_engine(cloth, scene, settings);
                        }});
  }
  return entrants;
}

double Run::max_stretch() const {
  double largest = 0.0;
  // A NaN, which compares with nothing, counts as lost.
  for (const RaceFrame& frame : frames) largest = frame.stretch <= largest ? largest : frame.stretch;
  return std::isnan(largest) ? INFINITY : largest;
}

std::vector<Run> race(const std::vector<Entrant>& entrants, const GarmentInScene& cloth, const Scene& scene, int frames,
                      double max_frame_ms) {
  constexpr int frames_in_a_turn = 10;
  std::vector<Run> runs;
  std::vector<std::unique_ptr<Engine>> engines;
  for (const Entrant& entrant : entrants) {
    runs.push_back({entrant, {}, ""});
    engines.push_back(entrant.make(cloth, scene));
  }
  for (int begin = 0; begin < frames; begin += frames_in_a_turn) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      for (int frame = begin; frame < std::min(begin + frames_in_a_turn, frames) && runs[i].given_up.empty(); ++frame) {
        advance(*engines[i], *cloth.garment, max_frame_ms, runs[i]);
      }
    }
  }
  return runs;
}

const Run* best_run(std::span<const Run> runs, const std::string& engine, double bound) {
  const auto rank = [&](const Run& run) {
    const bool is_kept = run.given_up.empty() && run.max_stretch() <= bound;
    return std::tuple(!is_kept, !run.given_up.empty(), is_kept ? median_ms(run) : run.max_stretch());
  };
  const Run* best = nullptr;
  for (const Run& run : runs) {
    const bool is_candidate =
        run.entrant.engine == engine && run.entrant.bound.value_or(bound) == bound && !run.frames.empty();
    if (is_candidate && (best == nullptr || rank(run) < rank(*best))) best = &run;
  }
  return best;
}

}  // namespace taut::app
