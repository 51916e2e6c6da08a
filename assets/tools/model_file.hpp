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

/// What is written: a mesh, with positions rounded to micrometres, and its landmarks.
struct Model {
  sim::Mesh mesh;
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
