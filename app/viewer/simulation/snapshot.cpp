#include "app/viewer/simulation/snapshot.hpp"

namespace taut::app {

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
