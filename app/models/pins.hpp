#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/models/file_vertices.hpp"
#include "app/models/landmarks.hpp"
#include "app/scene/scene.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// The vertex nearest to a point, and its distance.
struct NearestVertex {
  sim::Index vertex = 0;
  double distance_m = 0.0;
};

/// Finds it by looking at every vertex. A few hundred calls for ten thousand vertices take milliseconds.
/// `positions` must not be empty.
NearestVertex nearest_vertex(std::span<const sim::Vec3> positions, const sim::Vec3& point_m);

/// Facts about a garment for select_pins().
struct PinTargets {
  const sim::Mesh& mesh;
  const Landmarks& landmarks;
  const FileVertices& file_vertices;
  const sim::GridSettings* grid = nullptr;  ///< null for a model
  const char* key = "pins.at";              ///< the key that names the pins, for messages
};

/// The names that a scene can pin: landmarks, corners and edges of a grid, "top-band" (the upper 3 % of
/// the height) and, alone and for a model, "hanger" (hanger.hpp).
std::vector<std::string> pin_names(const PinTargets& targets);

/// The vertices of the mesh that the scene pins. Throws InputError for an unknown name or a vertex that does
/// not exist.
std::vector<sim::Index> select_pins(const std::optional<std::vector<PinSelector>>& pins,
                                    const PinTargets& targets);

}  // namespace taut::app
