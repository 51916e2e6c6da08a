#include <fstream>

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/caches/frame_sink.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

class PointCacheSink final : public FrameSink {
 public:
  PointCacheSink(PointCacheFormat format, const ExportSettings& settings, const GarmentInScene& loaded,
                 const WrittenMoment& start);
  ~PointCacheSink() override;
  PointCacheSink(const PointCacheSink&) = delete;
  PointCacheSink& operator=(const PointCacheSink&) = delete;

  void write(int frame, const WrittenMoment& moment) override;
  void keep() override;
  std::string finish() override;

 private:
  std::string header(std::size_t frames) const;
  std::string frame_of(const WrittenMoment& moment) const;
  void put(const std::string& bytes);
  void go_on(std::size_t kept, const WrittenMoment& start);
  void copy(const fs::path& from, std::size_t header_bytes, std::size_t frames, const std::string& header);

  PointCacheFormat format_;
  ExportSettings settings_;
  WrittenCloth cloth_;
  fs::path path_;
  fs::path part_;  ///< what is not complete yet
  std::ofstream file_;
  std::size_t written_ = 0;  ///< frames
};

PointCacheSink::PointCacheSink(PointCacheFormat format, const ExportSettings& settings, const GarmentInScene& loaded,
                               const WrittenMoment& start)
    : format_(format), settings_(settings), cloth_(loaded), path_(settings.name) {
  part_ = settings.can_be_resumed ? fs::path(settings.name + ".part") : temporary_name(path_);
  const int kept = settings.last_kept.value_or(0) - settings.frames.first + 1;
  if (settings.last_kept && kept > 0) {
    go_on(static_cast<std::size_t>(kept), start);
    return;
  }
  file_.open(part_, std::ios::binary | std::ios::trunc);
  put(header(static_cast<std::size_t>(settings.frames.count())));
}

PointCacheSink::~PointCacheSink() {
  std::error_code ignored;
  if (!settings_.can_be_resumed) fs::remove(part_, ignored);
}

std::string PointCacheSink::header(std::size_t frames) const {
  return point_cache_header(format_, {cloth_.vertices(), frames, settings_.frames.first, settings_.frame_rate_hz});
}

std::string PointCacheSink::frame_of(const WrittenMoment& moment) const {
  return point_cache_frame(format_, cloth_.positions(moment.state.current));
}

void PointCacheSink::put(const std::string& bytes) {
  file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file_) fail_to_write(part_, std::strerror(errno));
}

// Goes on from the part that an earlier run left, or from its complete file.
void PointCacheSink::go_on(std::size_t kept, const WrittenMoment& start) {
  std::error_code error;
  const SeekableFile earlier(fs::exists(part_, error) ? part_ : path_);
  const auto refuse = [&](const std::string& reason) {
    throw InputError("cannot go on with '" + earlier.path().string() + "': " + reason);
  };
  const std::string expected = frame_of(start);
  const std::optional<std::size_t> frames = point_cache_frames(format_, earlier);
  const std::size_t header_bytes = point_cache_header_bytes(format_, frames.value_or(0));
  const std::uint64_t bytes = header_bytes + kept * expected.size();
  if (!frames || earlier.size() < bytes) {
    refuse(fmt::format("found {} bytes, expected {} for {} of {} vertices and more", earlier.size(), bytes,
                       counted(kept, "frame"), cloth_.vertices()));
  }
  std::string begins(header_bytes, '\0');
  std::string last(expected.size(), '\0');
  earlier.read(0, begins);
  earlier.read(bytes - last.size(), last);
  if (begins != header(*frames) || last != expected) {
    refuse(fmt::format("its frame {} is not the one that the run goes on from", *settings_.last_kept));
  }
  copy(earlier.path(), header_bytes, kept, header(static_cast<std::size_t>(settings_.frames.count())));
  file_.open(part_, std::ios::binary | std::ios::app);
  written_ = kept;
}

// The part with another header, and with so many frames of a file.
void PointCacheSink::copy(const fs::path& from, std::size_t header_bytes, std::size_t frames,
                          const std::string& header) {
  const SeekableFile source(from);
  const fs::path target = temporary_name(part_);
  std::string frame(point_cache_frame_bytes(cloth_.vertices()), '\0');
  try {
    file_.open(target, std::ios::binary | std::ios::trunc);
    put(header);
    for (std::size_t k = 0; k < frames; ++k) {
      source.read(header_bytes + k * frame.size(), frame);
      put(frame);
    }
    file_.close();
    put("");
    put_in_place(target, part_);
  } catch (...) {
    std::error_code ignored;
    fs::remove(target, ignored);
    throw;
  }
}

void PointCacheSink::write(int frame, const WrittenMoment& moment) {
  if (settings_.frames.contains(frame)) {
    put(frame_of(moment));
    ++written_;
  }
}

void PointCacheSink::keep() {
  file_.flush();
  put("");
}

std::string PointCacheSink::finish() {
  const auto asked = static_cast<std::size_t>(settings_.frames.count());
  file_.close();
  put("");
  std::error_code error;
  if (written_ == 0) {
    fs::remove(part_, error);
    return "wrote nothing";
  }
  if (written_ < asked) copy(part_, point_cache_header_bytes(format_, asked), written_, header(written_));
  write_text_file(obj_beside(path_), cloth_.obj_at_rest());
  put_in_place(part_, path_);
  return fmt::format("wrote {}, {} of {} vertices, and {}, the rest shape that they move", path_.string(),
                     counted(written_, "frame"), cloth_.vertices(), obj_beside(path_).string());
}

}  // namespace

std::unique_ptr<FrameSink> make_point_cache_sink(PointCacheFormat format, const ExportSettings& settings,
                                                 const GarmentInScene& loaded, const WrittenMoment& start) {
  return std::make_unique<PointCacheSink>(format, settings, loaded, start);
}

}  // namespace taut::app
