#include "app/bench/taut_engine.hpp"

#include "app/bench/cpu_clock.hpp"
#include "sim/simulation.hpp"

namespace taut::app {
namespace {

sim::SimulationSettings sleepless(sim::SimulationSettings settings) {
  settings.rest.speed_m_per_s = 0.0;
  return settings;
}

class TautEngine : public Engine {
 public:
  TautEngine(const sim::Garment& garment, const Scene& scene)
      : simulation_(garment, sleepless(scene.simulation), scene.surroundings) {}

  FrameCost advance_frame() override {
    FrameCost cost;
    const CpuClock clock;
    simulation_.advance_frame();
    cost.cpu_ms = clock.elapsed_ms();
    const sim::SolverSettings& solver = simulation_.settings().solver;
    cost.substeps = solver.substeps;
    cost.springs_projected =
        static_cast<double>(simulation_.garment().springs.size()) * solver.substeps * solver.iterations;
    return cost;
  }

  const std::vector<sim::Vec3>& raw_positions() const override { return simulation_.state().current; }
  const std::vector<sim::Vec3>& shown_positions() const override { return simulation_.state().current; }

 private:
  sim::Simulation simulation_;
};

}  // namespace

std::unique_ptr<Engine> make_taut_engine(const sim::Garment& garment, const Scene& scene) {
  return std::make_unique<TautEngine>(garment, scene);
}

}  // namespace taut::app
