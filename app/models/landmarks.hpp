#pragma once

#include "app/models/file_mesh.hpp"
#include "app/models/placement.hpp"

namespace taut::app {

/// Named sets of vertices of the mesh, such as seams, in the order of their file.
using Landmarks = std::vector<std::pair<std::string, std::vector<sim::Index>>>;

/// Reads the landmarks and finds their vertices in the mesh. The file holds lists of points [x, y, z] in the
/// garment's unit, or lists of numbers of the file's vertices. Returns nothing if there is no such file.
/// Throws InputError that names the file, the line, the landmark, and the point or the vertex that was not
/// found.
Landmarks read_landmarks(const std::filesystem::path& garment, const Placement& placement, const sim::Mesh& mesh,
                         const FileVertices& file_vertices);

/// The scale of the garment's texture coordinates in the same file: metres_per_uv = 1.5. Empty if it says
/// nothing. Throws InputError that names the file and the line if it is not a number above 0.
std::optional<double> known_metres_per_uv(const std::filesystem::path& garment);

/// Whether the same file says that the garment is at rest as it was cut, is_cut = true: with the lengths of its texture
/// coordinates, in the same scale. Throws InputError likewise.
bool is_at_rest_as_cut(const std::filesystem::path& garment);

/// How many garments over each other the same file says that it is, layers = 2; 1 if it says nothing. Throws
/// InputError likewise.
int garments_worn(const std::filesystem::path& garment);

/// The fabrics of its layers in the same file: for groups of the garment whose names begin so, that of a name or a
/// file (find_fabric()). Throws InputError likewise.
std::vector<std::pair<std::string, std::string>> fabrics_of_layers(const std::filesystem::path& garment);

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

/// The vertices of the mesh that the scene pins. Throws InputError for an unknown name or a vertex that does
/// not exist.
std::vector<sim::Index> select_pins(const std::optional<std::vector<PinSelector>>& pins, const PinTargets& targets);

}  // namespace taut::app
