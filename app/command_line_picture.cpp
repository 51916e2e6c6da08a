#include "app/base/counted.hpp"
#include "app/base/errors.hpp"
#include "app/base/suggest.hpp"
#include "app/command_line_parts.hpp"
#include "app/drawing/drawn_scene.hpp"

namespace taut::app {
namespace {

constexpr int largest_side_px = 16384;

struct NamedSize {
  const char* name;
  renderer::Resized size;
};
constexpr std::array<NamedSize, 6> named_sizes = {{{"720p", {1280, 720}},
                                                   {"1080p", {1920, 1080}},
                                                   {"HD", {1920, 1080}},
                                                   {"1440p", {2560, 1440}},
                                                   {"4K", {3840, 2160}},
                                                   {"8K", {7680, 4320}}}};

template <class Names> std::string names_of(const Names& entries) {
  std::vector<std::string> names;
  for (const auto& entry : entries) names.emplace_back(entry.name);
  return joined(names, ", ");
}

bool same_word(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  });
}

// The entry with this name, in small or capital letters; null: none.
template <class Names> auto find_named(const Names& entries, std::string_view text) {
  const auto found =
      std::ranges::find_if(entries, [&](const auto& entry) { return same_word(entry.name, text); });
  return found == entries.end() ? nullptr : &*found;
}

// Where the air goes that comes from this side. Angles go around as those of the camera do.
std::string direction_from(double angle_deg) {
  const double angle_rad = angle_deg * std::numbers::pi / 180.0;
  const auto rounded = [](double component) { return std::round(component * 1e9) / 1e9 + 0.0; };
  return fmt::format("[{}, 0.0, {}]", rounded(-std::sin(angle_rad)), rounded(-std::cos(angle_rad)));
}

}  // namespace

const char* const size_help = "WIDTHxHEIGHT in pixels, or 720p, 1080p, 1440p, 4K, 8K (default 1280x720)";

renderer::Resized parse_size(const std::string& text, const std::string& option) {
  if (const NamedSize* named = find_named(named_sizes, text)) return named->size;
  const std::size_t between = text.find_first_of(",xX");
  const bool is_pair = between != std::string::npos;
  const auto width = number_in<int>(std::string_view(text).substr(0, between));
  const auto height = is_pair ? number_in<int>(std::string_view(text).substr(between + 1)) : std::nullopt;
  const auto is_side = [](std::optional<int> side) { return side && *side >= 1 && *side <= largest_side_px; };
  if (!is_side(width) || !is_side(height)) {
    throw UsageError("{} {}: expected WIDTHxHEIGHT in pixels, such as 1280x720, or a name: {}", option, text,
                     names_of(named_sizes));
  }
  return {*width, *height};
}

void add_resolution(CLI::App& command, std::vector<Override>& overrides) {
  const auto set = [&overrides](const std::string& text) {
    const renderer::Resized size = parse_size(text, "--resolution");
    overrides.push_back({"picture.width", std::to_string(size.width_px), "--resolution " + text});
    overrides.push_back({"picture.height", std::to_string(size.height_px), "--resolution " + text});
  };
  command.add_option_function<std::string>("--resolution", set, size_help);
}

void add_side(CLI::App& command, std::vector<Override>& overrides) {
  const auto set = [&overrides](const std::string& text) {
    const Side* const side = find_named(sides, text);
    if (side == nullptr) throw UsageError("--view " + text + ": expected one of " + names_of(sides));
    for (const char* key : {"camera.box", "camera.eye", "camera.target"}) {
      overrides.push_back({key, "auto", "--view " + text});
    }
    overrides.push_back({"camera.azimuth", fmt::format("{}", side->azimuth_deg), "--view " + text});
    overrides.push_back({"camera.elevation", fmt::format("{}", side->elevation_deg), "--view " + text});
  };
  command.add_option_function<std::string>("--view", set,
                                           "from where, the garment filling the picture: " + names_of(sides));
}

void add_wind(CLI::App& command, std::vector<Override>& overrides) {
  const auto set = [&overrides](const std::string& text) {
    const std::string option = "--wind " + text;
    const std::size_t at = text.find('@');
    const auto angle_deg =
        at == std::string::npos ? std::nullopt : number_in<double>(std::string_view(text).substr(at + 1));
    if (!number_in<double>(text.substr(0, at)) || (at != std::string::npos && !angle_deg)) {
      throw UsageError(option + ": expected SPEED or SPEED@ANGLE, in m/s and degrees, such as 4@90");
    }
    overrides.push_back({"wind.speed", text.substr(0, at), option});
    if (angle_deg) overrides.push_back({"wind.direction", direction_from(*angle_deg), option});
  };
  command.add_option_function<std::string>(
      "--wind", set,
      "SPEED in m/s, or SPEED@ANGLE: from where it blows, in degrees, 0 from the front, 90 from +x, 180 from "
      "behind");
}

}  // namespace taut::app
