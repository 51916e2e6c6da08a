#pragma once

#include "app/bodies/frame_source.hpp"
#include "app/models/garment_loading.hpp"
#include "app/output/output_pattern.hpp"
#include "renderer/frame_view.hpp"

namespace taut::app {

/// Things to be written.
struct ExportSettings {
  std::string name;   ///< of the file; the pattern of several OBJ files
  FrameRange frames;  ///< those that will be handed out, in this order; earlier runs' frames included
  double frame_rate_hz = 60.0;
  bool can_be_resumed = false;        ///< what is incomplete stays for a run that goes on
  std::optional<int> last_kept = {};  ///< goes on after this frame of an earlier run
  renderer::SurfaceStyle look = {};   ///< for formats that say it
};

/// Where the frames of a run go: files that other programs read. All functions throw InputError if something
/// cannot be written. A sink that is destroyed before `finish` leaves complete files alone, and what
/// `can_be_resumed` asks for.
class FrameSink {
 public:
  virtual ~FrameSink() = default;

  /// Takes the next frame: where the vertices of the simulated mesh are, in m.
  virtual void write(int frame, std::span<const sim::Vec3> mesh_m) = 0;
  /// Called before a checkpoint of the frame is written: what came so far must survive the program.
  virtual void keep() {}
  /// Completes what was written, of all frames or of those before the run ended. Returns what that is, for
  /// people, or nothing.
  virtual std::string finish() = 0;
};

/// Whether one file of this name holds all frames, to be played.
bool is_clip(const std::string& name);

/// Returns every file that will be written. Throws UsageError if a name has another ending than .obj, .pc2, .glb or
/// .usda, or if its format cannot be resumed and shall be. Makes the folder; throws InputError if that cannot be
/// written to. Call it before a long run.
std::vector<std::filesystem::path> require_export(const ExportSettings& settings);

/// Opens what the name's ending says. `loaded` must outlive the sink. `start_m` is where the run begins or goes
/// on. Throws InputError if what an earlier run left is not of this one.
std::unique_ptr<FrameSink> open_sink(const ExportSettings& settings, const GarmentInScene& loaded,
                                     std::span<const sim::Vec3> start_m);

// The formats behind open_sink(), which see. `loaded` must outlive them.

/// PC2, and beside it an OBJ of the same vertices at rest.
std::unique_ptr<FrameSink> make_point_cache_sink(const ExportSettings& settings, const GarmentInScene& loaded,
                                                 std::span<const sim::Vec3> start_m);

/// One binary glTF 2.0 with a morph target for each frame and an animation that plays them. It holds them in
/// memory until the end. Throws InputError if they would be more than a gibibyte.
std::unique_ptr<FrameSink> make_gltf_sink(const ExportSettings& settings, const GarmentInScene& loaded);

/// USD as text: the faces of the model's file, their points as time samples, the first of its materials. It is under
/// another name until the end.
std::unique_ptr<FrameSink> make_usd_sink(const ExportSettings& settings, const GarmentInScene& loaded);

/// NAME.obj beside NAME.pc2.
std::filesystem::path obj_beside(const std::filesystem::path& cache);

/// A garment with the vertices and faces of its file, in their order, as other programs know it. Of a grid,
/// and of a garment that was subdivided, those of the simulated mesh.
class WrittenCloth {
 public:
  /// `loaded` must outlive this object.
  explicit WrittenCloth(const GarmentInScene& loaded);

  std::size_t vertices() const { return mesh_vertex_.size(); }
  const FileFaces& faces() const { return faces_; }
  /// Returns the position of every vertex, in m, from those of the mesh. A vertex that no remaining triangle
  /// uses is where the file has it.
  std::vector<sim::Vec3> positions(std::span<const sim::Vec3> mesh_m) const { return written(loaded_.shown_m(mesh_m)); }
  /// Returns the garment as an OBJ file, with normals of this shape where the file has some.
  std::string obj(std::span<const sim::Vec3> mesh_m) const { return text(loaded_.shown_m(mesh_m)); }
  /// Returns it at rest.
  std::string obj_at_rest() const { return text(loaded_.shown_mesh().positions); }

 private:
  std::vector<sim::Vec3> written(std::span<const sim::Vec3> shown_m) const;
  std::string text(std::span<const sim::Vec3> shown_m) const;

  const GarmentInScene& loaded_;
  FileFaces faces_;
  std::vector<sim::Index> mesh_vertex_;  ///< per vertex written; sim::no_vertex: none
};

/// Returns unit normals per vertex of the mesh in this shape, in m.
std::vector<glm::vec3> mesh_normals(const sim::Mesh& mesh, std::span<const sim::Vec3> mesh_m);

}  // namespace taut::app
