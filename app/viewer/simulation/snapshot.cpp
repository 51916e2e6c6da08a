#include "app/viewer/simulation/snapshot.hpp"

namespace taut::app {

bool has_stopped(const Snapshot& snapshot) {
  return snapshot.stopped && (!snapshot.compared || snapshot.compared->stopped);
}

bool moves(const Snapshot& snapshot) {
  return (!snapshot.stopped && !snapshot.record.asleep) || (snapshot.compared && moves(*snapshot.compared));
}

sim::Simulation gone_on_from(const Snapshot& past, const sim::SimulationSettings& settings,
                             const sim::Material& material, const sim::Surroundings& surroundings) {
  sim::Simulation simulation(past.garment, *past.pins, past.settings, past.surroundings);
  simulation.restore(*past.checkpoint);
  simulation.set_settings(settings);
  if (material != past.garment->material) {
    simulation.set_material(material);
  }
  simulation.set_surroundings(surroundings);
  return simulation;
}

}  // namespace taut::app
