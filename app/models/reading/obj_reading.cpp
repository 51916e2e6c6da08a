#include <charconv>

#include "app/base/errors.hpp"
#include "app/models/reading/model_arrays.hpp"

namespace taut::app {
namespace {

constexpr std::string_view blanks = " \t\v\f";
constexpr std::string_view line_ends = "\r\n";
constexpr sim::Index unnamed = std::numeric_limits<sim::Index>::max();

/// Removes the next word from a line and returns it. Empty at the end of the line and at a comment.
std::string_view take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  line.remove_prefix(word.size());
  return word.starts_with('#') ? std::string_view{} : word;
}

std::size_t count_words(std::string_view line) {
  std::size_t count = 0;
  while (!take_word(line).empty()) ++count;
  return count;
}

/// Returns a texture coordinate; 0 if it is damaged.
float parse_fraction(std::string_view word) {
  double value = 0.0;
  word.remove_prefix(word.starts_with('+') ? 1 : 0);
  std::from_chars(word.data(), word.data() + word.size(), value);
  return static_cast<float>(value);
}

/// Returns the rest of a line as one name, which may contain blanks.
std::string_view name_in(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  return line.substr(0, line.find_last_not_of(blanks) + 1);
}

class ObjReader {
 public:
  explicit ObjReader(std::string_view text) : text_(text) {}

  std::optional<ModelArrays> read() {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    text_.remove_prefix(text_.starts_with(byte_order_mark) ? byte_order_mark.size() : 0);
    while (!text_.empty()) read_line(take_line());
    if (model_.positions.empty()) return std::nullopt;
    // A face may come before its vertices, so that their number is checked at the end.
    if (!model_.faces.corners.empty() && highest_ >= model_.positions.size()) {
      throw InputError("line {}: a face uses vertex {} of a model that has {}", line_of_highest_,
                       std::size_t{highest_} + 1, model_.positions.size());
    }
    place_texture();
    number_by_first_use(model_);
    model_.format = "Wavefront OBJ";
    return std::move(model_);
  }

 private:
  std::string_view take_line() {
    const auto take = [&] {
      const std::string_view line = text_.substr(0, text_.find_first_of(line_ends));
      text_.remove_prefix(line.size());
      text_.remove_prefix(text_.starts_with("\r\n") ? 2 : text_.empty() ? 0 : 1);
      ++lines_taken_;
      return line;
    };
    line_ = lines_taken_ + 1;
    std::string_view line = take();
    if (!line.ends_with('\\')) return line;
    joined_.clear();
    while (line.ends_with('\\') && !text_.empty()) {
      joined_ += line.substr(0, line.size() - 1);
      joined_ += ' ';
      line = take();
    }
    joined_ += line;
    return joined_;
  }

  void read_line(std::string_view line) {
    const std::string_view kind = take_word(line);
    if (kind == "v") {
      const double x = coordinate(take_word(line));
      const double y = coordinate(take_word(line));
      model_.positions.emplace_back(x, y, coordinate(take_word(line)));
    } else if (kind == "f" || kind == "fo") {
      read_face(line);
    } else if (kind == "l") {
      model_.ignored_lines += std::max<std::size_t>(count_words(line), 1) - 1;
    } else if (kind == "p") {
      model_.ignored_points += count_words(line);
    } else if (kind == "vt") {
      const float u = parse_fraction(take_word(line));
      texture_vertices_.emplace_back(u, parse_fraction(take_word(line)));
    } else if (kind == "vn") {
      model_.faces.has_normals = true;
    } else if (kind == "mtllib" || kind == "o" || kind == "g" || kind == "s" || kind == "usemtl") {
      begin_section(kind, name_in(line));
    }
  }

  void read_face(std::string_view line) {
    face_.clear();
    face_texture_.clear();
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
      face_.push_back(vertex(word));
      face_texture_.push_back(texture_vertex(word));
      if (face_.back() >= highest_) {
        highest_ = face_.back();
        line_of_highest_ = line_;
      }
    }
    if (face_.size() < 3) {
      model_.ignored_points += face_.size() == 1 ? 1 : 0;
      model_.ignored_lines += face_.size() == 2 ? 1 : 0;
      return;
    }
    model_.meshes += std::exchange(group_begins_, false) ? 1 : 0;
    model_.faces.corner_counts.push_back(static_cast<std::uint32_t>(face_.size()));
    model_.faces.corners.insert(model_.faces.corners.end(), face_.begin(), face_.end());
    corner_texture_.insert(corner_texture_.end(), face_texture_.begin(), face_texture_.end());
    if (model_.colours.materials.empty()) use_material("");
    model_.colours.material_of_face.push_back(material_);
  }

  double coordinate(std::string_view word) const {
    double value = 0.0;
    const char* const end = word.data() + word.size();
    const char* const begin = word.data() + (word.starts_with('+') ? 1 : 0);
    const auto [stopped, error] = std::from_chars(begin, end, value);
    if (error == std::errc::result_out_of_range && stopped == end) {
      // Tiny numbers become 0. Numbers that are too large are rejected as not finite by the check of all models.
      return std::strtod(std::string(word).c_str(), nullptr);
    }
    if (error != std::errc() || stopped != end) reject(word, "a coordinate of a vertex");
    return value;
  }

  // Reads "7", "7/1", "7//3" or "7/1/3". Numbers count from 1, or backwards from the last vertex so far.
  sim::Index vertex(std::string_view word) const {
    long long number = 0;
    const char* const end = word.data() + word.size();
    const auto [stopped, error] = std::from_chars(word.data(), end, number);
    const auto so_far = static_cast<long long>(model_.positions.size());
    if (error != std::errc() || (stopped != end && *stopped != '/') || number == 0 || number < -so_far ||
        number > static_cast<long long>(std::numeric_limits<sim::Index>::max())) {
      reject(word, "the number of a vertex");
    }
    return static_cast<sim::Index>(number > 0 ? number - 1 : so_far + number);
  }

  // Returns `unnamed` if the number is damaged: a garment is more than its print.
  sim::Index texture_vertex(std::string_view word) const {
    const std::size_t slash = word.find('/');
    long long number = 0;
    if (slash != std::string_view::npos) {
      std::from_chars(word.data() + slash + 1, word.data() + word.size(), number);
    }
    number = number < 0 ? static_cast<long long>(texture_vertices_.size()) + number + 1 : number;
    return number > 0 && number < static_cast<long long>(unnamed) ? static_cast<sim::Index>(number - 1) : unnamed;
  }

  void begin_section(std::string_view kind, std::string_view name) {
    std::string line = std::string(kind) + (name.empty() ? "" : " ") + std::string(name);
    model_.faces.sections.push_back({static_cast<std::uint32_t>(model_.faces.corner_counts.size()), std::move(line)});
    group_begins_ = group_begins_ || kind == "o" || kind == "g" || kind == "usemtl";
    if (kind == "mtllib") {
      model_.colours.libraries.emplace_back(name);
    } else if (kind == "usemtl") {
      use_material(name);
    }
  }

  // Faces before the first material's name have a material without a name.
  void use_material(std::string_view name) {
    std::vector<SurfaceMaterial>& all = model_.colours.materials;
    const auto known = std::ranges::find(all, name, &SurfaceMaterial::name);
    material_ = static_cast<sim::Index>(known - all.begin());
    if (known == all.end()) all.push_back({.name = std::string(name)});
  }

  // Texture vertices may come after their faces. A file that names no material has no colours.
  void place_texture() {
    SurfaceColours& colours = model_.colours;
    const auto is_named = [](sim::Index texture) { return texture != unnamed; };
    if (std::ranges::any_of(corner_texture_, is_named)) {
      for (const sim::Index texture : corner_texture_) {
        colours.corner_uv.push_back(texture < texture_vertices_.size() ? texture_vertices_[texture] : glm::vec2(0.0F));
      }
    }
    if (colours.materials.size() == 1 && colours.materials.front().name.empty()) {
      colours.materials.clear();
      colours.material_of_face.clear();
    }
  }

  [[noreturn]] void reject(std::string_view found, const std::string& expected) const {
    constexpr std::size_t longest = 40;
    throw InputError("line {}: found '{}', expected {}", line_, found.substr(0, longest), expected);
  }

  std::string_view text_;
  std::string joined_;  ///< lines that a backslash continues
  std::size_t line_ = 0;
  std::size_t lines_taken_ = 0;
  bool group_begins_ = true;
  std::vector<sim::Index> face_;
  std::vector<sim::Index> face_texture_;
  std::vector<glm::vec2> texture_vertices_;
  std::vector<sim::Index> corner_texture_;  ///< per corner, its texture vertex; `unnamed` if the face names none
  sim::Index material_ = 0;
  sim::Index highest_ = 0;
  std::size_t line_of_highest_ = 0;
  ModelArrays model_;
};

}  // namespace

std::optional<ModelArrays> read_obj(std::string_view text) { return ObjReader(text).read(); }

}  // namespace taut::app
