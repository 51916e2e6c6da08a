#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/mesh/types.hpp"

namespace taut::app {

/// Which vertex of a garment's mesh stands for a vertex of its file. Those of a file are numbered from 0,
/// mesh after mesh; a format that shares no vertices between faces, such as STL, has corners in their place.
struct FileVertices {
  std::vector<sim::Index> mesh_vertex;  ///< by the file's number; sim::no_vertex: it was not kept
  bool are_corners = false;

  /// Nothing where there is none; `why_missing` says why.
  std::optional<sim::Index> find(std::size_t number) const;
  /// "found vertex 9, expected one of the vertices of the file, 0 to 7", or that it belongs to no face.
  std::string why_missing(std::size_t number) const;
  /// The first one that the vertex of the mesh stands for.
  std::optional<sim::Index> number_of(sim::Index vertex) const;
  /// "vertices of the file, 0 to 7".
  std::string describe() const;
};

}  // namespace taut::app
