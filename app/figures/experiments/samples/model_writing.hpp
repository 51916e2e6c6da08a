#pragma once

#include <string>

#include "app/models/model_arrays.hpp"

namespace taut::app {

/// The content of a model file. `format` is dae, fbx, obj, off, ply or stl. The model is in metres with y up.
/// Written from the descriptions of the formats, not with the library that reads them. Throws
/// std::invalid_argument for another format.
std::string model_text(const ModelArrays& model, const std::string& format);

}  // namespace taut::app
