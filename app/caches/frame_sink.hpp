#pragma once

#include "app/bodies/frame_source.hpp"
#include "app/models/garment_loading.hpp"
#include "app/output/output_pattern.hpp"
#include "renderer/frame_view.hpp"

namespace taut::app {

/// Settings of an export.
struct ExportSettings {
  std::string name;   ///< file name, or the pattern of several OBJ files
  FrameRange frames;  ///< frames to export, in this order; includes the frames of earlier runs
  double frame_rate_hz = 60.0;
  bool can_be_resumed = false;        ///< keeps incomplete files, so that another run can continue them
  std::optional<int> last_kept = {};  ///< last frame of the earlier run that this run continues
  renderer::SurfaceStyle look = {};   ///< used by formats that have materials
};

/// Writes the frames of a run to files for other programs. All functions throw InputError if writing fails. If a sink
/// is destroyed before `finish`, only complete files remain; incomplete ones remain if `can_be_resumed` is set.
class FrameSink {
 public:
  virtual ~FrameSink() = default;

  /// Adds the next frame. `shown_m`: positions of shown_mesh(), in metres.
  virtual void write(int frame, std::span<const sim::Vec3> shown_m) = 0;
  /// Saves the frames so far, so that they outlive the program. Called before a checkpoint is written.
  virtual void save_frames() {}
  /// Completes the files, which hold all frames or the frames before the run ended early. Returns a message about them,
  /// or an empty text.
  virtual std::string finish() = 0;
};

/// Returns true if one file of this name holds all frames as an animation.
bool is_clip(const std::string& name);

/// Returns every file that will be written, and makes their folder. Throws UsageError if the name does not end in .obj,
/// .pc2, .glb or .usda, or if the run can be resumed but the format cannot. Throws InputError if the folder cannot be
/// written to. Call it before a long run.
std::vector<std::filesystem::path> require_export(const ExportSettings& settings);

/// Opens a sink of the format that the name's ending gives. `loaded` must outlive the sink. `start_m`: positions of the
/// start or of the frame that an earlier run ended with. Throws InputError if the earlier run's file does not match
/// this run.
std::unique_ptr<FrameSink> open_sink(const ExportSettings& settings, const GarmentInScene& loaded,
                                     std::span<const sim::Vec3> start_m);

// Makers of the formats that open_sink() chooses from. `loaded` must outlive the sink.

/// Makes a sink for PC2, with an OBJ of the same vertices at rest beside it.
std::unique_ptr<FrameSink> make_point_cache_sink(const ExportSettings& settings, const GarmentInScene& loaded,
                                                 std::span<const sim::Vec3> start_m);

/// Makes a sink for one binary glTF 2.0 file with a morph target for each frame and an animation that plays them. It
/// keeps all frames in memory until the end. Throws InputError if they would take more than a gibibyte.
std::unique_ptr<FrameSink> make_gltf_sink(const ExportSettings& settings, const GarmentInScene& loaded);

/// Makes a sink for USD text: the faces of the model's file, their points as time samples, and the first of its
/// materials. The file has a temporary name until it is complete.
std::unique_ptr<FrameSink> make_usd_sink(const ExportSettings& settings, const GarmentInScene& loaded);

/// Returns NAME.obj for NAME.pc2.
std::filesystem::path obj_beside(const std::filesystem::path& cache);

/// A garment with the vertices and faces of its file, in the file's order. A grid or a subdivided garment has the
/// vertices and faces of the simulated mesh.
class WrittenCloth {
 public:
  /// `loaded` must outlive this object.
  explicit WrittenCloth(const GarmentInScene& loaded);

  std::size_t vertices() const { return mesh_vertex_.size(); }
  const FileFaces& faces() const { return faces_; }
  /// Returns the position of every vertex in metres, from the positions of shown_mesh(). A vertex that no remaining
  /// triangle uses keeps its position in the file.
  std::vector<sim::Vec3> positions(std::span<const sim::Vec3> shown_m) const;
  /// Returns the garment as an OBJ file, with normals of this shape if the file has normals.
  std::string obj(std::span<const sim::Vec3> shown_m) const;
  /// Returns the garment at rest as an OBJ file.
  std::string obj_at_rest() const { return obj(loaded_.shown_mesh().positions); }

 private:
  const GarmentInScene& loaded_;
  FileFaces faces_;
  std::vector<sim::Index> mesh_vertex_;  ///< mesh vertex of each written vertex; sim::no_vertex: none
};

/// Returns the unit normals of the mesh's vertices for these positions in metres.
std::vector<glm::vec3> mesh_normals(const sim::Mesh& mesh, std::span<const sim::Vec3> mesh_m);

}  // namespace taut::app
