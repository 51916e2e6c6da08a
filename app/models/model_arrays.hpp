#pragma once

#include "app/models/file_mesh.hpp"
#include "app/models/rig.hpp"
#include "app/models/surface_colours.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {

/// A model file as flat arrays: the faces of all its meshes, at the places their nodes give them.
struct ModelArrays {
  std::vector<sim::Vec3> positions;          ///< in the file's unit and axes
  std::vector<std::uint32_t> corner_counts;  ///< per face, at least 3
  std::vector<sim::Index> corners;           ///< indices into `positions`, face after face
  /// Index into `positions` for each vertex of the file. Empty if the order is the same.
  std::vector<sim::Index> position_of_vertex;
  std::vector<FaceSection> sections;  ///< what groups the faces, ordered by them
  bool has_normals = false;           ///< the file has some; they are not read
  std::string format;                 ///< name of the format, from the reader
  std::size_t meshes = 0;
  std::size_t ignored_lines = 0;
  std::size_t ignored_points = 0;
  std::optional<double> metres_per_unit;  ///< empty if neither the file nor its format says
  std::optional<ModelAxis> up;            ///< empty if neither the file nor its format says
  Rig rig;                                ///< of the same vertices as `positions`
  SurfaceColours colours;                 ///< of the same faces as `corners`
};

/// Numbers the positions in the order in which faces first use them; unused ones come last. The last bits of
/// a simulation depend on it. Requires arrays whose `position_of_vertex` is empty, and fills it.
void number_by_first_use(ModelArrays& model);

/// The parts of a file that are read.
enum class ReadParts {
  shape,  ///< all but colours and texture coordinates
  model,  ///< all of a model
  image,  ///< the file is an image: SurfaceColours::maps holds it and all else is empty
};

/// The model as bytes, for another process of this program.
std::string encode(const ModelArrays& model);

/// The model from such bytes. The bytes are not trusted: every length is compared with what is there. Throws
/// std::runtime_error if they do not come from `encode`.
ModelArrays decode(const std::string& bytes);

}  // namespace taut::app
