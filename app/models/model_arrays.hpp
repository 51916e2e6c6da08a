#pragma once

#include "app/models/file_mesh.hpp"
#include "app/models/rig.hpp"
#include "app/models/surface_colours.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {

/// A model file as flat arrays: the faces of all its meshes, at the places their nodes give them.
struct ModelArrays {
  std::vector<sim::Vec3> positions;  ///< in the file's unit and axes
  FileFaces faces;                   ///< with indices into `positions`, without texture coordinates
  /// Index into `positions` for each vertex of the file. Empty if the order is the same.
  std::vector<sim::Index> position_of_vertex;
  std::string format;  ///< name of the format, from the reader
  std::size_t meshes = 0;
  std::size_t ignored_lines = 0;
  std::size_t ignored_points = 0;
  std::optional<double> metres_per_unit;  ///< empty if neither the file nor its format says
  std::optional<ModelAxis> up;            ///< empty if neither the file nor its format says
  Rig rig;                                ///< of the same vertices as `positions`
  SurfaceColours colours;                 ///< of the same faces
  std::vector<std::string> files;         ///< that were read: the model's own and those that it names
  bool is_importer_confined = true;       ///< false: its reader could read other files of the user
};

/// Numbers the positions in the order in which faces first use them; unused ones come last. The last bits of
/// a simulation depend on it. Requires arrays whose `position_of_vertex` is empty, and fills it.
void number_by_first_use(ModelArrays& model);

/// What is told where an importer is not confined.
inline constexpr const char* importer_remark =
    "its reader could read other files of this user: this kernel has no Landlock (Linux 5.13)";

/// The parts of a file that are read.
enum class ReadParts {
  shape,  ///< all but colours and texture coordinates
  model,  ///< all of a model
  image,  ///< the file is an image: SurfaceColours::maps holds it and all else is empty
};

/// The model as bytes, for another process of this program.
std::string encode(const ModelArrays& model);

/// The model from such bytes. The bytes are not trusted: every length is compared with what is there, indices with what
/// they count, numbers with the range that can be simulated; colours out of range are mended. Throws std::runtime_error
/// if they do not come from `encode`, or from a model with positions or joints that are not finite.
ModelArrays decode(const std::string& bytes);

/// Reads the text of a Wavefront OBJ file in double precision. Assimp reads it in single precision, which
/// would change rest lengths by more than the smallest bounds on stretch.
///
/// Vertices are numbered by number_by_first_use(). Of materials the names are read (read_mtl());
/// texture coordinates that are damaged are (0, 0). Of normals it is kept that there are some; free-form
/// surfaces are ignored. Points, lines and faces of one or two corners are counted. Empty if no line defines
/// a vertex: then it is another kind of file. Throws InputError that names the line, what was found and what
/// was expected.
std::optional<ModelArrays> read_obj(std::string_view text);

/// Reads an OBJ file, or any other format of the assimp library, in this process. A damaged file can crash
/// the process, so programs call import_garment() instead. So may a damaged image. Throws InputError with the
/// reason, without the file name.
ModelArrays read_model(const std::filesystem::path& path, ReadParts parts);

/// Reads base colours and the names of their images from the text of an OBJ's material library into the
/// materials of these names: Kd and map_Kd. Damaged entries are passed over.
void read_mtl(std::string_view text, SurfaceColours& colours);

}  // namespace taut::app
