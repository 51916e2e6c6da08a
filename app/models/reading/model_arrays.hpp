#pragma once

#include "app/models/reading/file_mesh.hpp"
#include "app/models/reading/rig.hpp"
#include "app/models/reading/surface_colours.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {

/// A model file as flat arrays: the faces of all its meshes, placed by their nodes.
struct ModelArrays {
  std::vector<sim::Vec3> positions;  ///< positions in the file's unit and axes
  FileFaces faces;                   ///< faces with indices into `positions`, without texture coordinates
  /// Index into `positions` for each vertex of the file. Empty if the order is the same.
  std::vector<sim::Index> position_of_vertex;
  std::string format;  ///< name of the format, from the reader
  std::size_t meshes = 0;
  std::size_t ignored_lines = 0;
  std::size_t ignored_points = 0;
  std::optional<double> metres_per_unit;  ///< empty if neither the file nor its format says
  std::optional<ModelAxis> up;            ///< empty if neither the file nor its format says
  Rig rig;                                ///< rig of the vertices in `positions`
  SurfaceColours colours;                 ///< colours of `faces`
  std::vector<std::string> files;         ///< files that were read: the model's own and the files that it names
  bool is_importer_confined = true;       ///< false if its reader could read other files of the user
};

/// Numbers the positions in the order in which faces first use them; unused ones come last. The last bits of a
/// simulation depend on this order. Requires arrays whose `position_of_vertex` is empty, and fills it.
void number_by_first_use(ModelArrays& model);

/// Remark for an importer that is not confined.
inline constexpr const char* importer_remark =
    "its reader could read other files of this user: this kernel has no Landlock (Linux 5.13)";

/// Parts of a file that are read.
enum class ReadParts {
  shape,  ///< all but colours and texture coordinates
  model,  ///< all of a model
  image,  ///< the file is an image: SurfaceColours::maps holds it and all else is empty
};

/// Returns the model as bytes, for another process of this program.
std::string encode(const ModelArrays& model);

/// Returns the model from such bytes. The bytes are not trusted: every length is compared with the bytes that are left,
/// indices with the lists that they refer to, numbers with the range that can be simulated. Colours out of range are
/// mended. Throws std::runtime_error if the bytes do not come from `encode`, or come from a model with positions or
/// joints that are not finite.
ModelArrays decode(const std::string& bytes);

/// Reads the text of a Wavefront OBJ file in double precision. Assimp reads it in single precision, which
/// would change rest lengths by more than the smallest bounds on stretch.
///
/// Vertices are numbered by number_by_first_use(). Only the names of materials are read (read_mtl() reads the rest).
/// Damaged texture coordinates become (0, 0). Normals are not read, but recorded as present. Free-form surfaces are
/// ignored. Points, lines and faces of one or two corners are counted. Returns nothing if no line defines a vertex: the
/// file is then of another kind. Throws InputError that names the line, and the found and the expected text.
std::optional<ModelArrays> read_obj(std::string_view text);

/// Reads an OBJ file, or any other format of the assimp library, in this process. A damaged file or image can crash the
/// process, so that programs call import_garment() instead. Throws InputError with the reason, without the file name.
ModelArrays read_model(const std::filesystem::path& path, ReadParts parts);

/// Reads base colours and the names of their images (Kd and map_Kd) from the text of an OBJ's material library into the
/// materials of these names. Damaged entries are skipped.
void read_mtl(std::string_view text, SurfaceColours& colours);

}  // namespace taut::app
