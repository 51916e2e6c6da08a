#pragma once

#include "app/bodies/frame_source.hpp"
#include "app/models/reading/garment_import.hpp"

namespace taut::app {

/// A body's mesh, and where its vertices are in its file.
struct LoadedMesh {
  sim::Mesh mesh;  ///< closed, facing outwards, in m
  FileVertexPlaces places;
  std::size_t file_vertices = 0;
  std::vector<std::string> remarks;  ///< guesses and repairs, for people
};

/// Longest border of a hole that is closed, in m; an open neck has one of this length.
inline constexpr double max_border_m = 0.6;

/// Makes the mesh of a body from a model. Equal positions are welded, triangles without area are mended, small holes
/// are closed and triangles are oriented outwards. Throws InputError that names the file and the place, in the file's
/// unit and axes:
/// - on a mesh that is not closed: an edge with one triangle or with more than two, or a surface with one side;
/// - on a triangle that has no area or is given twice, and on a position that is not a number.
LoadedMesh make_body_mesh(const BodySource& source, const ImportedModel& model);

}  // namespace taut::app
