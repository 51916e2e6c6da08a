#pragma once

#include <memory>

#include "app/bench/engines/engine.hpp"
#include "app/models/garment_loading.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {

/// Taut with the scene's solver. The garment never sleeps, so every frame is computed. The engine shares the
/// ownership of the garment.
std::unique_ptr<Engine> make_taut_engine(const GarmentInScene& cloth, const Scene& scene);

}  // namespace taut::app
