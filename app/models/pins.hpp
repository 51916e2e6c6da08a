#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/models/file_vertices.hpp"
#include "app/models/landmarks.hpp"
#include "app/scene/scene.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::app {

struct NearestVertex {
  sim::Index vertex = 0;
  double distance_m = 0.0;
};

/// Looks at every vertex: a few hundred questions about ten thousand vertices take milliseconds.
NearestVertex nearest_vertex(std::span<const sim::Vec3> positions, const sim::Vec3& point_m);

/// What `select_pins` knows a garment by.
struct PinTargets {
  const sim::Mesh& mesh;
  const Landmarks& landmarks;
  const FileVertices& file_vertices;
  const sim::GridSettings* grid = nullptr;  ///< none for a model
};

/// The names that can be pinned: landmarks, corners and edges of a grid, "top-band" (the top 3 % of the
/// height).
std::vector<std::string> pin_names(const PinTargets& targets);

/// The vertices that a scene's pins mean. Throws InputError on an unknown name or a vertex that is not there.
std::vector<sim::Index> select_pins(const std::optional<std::vector<PinSelector>>& pins,
                                    const PinTargets& targets);

}  // namespace taut::app
