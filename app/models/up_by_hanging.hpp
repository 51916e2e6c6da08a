#pragma once

#include <optional>

#include "app/scene/scene.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// Hangs a model with its y axis up and with its z axis up for a second each, and returns the axis with which
/// it is higher and its cloth moved less: a garment that hangs the right way up is nearly where it was
/// modelled, and all of it can be seen. Of a flat pattern that lies, -z if it is the wider end that z would
/// have at the top. Empty if both are alike, or if there is nothing to hang it by. In metres; takes the time
/// of 120 frames without contact.
std::optional<ModelAxis> up_by_hanging(const sim::Mesh& model_m);

}  // namespace taut::app
