#include "app/bodies/frame_source.hpp"

#include "app/base/errors.hpp"
#include "app/verify/crossing_pairs.hpp"

namespace taut::app {
namespace {

/// A step of the simulation needs two frames at its begin and two at its end, and a picture two more.
constexpr std::size_t most_remembered = 6;

constexpr std::string_view pc2_signature{"POINTCACHE2", 12};  // with the zero at its end
constexpr std::size_t pc2_header_bytes = 32;
constexpr std::size_t pc2_count_at = 28;  // of the frames
constexpr std::size_t mdd_header_bytes = 8;
constexpr std::size_t number_bytes = 4;
constexpr std::size_t position_bytes = 3 * number_bytes;

std::uint32_t number_at(const char* bytes, std::endian order) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < number_bytes; ++k) {
    const std::size_t place = order == std::endian::big ? k : number_bytes - 1 - k;
    value = value << 8U | static_cast<std::uint8_t>(bytes[place]);
  }
  return value;
}

double real_at(const char* bytes, std::endian order) {
  return static_cast<double>(std::bit_cast<float>(number_at(bytes, order)));
}

void put_number(std::uint32_t value, std::endian order, std::string& bytes) {
  const auto little = sim::little_endian(value);
  order == std::endian::little ? bytes.append(little.begin(), little.end())
                               : bytes.append(little.rbegin(), little.rend());
}

void put_real(double value, std::endian order, std::string& bytes) {
  put_number(std::bit_cast<std::uint32_t>(static_cast<float>(value)), order, bytes);
}

std::endian order_of(PointCacheFormat format) {
  return format == PointCacheFormat::pc2 ? std::endian::little : std::endian::big;
}

/// Where the frames are in a cache.
struct Layout {
  std::size_t header_bytes = 0;
  std::size_t frames = 0;
  std::size_t vertices = 0;
  std::endian order = std::endian::little;
  std::optional<double> rate_hz = {};
};

[[noreturn]] void refuse(const SeekableFile& file, const std::string& reason) {
  throw InputError("cannot read frames from '" + file.path().string() + "': " + reason);
}

class PointCache final : public FrameSource {
 public:
  PointCache(SeekableFile file, Layout layout) : file_(std::move(file)), layout_(layout) {
    const std::uint64_t expected = layout.header_bytes + layout.frames * layout.vertices * position_bytes;
    if (file_.size() != expected) {
      refuse(file_, fmt::format("found {} bytes, expected {} for {} frames of {} vertices", file_.size(), expected,
                                layout.frames, layout.vertices));
    }
  }

  std::size_t frames() const override { return layout_.frames; }
  std::size_t vertices() const override { return layout_.vertices; }
  std::optional<double> rate_hz() const override { return layout_.rate_hz; }

  void read(std::size_t frame, std::span<sim::Vec3> positions) const override {
    std::vector<char> bytes(layout_.vertices * position_bytes);
    file_.read(layout_.header_bytes + frame * bytes.size(), bytes);
    const char* at = bytes.data();
    for (sim::Vec3& position : positions) {
      for (int axis = 0; axis < 3; ++axis, at += number_bytes) position[axis] = real_at(at, layout_.order);
    }
  }

 private:
  SeekableFile file_;
  Layout layout_;
};

std::string beginning_of(const SeekableFile& file, std::size_t bytes) {
  std::string text(std::min<std::uint64_t>(bytes, file.size()), '\0');
  file.read(0, text);
  return text;
}

std::size_t count_in(const SeekableFile& file, const std::string& header, std::size_t offset, const char* what) {
  const auto count = static_cast<std::int32_t>(number_at(header.data() + offset, std::endian::big));
  if (count < 1 || count > sim::most_counted) {
    refuse(file, fmt::format("byte {}, {}: found {}, expected 1 to {}", offset, what, count, sim::most_counted));
  }
  return static_cast<std::size_t>(count);
}

/// Returns the rate by the times of the first and the last frame. Frames at equal times have none.
std::optional<double> rate_of_times(const SeekableFile& file, std::size_t frames) {
  std::array<char, number_bytes> first = {};
  std::array<char, number_bytes> last = {};
  file.read(mdd_header_bytes, first);
  file.read(mdd_header_bytes + (frames - 1) * number_bytes, last);
  const double length_s = real_at(last.data(), std::endian::big) - real_at(first.data(), std::endian::big);
  return length_s > 0.0 ? std::optional(static_cast<double>(frames - 1) / length_s) : std::nullopt;
}

}  // namespace

PlacedFrames::PlacedFrames(std::filesystem::path motion, std::unique_ptr<const FrameSource> source,
                           FileVertexPlaces places, double rate_hz, std::size_t first)
    : motion_(std::move(motion)),
      source_(std::move(source)),
      places_(std::move(places)),
      rate_hz_(rate_hz),
      first_(first) {}

void PlacedFrames::positions_in(std::size_t frame, std::span<sim::Vec3> positions_m) const {
  const Positions placed_m = placed(frame);
  std::copy(placed_m->begin(), placed_m->end(), positions_m.begin());
}

// Reading is left unlocked: two threads may read the same frame, and both get the same.
PlacedFrames::Positions PlacedFrames::placed(std::size_t frame) const {
  if (Positions known = remembered(frame)) return known;
  Positions positions_m = read(frame);
  if (const Positions before_m = frame > 0 ? remembered(frame - 1) : nullptr) {
    require_near(frame, before_m, positions_m);
  }
  if (const Positions after_m = remembered(frame + 1)) require_near(frame + 1, positions_m, after_m);
  const std::lock_guard lock(mutex_);
  if (remembered_.size() == most_remembered) remembered_.erase(remembered_.begin());
  remembered_.push_back({frame, positions_m});
  return positions_m;
}

PlacedFrames::Positions PlacedFrames::remembered(std::size_t frame) const {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find(remembered_, frame, &Remembered::frame);
  return found == remembered_.end() ? nullptr : found->positions_m;
}

PlacedFrames::Positions PlacedFrames::read(std::size_t frame) const {
  std::vector<sim::Vec3> in_file(source_->vertices());
  source_->read(first_ + frame, in_file);
  std::vector<sim::Vec3> positions_m;
  positions_m.reserve(places_.file_vertex.size());
  for (const std::size_t v : places_.file_vertex) {
    const sim::Vec3& position_m = positions_m.emplace_back(places_.placement(in_file[v]));
    if (!std::isfinite(position_m.x + position_m.y + position_m.z)) {
      refuse(frame, v, fmt::format("found at {}, expected numbers", describe_point(in_file[v])));
    }
  }
  return std::make_shared<const std::vector<sim::Vec3>>(std::move(positions_m));
}

void PlacedFrames::require_near(std::size_t frame, const Positions& before_m, const Positions& after_m) const {
  for (std::size_t v = 0; v < after_m->size(); ++v) {
    const double moved_m = glm::distance((*before_m)[v], (*after_m)[v]);
    if (!(moved_m <= furthest_in_frame_m)) {
      refuse(frame, places_.file_vertex[v],
             fmt::format("found at {} m, {:.3g} m from where it is in the frame before, expected at most {:g} m",
                         describe_point((*after_m)[v]), moved_m, furthest_in_frame_m));
    }
  }
}

void PlacedFrames::refuse(std::size_t frame, std::size_t vertex, const std::string& reason) const {
  throw InputError("'{}': frame {}, vertex {}: {}", motion_.string(), first_ + frame, vertex, reason);
}

std::unique_ptr<const FrameSource> open_pc2(const std::filesystem::path& path) {
  SeekableFile file(path);
  const std::string header = beginning_of(file, pc2_header_bytes);
  Layout layout{.header_bytes = pc2_header_bytes};
  try {
    sim::ByteReader in(header);
    in.require_text("what the file is", pc2_signature);
    in.get<std::int32_t>("the version", 1, 1);
    layout.vertices = static_cast<std::size_t>(in.get<std::int32_t>("the number of vertices", 1, sim::most_counted));
    in.get<float>("the first frame");
    in.get<float>("the rate");
    layout.frames = static_cast<std::size_t>(in.get<std::int32_t>("the number of frames", 1, sim::most_counted));
  } catch (const sim::BadBytes& error) {
    refuse(file, error.what());
  }
  return std::make_unique<PointCache>(std::move(file), layout);
}

std::unique_ptr<const FrameSource> open_mdd(const std::filesystem::path& path) {
  SeekableFile file(path);
  const std::string header = beginning_of(file, mdd_header_bytes);
  if (header.size() < mdd_header_bytes) {
    refuse(file, fmt::format("found {} bytes, expected the numbers of frames and of points", header.size()));
  }
  Layout layout{.order = std::endian::big};
  layout.frames = count_in(file, header, 0, "the number of frames");
  layout.vertices = count_in(file, header, number_bytes, "the number of points");
  layout.header_bytes = point_cache_header_bytes(PointCacheFormat::mdd, layout.frames);
  if (file.size() >= layout.header_bytes) layout.rate_hz = rate_of_times(file, layout.frames);
  return std::make_unique<PointCache>(std::move(file), layout);
}

std::string point_cache_header(PointCacheFormat format, const PointCacheContent& content) {
  std::string bytes;
  const std::endian order = order_of(format);
  const auto vertices = static_cast<std::uint32_t>(content.vertices);
  const auto frames = static_cast<std::uint32_t>(content.frames);
  if (format == PointCacheFormat::pc2) {
    bytes = pc2_signature;
    put_number(1, order, bytes);
    put_number(vertices, order, bytes);
    put_real(content.first_frame, order, bytes);
    put_real(1.0, order, bytes);  // one for each frame
    put_number(frames, order, bytes);
    return bytes;
  }
  put_number(frames, order, bytes);
  put_number(vertices, order, bytes);
  for (std::uint32_t k = 0; k < frames; ++k) {
    put_real((content.first_frame + static_cast<double>(k)) / content.frame_rate_hz, order, bytes);
  }
  return bytes;
}

std::size_t point_cache_header_bytes(PointCacheFormat format, std::size_t frames) {
  return format == PointCacheFormat::pc2 ? pc2_header_bytes : mdd_header_bytes + frames * number_bytes;
}

std::string point_cache_frame(PointCacheFormat format, std::span<const sim::Vec3> positions) {
  std::string bytes;
  bytes.reserve(positions.size() * position_bytes);
  for (const sim::Vec3& position : positions) {
    for (int axis = 0; axis < 3; ++axis) put_real(position[axis], order_of(format), bytes);
  }
  return bytes;
}

std::size_t point_cache_frame_bytes(std::size_t vertices) { return vertices * position_bytes; }

std::optional<std::size_t> point_cache_frames(PointCacheFormat format, const SeekableFile& file) {
  const std::size_t at = format == PointCacheFormat::pc2 ? pc2_count_at : 0;
  std::array<char, number_bytes> bytes = {};
  if (file.size() < at + bytes.size()) return std::nullopt;
  file.read(at, bytes);
  const std::size_t frames = number_at(bytes.data(), order_of(format));
  return frames <= sim::most_counted ? std::optional(frames) : std::nullopt;
}

}  // namespace taut::app
