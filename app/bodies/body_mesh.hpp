#pragma once

#include "app/bodies/frame_source.hpp"
#include "app/models/garment_import.hpp"

namespace taut::app {

/// A body's mesh, and what became of the vertices of its file.
struct LoadedMesh {
  sim::Mesh mesh;  ///< closed, facing outwards, in m
  FileVertexPlaces places;
  std::size_t file_vertices = 0;
  std::vector<std::string> remarks;  ///< what was guessed and repaired, for people
};

/// The longest border of a hole that is closed, in m: as long as that of an open neck.
inline constexpr double longest_border_m = 0.6;

/// Makes the mesh of a body of a model. Equal positions are welded, triangles without area become one with a
/// neighbour, small holes are closed and triangles are turned to face outwards. Throws
/// InputError that names the file and the place, in the file's unit and axes:
/// - on a mesh that is not closed: an edge with one triangle or with more than two, or a surface with one
/// side;
/// - on a triangle without area or given twice, and on a position that is not a number.
LoadedMesh make_body_mesh(const BodySource& source, const ImportedModel& model);

}  // namespace taut::app
