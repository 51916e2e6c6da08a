#include "app/bench/engines/taut_engine.hpp"

#include "app/base/stopwatch.hpp"
#include "sim/simulation.hpp"

namespace taut::app {
namespace {

Scene sleepless(Scene scene) {
  scene.simulation.rest.speed_m_per_s = 0.0;
  return scene;
}

class TautEngine : public Engine {
 public:
  TautEngine(const GarmentInScene& cloth, const Scene& scene)
      : simulation_(make_simulation(sleepless(scene), cloth)) {}

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
    const sim::Springs& springs = simulation_.garment().springs;
    const auto* strong = std::get_if<sim::StrongSettings>(&simulation_.settings().solver.method);
    return strong == nullptr
               ? report.sweeps * static_cast<double>(springs.begin_of(sim::SpringKind::flexural))
               : static_cast<double>(report.substeps * strong->iterations) *
                     static_cast<double>(springs.size());
  }

  sim::Simulation simulation_;
};

}  // namespace

std::unique_ptr<Engine> make_taut_engine(const GarmentInScene& cloth, const Scene& scene) {
  return std::make_unique<TautEngine>(cloth, scene);
}

}  // namespace taut::app
