#pragma once

#include <string>

#include "app/models/model_arrays.hpp"

namespace taut::app {

/// The model, in metres with y up, as a file of the format dae, fbx, obj, off, ply or stl. Written from the
/// formats' descriptions, not with the library that reads them. Throws std::invalid_argument on any other.
std::string model_text(const ModelArrays& model, const std::string& format);

}  // namespace taut::app
