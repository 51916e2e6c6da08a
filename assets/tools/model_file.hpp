#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/mesh/mesh.hpp"
#include "tailor/sewing/shirt.hpp"

namespace taut::tailor {

/// Vertices of a model that have a name, in order along the seam or border. A loop does not repeat its first.
struct Landmark {
  std::string name;
  std::vector<Index> vertices;
};

/// What is written: a mesh with positions rounded to micrometres, and its landmarks.
struct Model {
  sim::Mesh mesh;
  std::vector<Landmark> landmarks;
};

/// Numbers the vertices in the order in which the triangles first use them: the order in which importers that
/// take a file apart into triangle corners put them together again, so that landmarks stay valid.
Model make_model(const Shirt& shirt, const std::vector<Vec3>& positions);

/// Writes NAME.obj and NAME.landmarks.toml, each first under a temporary name.
/// Throws std::runtime_error naming the file that could not be written.
void write_model(const Model& model, const std::filesystem::path& folder, const std::string& name,
                 const std::string& header);

}  // namespace taut::tailor
