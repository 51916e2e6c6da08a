#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/engines/engine.hpp"
#include "app/models/garment_loading.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {

/// An engine with fixed settings. It can run on any scene of the benchmark.
struct Entrant {
  std::string engine;    ///< one of engine_names()
  std::string settings;  ///< the settings, for people
  /// The largest stretch the engine was asked to keep, as a fraction. Empty for an engine without a bound.
  std::optional<double> bound;
  std::optional<sim::BoundKind> held;  ///< what it was asked to keep within the bound; set if `bound` is
  /// Starts the engine on a garment.
  std::function<std::unique_ptr<Engine>(const GarmentInScene&, const Scene&)> make;
};

/// The values of --engines. The engine that is compared with the others comes first.
std::vector<std::string> engine_names();

/// All settings of one engine that are run. An engine with a bound has one entrant for each of `bounds`. Any
/// other engine has a series of settings, cheap ones first; the best for each bound is found after the runs.
/// `full` asks for the longer series. Empty if the engine is not compiled in.
std::vector<Entrant> entrants_of(const std::string& engine, const std::vector<double>& bounds, bool full);

/// Returns the scene with `bounded` asked to hold springs or the surface within `bound`, which is a fraction.
/// The solver is left to choose its substeps.
Scene asked_for(Scene scene, double bound, sim::BoundKind held);

/// For each bound the complete `bounded` solver as it is by default. Then, each for every bound, the solver
/// holding what it does not hold by default, and the solver with one of its parts switched off.
std::vector<Entrant> ablation_entrants(const std::vector<double>& bounds);

}  // namespace taut::app
