#pragma once

#include <optional>
#include <string_view>

#include "app/models/model_arrays.hpp"

namespace taut::app {

/// Reads the text of a Wavefront OBJ file in double precision: assimp reads it in single precision, and a
/// bound on stretch of a few millionths would be judged by other rest lengths than the file's. Vertices are
/// numbered in the order in which faces use them, those that none uses come last. Materials, normals, texture
/// coordinates and free-form surfaces are passed over, faces of one or two corners, points and lines counted.
/// Nothing where no line defines a vertex: it is another kind of file then.
/// Throws InputError naming the line, what was found there and what was expected.
std::optional<ModelArrays> read_obj(std::string_view text);

}  // namespace taut::app
