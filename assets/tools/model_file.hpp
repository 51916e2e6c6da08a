#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/mesh/mesh.hpp"
#include "tailor/sewing/shirt.hpp"

namespace taut::tailor {

/// Named vertices of a model, in order along a seam or border. A closed loop does not repeat its first
/// vertex.
struct Landmark {
  std::string name;
  std::vector<Index> vertices;
};

/// Metres of flat cloth for a unit of texture coordinates, for every size of the shirt.
inline constexpr double metres_per_uv = 1.5;

/// A file: a mesh, with positions rounded to micrometres, and its landmarks.
struct Model {
  sim::Mesh mesh;
  /// Texture coordinates, three per triangle: the pieces as they are cut, seen from outside and upright, side
  /// by side in the square from 0 to 1. The folds of front and back are at u = 0.25 and 0.75, so that a print
  /// is as large and as far below the neck on every size.
  std::vector<glm::vec2> corner_uv;
  std::vector<Landmark> landmarks;
};

/// Numbers the vertices in the order in which triangles first use them. Importers that split a file into
/// corners and join them again get the same order, so landmarks stay valid. `positions` are in metres, per
/// vertex of the shirt.
Model make_model(const Shirt& shirt, const std::vector<Vec3>& positions);

/// Writes NAME.obj and NAME.landmarks.toml, each to a temporary name first. Throws app::InputError that names
/// the file that cannot be written.
void write_model(const Model& model, const std::filesystem::path& folder, const std::string& name,
                 const std::string& header);

}  // namespace taut::tailor
