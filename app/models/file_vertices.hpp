#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/mesh/types.hpp"

namespace taut::app {

/// Relates the vertices of a model file to those of the garment's mesh. Vertices of a file count from 0, mesh
/// after mesh. In a format without shared vertices, such as STL, the corners of the faces are counted
/// instead.
struct FileVertices {
  /// Per vertex of the file, in the mesh; sim::no_vertex if it was dropped.
  std::vector<sim::Index> mesh_vertex;
  bool are_corners = false;  ///< the numbers count corners

  /// The vertex of the mesh for a vertex of the file. Empty if there is none; `why_missing` then says why.
  std::optional<sim::Index> find(std::size_t number) const;
  /// Says that the number is outside the file, or that no face uses this vertex: "found vertex 9, expected
  /// one of the vertices of the file, 0 to 7".
  std::string why_missing(std::size_t number) const;
  /// The first vertex of the file that became this vertex of the mesh. Empty if there is none.
  std::optional<sim::Index> number_of(sim::Index vertex) const;
  /// The range of numbers: "vertices of the file, 0 to 7".
  std::string describe() const;
};

}  // namespace taut::app
