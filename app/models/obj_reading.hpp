#pragma once

#include "app/models/model_arrays.hpp"

namespace taut::app {

/// Reads the text of a Wavefront OBJ file in double precision. Assimp reads it in single precision, which
/// would change rest lengths by more than the smallest bounds on stretch.
///
/// Vertices are numbered by number_by_first_use(). Of materials the names are read (read_mtl());
/// texture coordinates that are damaged are (0, 0). Of normals it is kept that there are some; free-form
/// surfaces are ignored. Points, lines and faces of one or two corners are counted. Empty if no line defines
/// a vertex: then it is another kind of file. Throws InputError that names the line, what was found and what
/// was expected.
std::optional<ModelArrays> read_obj(std::string_view text);

}  // namespace taut::app
