#include "app/caches/frame_sink.hpp"

#include "app/base/errors.hpp"
#include "app/drawing/framing.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 4> endings = {".obj", ".pc2", ".glb", ".usda"};

[[noreturn]] void refuse(const std::string& name, const std::string& reason) {
  throw UsageError("output '" + name + "': " + reason);
}

/// Writes an OBJ of the last frame, or an OBJ of each frame.
class ObjSink final : public FrameSink {
 public:
  ObjSink(const ExportSettings& settings, const GarmentInScene& loaded)
      : pattern_(settings.name, ".obj"), range_(settings.frames), cloth_(loaded) {
    range_.first = pattern_.has_field() ? range_.first : range_.last;
    last_ = settings.last_kept.value_or(range_.first - 1);
  }

  void write(int frame, std::span<const sim::Vec3> shown_m) override {
    if (range_.contains(frame)) {
      write_text_file(pattern_.path_of(frame), cloth_.obj(shown_m));
      last_ = frame;
    }
  }

  std::string finish() override {
    std::vector<int> frames(static_cast<std::size_t>(std::max(last_ - range_.first + 1, 0)));
    std::iota(frames.begin(), frames.end(), range_.first);
    return describe_written(pattern_, frames);
  }

 private:
  OutputPattern pattern_;
  FrameRange range_;
  WrittenCloth cloth_;
  int last_ = 0;  ///< last frame that was written
};

}  // namespace

bool is_clip(const std::string& name) { return !name.empty() && fs::path(name).extension() != ".obj"; }

std::vector<fs::path> require_export(const ExportSettings& settings) {
  const fs::path name = settings.name;
  const std::string ending = name.extension();
  if (std::ranges::find(endings, ending) == endings.end()) {
    refuse(settings.name, "expected a file name that ends in .obj, .pc2, .glb or .usda");
  }
  if (ending != ".obj" && OutputPattern(settings.name, ending).has_field()) {
    refuse(settings.name, "one " + ending + " holds all frames; expected a name without {frame}");
  }
  if ((ending == ".glb" || ending == ".usda") && settings.can_be_resumed) {
    refuse(settings.name,
           "a " + ending +
               " is written when the run is over and cannot be gone on with; expected no --checkpoint and "
               "no --resume, or .pc2, or one .obj for each frame");
  }
  const OutputPattern pattern(settings.name, ending);
  std::vector<fs::path> files = {pattern.path_of(settings.frames.first)};
  prepare_parent_folder(files.front());
  for (int frame = settings.frames.first + 1; pattern.has_field() && frame <= settings.frames.last; ++frame) {
    files.push_back(pattern.path_of(frame));
  }
  if (ending == ".pc2") files.push_back(obj_beside(name));
  return files;
}

std::unique_ptr<FrameSink> open_sink(const ExportSettings& settings, const GarmentInScene& loaded,
                                     std::span<const sim::Vec3> start_m) {
  const std::string ending = fs::path(settings.name).extension();
  return ending == ".pc2"    ? make_point_cache_sink(settings, loaded, start_m)
         : ending == ".glb"  ? make_gltf_sink(settings, loaded)
         : ending == ".usda" ? make_usd_sink(settings, loaded)
                             : std::make_unique<ObjSink>(settings, loaded);
}

fs::path obj_beside(const fs::path& cache) { return fs::path(cache).replace_extension(".obj"); }

WrittenCloth::WrittenCloth(const GarmentInScene& loaded) : loaded_(loaded) {
  if (!loaded.file_faces.empty()) {
    faces_ = loaded.file_faces;
    mesh_vertex_ = loaded.following ? loaded.following->file_vertices.mesh_vertex : loaded.file_vertices.mesh_vertex;
    return;
  }
  faces_ = make_faces(loaded.shown_mesh(), loaded.colours.corner_uv);
  mesh_vertex_.resize(loaded.shown_mesh().positions.size());
  std::iota(mesh_vertex_.begin(), mesh_vertex_.end(), 0U);
}

std::vector<sim::Vec3> WrittenCloth::positions(std::span<const sim::Vec3> shown_m) const {
  std::vector<sim::Vec3> written_m(vertices());
  for (std::size_t v = 0; v < written_m.size(); ++v) {
    const sim::Index vertex = mesh_vertex_[v];
    written_m[v] = vertex == sim::no_vertex ? loaded_.file_rest_m[v] : shown_m[vertex];
  }
  return written_m;
}

std::string WrittenCloth::obj(std::span<const sim::Vec3> shown_m) const {
  std::vector<glm::vec3> normals;
  if (faces_.has_normals) {
    const std::vector<glm::vec3> of_mesh = mesh_normals(loaded_.shown_mesh(), shown_m);
    for (const sim::Index vertex : mesh_vertex_) {
      normals.push_back(vertex == sim::no_vertex ? glm::vec3(0.0F, 1.0F, 0.0F) : of_mesh[vertex]);
    }
  }
  return obj_text(faces_, positions(shown_m), normals);
}

std::vector<glm::vec3> mesh_normals(const sim::Mesh& mesh, std::span<const sim::Vec3> mesh_m) {
  std::vector<glm::vec3> normals(mesh_m.size());
  const std::vector<glm::vec3> places(mesh_m.begin(), mesh_m.end());
  renderer::vertex_normals(places, flat(mesh.triangles), normals);
  return normals;
}

}  // namespace taut::app
