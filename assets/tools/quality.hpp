#pragma once

#include <cstddef>

#include "sim/mesh/mesh.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::tailor {

/// Numbers that describe a mesh.
struct MeshQuality {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  double smallest_angle_deg = 0.0;
  double shortest_edge_m = 0.0;
  double mean_edge_m = 0.0;
  double longest_edge_m = 0.0;
  double area_m2 = 0.0;
  /// Volume when each opening is closed by a fan of triangles. Positive if the outside is outside.
  double volume_m3 = 0.0;
  std::size_t crossings = 0;  ///< as count_crossings() returns it
  sim::Topology topology;
};

/// Measures the mesh.
MeshQuality measure_quality(const sim::Mesh& mesh);

}  // namespace taut::tailor
