#include "app/caches/frame_sink.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/caches/written_cloth.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 5> endings = {".obj", ".pc2", ".mdd", ".glb", ".pvd"};

[[noreturn]] void refuse(const std::string& name, const std::string& reason) {
  throw UsageError("output '" + name + "': " + reason);
}

/// Every file but those of later frames.
std::vector<fs::path> files_of(const ExportSettings& settings) {
  const fs::path name = settings.name;
  const std::string ending = name.extension();
  std::vector<fs::path> files = {OutputPattern(settings.name, ending).path_of(settings.frames.first)};
  if (ending == ".pc2" || ending == ".mdd") {
    files.push_back(obj_beside(name));
  } else if (ending == ".pvd") {
    files.push_back(vtp_beside(name, settings.frames.first));
  }
  return files;
}

class ObjSink final : public FrameSink {
 public:
  ObjSink(const ExportSettings& settings, const GarmentInScene& loaded)
      : pattern_(settings.name, ".obj"), range_(settings.frames), cloth_(loaded) {
    range_.first = pattern_.has_field() ? range_.first : range_.last;
    last_ = settings.last_kept.value_or(range_.first - 1);
  }

  void write(int frame, const WrittenMoment& moment) override {
    if (range_.contains(frame)) {
      write_text_file(pattern_.path_of(frame), cloth_.obj(moment.state.current));
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
  int last_ = 0;  ///< frame that was written
};

}  // namespace

const char* const export_help =
    "write the shape of each of these frames, in metres with y up and in the vertices, faces and groups of "
    "the model's file; the name's ending says how: shapes/{frame:04}.obj, or end.obj for the last of them; "
    "clip.pc2 or clip.mdd, with clip.obj beside it, the rest shape that they move (in Blender import that, "
    "and add a Mesh Cache modifier: Forward +Y, Up +Z); clip.glb, which plays in any viewer; clip.pvd for "
    "ParaView, with the simulated triangles and their stretch; bodies are not written";

bool is_clip(const std::string& name) {
  return !name.empty() && fs::path(name).extension() != ".obj";
}

void require_export(const ExportSettings& settings, const fs::path& garment) {
  const fs::path name = settings.name;
  const std::string ending = name.extension();
  if (std::find(endings.begin(), endings.end(), ending) == endings.end()) {
    refuse(settings.name, "expected a file name that ends in .obj, .pc2, .mdd, .glb or .pvd");
  }
  if (ending != ".obj" && OutputPattern(settings.name, ending).has_field()) {
    refuse(settings.name, "one " + ending + " holds all frames; expected a name without {frame}");
  }
  if (ending == ".glb" && settings.can_be_resumed) {
    refuse(
        settings.name,
        "a .glb is written when the run is over and cannot be gone on with; expected no --checkpoint and no "
        "--resume, or .pc2, .mdd, .pvd or one .obj for each frame");
  }
  for (const fs::path& file : files_of(settings)) {
    std::error_code error;
    if (!garment.empty() && fs::equivalent(file, garment, error)) {
      refuse(settings.name, "it would replace the garment's own file, '" + file.string() + "'");
    }
    prepare_folder_of(file);
  }
}

int most_frames(const std::string& name, const GarmentInScene& loaded) {
  constexpr int of_an_hour = 3600 * 60;  // an MDD has a time for each ahead of the first
  return fs::path(name).extension() == ".glb" ? most_gltf_frames(loaded) : of_an_hour;
}

std::unique_ptr<FrameSink> open_sink(const ExportSettings& settings, const GarmentInScene& loaded,
                                     const WrittenMoment& start) {
  const std::string ending = fs::path(settings.name).extension();
  if (ending == ".pc2" || ending == ".mdd") {
    const PointCacheFormat format = ending == ".pc2" ? PointCacheFormat::pc2 : PointCacheFormat::mdd;
    return make_point_cache_sink(format, settings, loaded, start);
  }
  return ending == ".glb"   ? make_gltf_sink(settings, loaded)
         : ending == ".pvd" ? make_vtk_sink(settings)
                            : make_obj_sink(settings, loaded);
}

fs::path obj_beside(const fs::path& cache) {
  return fs::path(cache).replace_extension(".obj");
}

std::unique_ptr<FrameSink> make_obj_sink(const ExportSettings& settings, const GarmentInScene& loaded) {
  return std::make_unique<ObjSink>(settings, loaded);
}

}  // namespace taut::app
