#include "app/bodies/obj_sequence.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/models/obj_reading.hpp"

namespace taut::app {
namespace {

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
  const std::size_t letter =
      name.find_first_not_of(digits, percent == std::string::npos ? percent : percent + 1);
  if (letter == std::string::npos || name[letter] != 'd') {
    return std::nullopt;
  }
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
  if (error) {
    throw InputError("cannot read the folder '" + folder.string() + "': " + error.message());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Returns the parts of the first OBJ file's name that ends with a number.
Naming naming_in(const fs::path& folder, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const std::string stem = fs::path(name).stem().string();
    const std::size_t last = stem.find_last_not_of(digits);
    const std::size_t first_digit = last == std::string::npos ? 0 : last + 1;
    if (name.ends_with(".obj") && first_digit < stem.size()) {
      return {stem.substr(0, first_digit), ".obj"};
    }
  }
  throw InputError(
      "'" + folder.string() +
      "': found no OBJ file with a number at the end of its name, expected a frame each, such as "
      "body-0001.obj");
}

std::vector<fs::path> files_of(const fs::path& name) {
  const bool is_folder = fs::is_directory(name);
  const fs::path folder = is_folder ? name : name.has_parent_path() ? name.parent_path() : fs::path(".");
  const std::vector<std::string> names = names_in(folder);
  const Naming naming = is_folder ? naming_in(folder, names) : *naming_of_pattern(name.filename().string());
  std::map<long, fs::path> by_number;
  for (const std::string& file : names) {
    if (const auto number = number_in(file, naming)) {
      by_number.emplace(*number, folder / file);
    }
  }
  if (by_number.empty()) {
    throw InputError("'" + name.string() + "': found no such files");
  }
  std::vector<fs::path> files;
  for (const auto& [number, file] : by_number) {
    const long expected = by_number.begin()->first + static_cast<long>(files.size());
    if (number != expected) {
      throw InputError(fmt::format("'{}': found '{}' after number {}, expected number {}", name.string(),
                                   file.filename().string(), expected - 1, expected));
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
      throw InputError(fmt::format("'{}': found {} vertices, expected the {} of '{}'", files_[frame].string(),
                                   model.position_of_vertex.size(), vertices_, files_.front().string()));
    }
    for (std::size_t v = 0; v < positions.size(); ++v) {
      positions[v] = model.positions[model.position_of_vertex[v]];
    }
  }

 private:
  static ModelArrays model_in(const fs::path& file) {
    const std::string text = read_text_file(file);
    try {
      if (std::optional<ModelArrays> model = read_obj(text)) {
        return std::move(*model);
      }
    } catch (const InputError& error) {
      throw InputError("'" + file.string() + "': " + error.what());
    }
    throw InputError("'" + file.string() + "': found no vertices, expected an OBJ file");
  }

  std::vector<fs::path> files_;
  std::size_t vertices_ = 0;
};

}  // namespace

bool names_obj_sequence(const fs::path& name) {
  std::error_code ignored;
  return naming_of_pattern(name.filename().string()) || fs::is_directory(name, ignored);
}

std::unique_ptr<const FrameSource> open_obj_sequence(const fs::path& name) {
  return std::make_unique<ObjSequence>(files_of(name));
}

}  // namespace taut::app
