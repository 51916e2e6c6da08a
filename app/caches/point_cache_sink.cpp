#include <fstream>

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/caches/frame_sink.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

class PointCacheSink final : public FrameSink {
 public:
  PointCacheSink(const ExportSettings& settings, const GarmentInScene& loaded, std::span<const sim::Vec3> start_m)
      : settings_(settings), cloth_(loaded), path_(settings.name) {
    incomplete_ = settings.can_be_resumed ? fs::path(settings.name + ".part") : temporary_name(path_);
    const int kept = settings.last_kept.value_or(0) - settings.frames.first + 1;
    if (settings.last_kept && kept > 0) {
      continue_file(static_cast<std::size_t>(kept), loaded.shown_m(start_m));
      return;
    }
    create_file(incomplete_, path_);
    file_.open(incomplete_, std::ios::binary | std::ios::trunc);
    put(header(static_cast<std::size_t>(settings.frames.count())));
  }

  ~PointCacheSink() override {
    std::error_code ignored;
    if (!settings_.can_be_resumed) fs::remove(incomplete_, ignored);
  }

  void write(int frame, std::span<const sim::Vec3> shown_m) override {
    if (settings_.frames.contains(frame)) {
      put(frame_of(shown_m));
      ++written_;
    }
  }

  void save_frames() override {
    file_.flush();
    put("");
  }

  std::string finish() override {
    const auto asked = static_cast<std::size_t>(settings_.frames.count());
    file_.close();
    put("");
    std::error_code error;
    if (written_ == 0) {
      fs::remove(incomplete_, error);
      return "wrote nothing";
    }
    if (written_ < asked) {
      open_at_end(written_);
      file_.close();
      put("");
    }
    write_text_file(obj_beside(path_), cloth_.obj_at_rest());
    rename_complete(incomplete_, path_);
    return fmt::format("wrote {}, {} of {} vertices, and {}, the rest shape that they move", path_.string(),
                       count_text(written_, "frame"), cloth_.vertices(), obj_beside(path_).string());
  }

 private:
  std::string header(std::size_t frames) const {
    return pc2_header({cloth_.vertices(), frames, settings_.frames.first});
  }

  std::string frame_of(std::span<const sim::Vec3> shown_m) const { return pc2_frame(cloth_.positions(shown_m)); }

  void put(const std::string& bytes) {
    file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!file_) fail_to_write(incomplete_, std::strerror(errno));
  }

  // Continues the incomplete file of an earlier run, or a copy of its complete file.
  void continue_file(std::size_t kept, std::span<const sim::Vec3> start_m) {
    std::error_code error;
    const SeekableFile earlier(fs::exists(incomplete_, error) ? incomplete_ : path_);
    const auto refuse = [&](const std::string& reason) {
      throw InputError("cannot go on with '" + earlier.path().string() + "': " + reason);
    };
    const std::string expected = frame_of(start_m);
    const std::optional<std::size_t> frames = pc2_frames(earlier);
    const std::uint64_t bytes = pc2_header_bytes + kept * expected.size();
    if (!frames || earlier.size() < bytes) {
      refuse(fmt::format("found {} bytes, expected {} for {} of {} vertices and more", earlier.size(), bytes,
                         count_text(kept, "frame"), cloth_.vertices()));
    }
    std::string begins(pc2_header_bytes, '\0');
    std::string last(expected.size(), '\0');
    earlier.read(0, begins);
    earlier.read(bytes - last.size(), last);
    if (begins != header(*frames) || last != expected) {
      refuse(fmt::format("its frame {} is not the one that the run goes on from", *settings_.last_kept));
    }
    if (earlier.path() != incomplete_) {
      const fs::path copy = temporary_name(incomplete_);
      fs::copy_file(path_, copy, fs::copy_options::overwrite_existing, error);
      if (error) fail_to_write(copy, error.message());
      rename_complete(copy, incomplete_);
    }
    fs::resize_file(incomplete_, bytes, error);
    if (error) fail_to_write(incomplete_, error.message());
    open_at_end(static_cast<std::size_t>(settings_.frames.count()));
    written_ = kept;
  }

  /// Opens the incomplete file at its end and writes this frame count to its header.
  void open_at_end(std::size_t frames) {
    file_.open(incomplete_, std::ios::binary | std::ios::in | std::ios::out);
    put(header(frames));
    file_.seekp(0, std::ios::end);
  }

  ExportSettings settings_;
  WrittenCloth cloth_;
  fs::path path_;
  fs::path incomplete_;  ///< incomplete file
  std::ofstream file_;
  std::size_t written_ = 0;  ///< frames written so far
};

}  // namespace

std::unique_ptr<FrameSink> make_point_cache_sink(const ExportSettings& settings, const GarmentInScene& loaded,
                                                 std::span<const sim::Vec3> start_m) {
  return std::make_unique<PointCacheSink>(settings, loaded, start_m);
}

}  // namespace taut::app
