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

/// An engine with its settings, ready to be put to any scene.
struct Entrant {
  std::string engine;
  std::string settings;  ///< in words
  std::optional<double>
      bound;  ///< the stretch it was asked to keep; none where an engine knows no such thing
  std::function<std::unique_ptr<Engine>(const GarmentInScene&, const Scene&)> make;
};

/// Names for --engines, the one to beat first.
std::vector<std::string> engine_names();

/// Every setting of the engine that is tried: one for each bound where it takes a bound; else a series, from
/// cheap to expensive, out of which the best for each bound is chosen afterwards. None where the engine is
/// not there.
std::vector<Entrant> entrants_of(const std::string& engine, const std::vector<double>& bounds, bool full);

/// For each bound the bounded solver whole, and then without one of its parts at a time.
std::vector<Entrant> ablation_entrants(const std::vector<double>& bounds);

}  // namespace taut::app
