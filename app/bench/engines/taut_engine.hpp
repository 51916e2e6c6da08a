#pragma once

#include <memory>

#include "app/bench/engines/engine.hpp"
#include "app/models/garment_loading.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {

/// Taut with the solver of the scene, never put to sleep: every frame is computed. The garment is shared.
std::unique_ptr<Engine> make_taut_engine(const GarmentInScene& cloth, const Scene& scene);

}  // namespace taut::app
