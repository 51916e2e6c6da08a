#pragma once

#include "app/models/hanging/placement.hpp"
#include "app/models/reading/file_mesh.hpp"

namespace taut::app {

/// Named sets of vertices of the mesh, such as seams, in the order of their file.
using Landmarks = std::vector<std::pair<std::string, std::vector<sim::Index>>>;

/// Reads the landmarks and finds their vertices in the mesh. The file holds lists of points [x, y, z] in the garment's
/// unit, or lists of numbers of the file's vertices. Returns nothing if there is no such file. Throws InputError that
/// names the file, the line, the landmark, and the point or the vertex that was not found.
Landmarks read_landmarks(const std::filesystem::path& garment, const Placement& placement, const sim::Mesh& mesh,
                         const FileVertices& file_vertices);

/// Facts about the garment itself in the same file.
struct GarmentFacts {
  std::optional<double> metres_per_unit = {};  ///< unit of its positions; empty if the file does not say
  std::optional<ModelAxis> up = {};
  std::optional<double> metres_per_uv = {};  ///< scale of its texture coordinates; empty if the file does not say
  bool is_cut = false;  ///< true if it is at rest as cut: with the lengths of its texture coordinates, in that scale
  int layers = 1;       ///< count of garments over each other
  /// Fabrics of its layers: the start of the names of groups, and the name or file of their fabric (find_fabric()).
  std::vector<std::pair<std::string, std::string>> fabrics = {};
};

/// Reads these facts; returns the defaults without a garment. Throws InputError that names the file and the line.
GarmentFacts read_garment_facts(const std::filesystem::path& garment);

/// The vertex nearest to a point, and its distance.
struct NearestVertex {
  sim::Index vertex = 0;
  double distance_m = 0.0;
};

/// Finds the nearest vertex by testing every vertex. A few hundred calls for ten thousand vertices take milliseconds.
/// `positions` must not be empty.
NearestVertex nearest_vertex(std::span<const sim::Vec3> positions, const sim::Vec3& point_m);

/// Facts about a garment for select_pins().
struct PinTargets {
  const sim::Mesh& mesh;
  const Landmarks& landmarks;
  const FileVertices& file_vertices;
  const sim::GridSettings* grid = nullptr;  ///< null for a model
  const char* key = "pins.at";              ///< key that names the pins, for messages
};

/// Returns the vertices of the mesh that the scene pins. Throws InputError for an unknown name or a vertex that does
/// not exist.
std::vector<sim::Index> select_pins(const std::optional<std::vector<PinSelector>>& pins, const PinTargets& targets);

}  // namespace taut::app
