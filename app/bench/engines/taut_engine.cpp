#include "app/bench/engines/taut_engine.hpp"

#include "app/base/stopwatch.hpp"
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
    const ProcessorStopwatch clock(CLOCK_PROCESS_CPUTIME_ID);
    simulation_.advance_frame();
    cost.cpu_ms = clock.elapsed_ms();
    const sim::FrameReport& report = simulation_.frame_report();
    cost.substeps = report.substeps;
    cost.springs_projected = springs_projected(report);
    cost.is_certified = report.bound_kept;
    if (report.bound_promised) {
      cost.raw_stretch = report.raw_max_stretch;
    }
    return cost;
  }

  std::span<const sim::Vec3> positions() const override { return simulation_.state().current; }

 private:
  // Bending, which is no projection, and tethers are left out.
  double springs_projected(const sim::FrameReport& report) const {
    const sim::SolverSettings& solver = simulation_.settings().solver;
    const sim::Springs& springs = simulation_.garment().springs;
    return solver.kind == sim::SolverKind::bounded
               ? report.sweeps * static_cast<double>(springs.begin_of(sim::SpringKind::flexural))
               : static_cast<double>(report.substeps * solver.iterations) *
                     static_cast<double>(springs.size());
  }

  sim::Simulation simulation_;
};

}  // namespace

std::unique_ptr<Engine> make_taut_engine(const sim::Garment& garment, const Scene& scene) {
  return std::make_unique<TautEngine>(garment, scene);
}

}  // namespace taut::app
