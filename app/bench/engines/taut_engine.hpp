#pragma once

#include <memory>

#include "app/bench/engines/engine.hpp"
#include "app/scene/scene.hpp"
#include "sim/garment.hpp"

namespace taut::app {

/// Taut with the solver of the scene, never put to sleep: every frame is computed. The garment is copied.
std::unique_ptr<Engine> make_taut_engine(const sim::Garment& garment, const Scene& scene);

}  // namespace taut::app
