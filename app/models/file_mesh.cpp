#include "app/models/file_mesh.hpp"

#include <fmt/core.h>

#include "sim/mesh/welding.hpp"

namespace taut::app {

std::optional<sim::Index> FileVertices::find(std::size_t number) const {
  const bool is_kept = number < mesh_vertex.size() && mesh_vertex[number] != sim::no_vertex;
  return is_kept ? std::optional(mesh_vertex[number]) : std::nullopt;
}

std::string FileVertices::why_missing(std::size_t number) const {
  if (number >= mesh_vertex.size()) {
    return fmt::format("found vertex {}, expected one of the {}", number, describe());
  }
  return fmt::format(
      "vertex {} of the file belongs to no face, or only to faces that were removed because they have no "
      "area or repeat others",
      number);
}

std::optional<sim::Index> FileVertices::number_of(sim::Index vertex) const {
  const auto found = std::ranges::find(mesh_vertex, vertex);
  return found != mesh_vertex.end() ? std::optional(static_cast<sim::Index>(found - mesh_vertex.begin()))
                                    : std::nullopt;
}

std::string FileVertices::describe() const {
  return fmt::format("{}, 0 to {}",
                     are_corners ? "corners of the file's faces, which share no vertices" : "vertices of the file",
                     mesh_vertex.size() - 1);
}

}  // namespace taut::app
