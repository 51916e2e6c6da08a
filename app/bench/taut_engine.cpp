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
    const sim::FrameReport& report = simulation_.frame_report();
    cost.substeps = report.substeps;
    cost.springs_projected = report.substeps * springs_in_a_step();
    cost.is_certified = report.bound_kept;
    return cost;
  }

  std::span<const sim::Vec3> raw_positions() const override { return simulation_.state().current; }
  std::span<const sim::Vec3> shown_positions() const override { return simulation_.shown_positions(); }

 private:
  // What `bounded` does besides one sweep over the springs it binds is left out: bending, which are no
  // projections, sweeps near the pins and the certificate.
  double springs_in_a_step() const {
    const sim::SolverSettings& solver = simulation_.settings().solver;
    const sim::Springs& springs = simulation_.garment().springs;
    return solver.kind == sim::SolverKind::bounded
               ? static_cast<double>(springs.begin_of(sim::SpringKind::flexural))
               : static_cast<double>(springs.size()) * solver.iterations;
  }

  sim::Simulation simulation_;
};

}  // namespace

std::unique_ptr<Engine> make_taut_engine(const sim::Garment& garment, const Scene& scene) {
  return std::make_unique<TautEngine>(garment, scene);
}

}  // namespace taut::app
