#include "app/bench/engines/taut_engine.hpp"

#include "app/base/interruption.hpp"
#include "app/base/stopwatch.hpp"
#include "sim/simulation.hpp"

namespace taut::app {
namespace {

Scene sleepless(Scene scene) {
  scene.simulation.rest.speed_m_per_s = 0.0;
  return scene;
}

// An entrant may ask for another fabric than the one that the cloth of all was loaded with.
GarmentInScene made_of(const sim::Material& material, GarmentInScene cloth) {
  if (cloth.garment->material != material) {
    cloth.garment = sim::share(sim::with_material(*cloth.garment, material));
  }
  return cloth;
}

class TautEngine : public Engine {
 public:
  TautEngine(const GarmentInScene& cloth, const Scene& scene)
      : simulation_(make_simulation(sleepless(scene), made_of(scene.material, cloth))) {}

  FrameCost advance_frame() override {
    FrameCost cost;
    const ProcessorStopwatch clock(CLOCK_PROCESS_CPUTIME_ID);
    simulation_.advance_frame(throw_if_interrupted);
    cost.cpu_ms = clock.elapsed_ms();
    const sim::FrameReport& report = simulation_.frame_report();
    cost.substeps = report.substeps;
    cost.projections = projections(report);
    cost.is_certified = report.bound_kept;
    if (report.bound_promised) {
      cost.raw_stretch = report.raw_max_stretch;
    }
    return cost;
  }

  std::span<const sim::Vec3> positions() const override { return simulation_.state().current; }

 private:
  // Bending, which is no projection, and tethers are left out.
  double projections(const sim::FrameReport& report) const {
    const sim::Garment& garment = simulation_.garment();
    const sim::SolverMethod& method = simulation_.settings().solver.method;
    if (const auto* strong = std::get_if<sim::StrongSettings>(&method)) {
      return static_cast<double>(report.substeps * strong->iterations) *
             static_cast<double>(garment.springs.size());
    }
    const auto* bounded = std::get_if<sim::BoundedSettings>(&method);
    const bool holds_triangles = bounded != nullptr && bounded->bound == sim::BoundKind::surface;
    return report.sweeps * static_cast<double>(holds_triangles
                                                   ? garment.mesh.triangles.size()
                                                   : garment.springs.begin_of(sim::SpringKind::flexural));
  }

  sim::Simulation simulation_;
};

}  // namespace

std::unique_ptr<Engine> make_taut_engine(const GarmentInScene& cloth, const Scene& scene) {
  return std::make_unique<TautEngine>(cloth, scene);
}

}  // namespace taut::app
