#include "app/bodies/point_cache.hpp"

#include <charconv>

#include "app/base/errors.hpp"
#include "app/models/obj_reading.hpp"

namespace taut::app {
namespace {

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

namespace fs = std::filesystem;

constexpr std::string_view digits = "0123456789";

/// The parts of a sequence's names around their number.
struct Naming {
  std::string before;
  std::string after;
};

/// Of "body-%04d.obj"; empty if it is no such pattern.
std::optional<Naming> naming_of_pattern(const std::string& name) {
  const std::size_t percent = name.find('%');
  const std::size_t letter = name.find_first_not_of(digits, percent == std::string::npos ? percent : percent + 1);
  if (letter == std::string::npos || name[letter] != 'd') return std::nullopt;
  return Naming{name.substr(0, percent), name.substr(letter + 1)};
}

std::optional<long> number_in(const std::string& name, const Naming& naming) {
  const std::size_t around = naming.before.size() + naming.after.size();
  if (name.size() <= around || !name.starts_with(naming.before) || !name.ends_with(naming.after)) {
    return std::nullopt;
  }
  const char* const begin = name.data() + naming.before.size();
  const char* const end = name.data() + name.size() - naming.after.size();
  long number = 0;
  const auto [stopped, error] = std::from_chars(begin, end, number);
  return error == std::errc() && stopped == end && number >= 0 ? std::optional(number) : std::nullopt;
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    names.push_back(entry.path().filename().string());
  }
  if (error) throw InputError("cannot read the folder '" + folder.string() + "': " + error.message());
  std::ranges::sort(names);
  return names;
}

/// Returns the parts of the first OBJ file's name that ends with a number.
Naming naming_in(const fs::path& folder, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const std::string stem = fs::path(name).stem().string();
    const std::size_t last = stem.find_last_not_of(digits);
    const std::size_t first_digit = last == std::string::npos ? 0 : last + 1;
    if (name.ends_with(".obj") && first_digit < stem.size()) return {stem.substr(0, first_digit), ".obj"};
  }
  throw InputError("'" + folder.string() +
                   "': found no OBJ file with a number at the end of its name, expected a frame each, such "
                   "as body-0001.obj");
}

std::vector<fs::path> files_of(const fs::path& name) {
  const bool is_folder = fs::is_directory(name);
  const fs::path folder = is_folder ? name : name.has_parent_path() ? name.parent_path() : fs::path(".");
  const std::vector<std::string> names = names_in(folder);
  const Naming naming = is_folder ? naming_in(folder, names) : *naming_of_pattern(name.filename().string());
  std::map<long, fs::path> by_number;
  for (const std::string& file : names) {
    if (const auto number = number_in(file, naming)) by_number.emplace(*number, folder / file);
  }
  if (by_number.empty()) throw InputError("'" + name.string() + "': found no such files");
  std::vector<fs::path> files;
  for (const auto& [number, file] : by_number) {
    const long expected = by_number.begin()->first + static_cast<long>(files.size());
    if (number != expected) {
      throw InputError("'{}': found '{}' after number {}, expected number {}", name.string(), file.filename().string(),
                       expected - 1, expected);
    }
    files.push_back(file);
  }
  return files;
}

class ObjSequence final : public FrameSource {
 public:
  explicit ObjSequence(std::vector<fs::path> files) : files_(std::move(files)) {
    vertices_ = model_in(files_.front()).position_of_vertex.size();
  }

  std::size_t frames() const override { return files_.size(); }
  std::size_t vertices() const override { return vertices_; }
  std::optional<double> rate_hz() const override { return std::nullopt; }

  void read(std::size_t frame, std::span<sim::Vec3> positions) const override {
    const ModelArrays model = model_in(files_[frame]);
    if (model.position_of_vertex.size() != vertices_) {
      throw InputError("'{}': found {} vertices, expected the {} of '{}'", files_[frame].string(),
                       model.position_of_vertex.size(), vertices_, files_.front().string());
    }
    for (std::size_t v = 0; v < positions.size(); ++v) {
      positions[v] = model.positions[model.position_of_vertex[v]];
    }
  }

 private:
  static ModelArrays model_in(const fs::path& file) {
    const std::string text = read_text_file(file);
    try {
      if (std::optional<ModelArrays> model = read_obj(text)) return std::move(*model);
    } catch (const InputError& error) {
      throw InputError("'" + file.string() + "': " + error.what());
    }
    throw InputError("'" + file.string() + "': found no vertices, expected an OBJ file");
  }

  std::vector<fs::path> files_;
  std::size_t vertices_ = 0;
};

}  // namespace

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

bool names_obj_sequence(const fs::path& name) {
  std::error_code ignored;
  return naming_of_pattern(name.filename().string()) || fs::is_directory(name, ignored);
}

std::unique_ptr<const FrameSource> open_obj_sequence(const fs::path& name) {
  return std::make_unique<ObjSequence>(files_of(name));
}

}  // namespace taut::app
