#include "app/scene_options.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"

namespace taut::app {
namespace {

constexpr int max_side_px = 16384;

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

// Returns the entry with this name, whatever its case, or null.
template <class Names> auto find_named(const Names& entries, std::string_view text) {
  const auto found = std::ranges::find_if(
      entries, [&](const auto& entry) { return lower_case(entry.name) == lower_case(std::string(text)); });
  return found == entries.end() ? nullptr : &*found;
}

// Returns the direction of a wind that comes from this azimuth. The camera counts its azimuth the same way.
std::string direction_from(double angle_deg) {
  const double angle_rad = angle_deg * std::numbers::pi / 180.0;
  const auto rounded = [](double component) { return std::round(component * 1e9) / 1e9 + 0.0; };
  return fmt::format("[{}, 0.0, {}]", rounded(-std::sin(angle_rad)), rounded(-std::cos(angle_rad)));
}

/// Returns the length of a unit in metres for its symbol, and a number unchanged. Throws UsageError for any other text.
std::string unit_value(const std::string& option, const std::string& text) {
  const auto* const unit = std::ranges::find(units, text, &Unit::symbol);
  if (unit != units.end()) return std::to_string(unit->metres);
  if (text.find_first_of("0123456789") != std::string::npos) return text;
  throw UsageError(option + ": found '" + text + "', expected " + join(collect<std::string>(units, &Unit::symbol)) +
                   " or the unit's length in m");
}

}  // namespace

renderer::Resized parse_size(const std::string& text, const std::string& option) {
  if (const NamedSize* named = find_named(named_sizes, text)) return named->size;
  const std::size_t between = text.find_first_of(",xX");
  const bool is_pair = between != std::string::npos;
  const auto width = number_in<int>(std::string_view(text).substr(0, between));
  const auto height = is_pair ? number_in<int>(std::string_view(text).substr(between + 1)) : std::nullopt;
  const auto is_side = [](std::optional<int> side) { return side && *side >= 1 && *side <= max_side_px; };
  if (!is_side(width) || !is_side(height)) {
    throw UsageError("{} {}: expected WIDTHxHEIGHT in pixels, such as 1280x720, or a name: {}", option, text,
                     join(collect<std::string>(named_sizes, &NamedSize::name)));
  }
  return {*width, *height};
}

void add_resolution(CLI::App& command, std::vector<Override>& overrides) {
  command.add_option_function<std::string>("--resolution", [&overrides](const std::string& text) {
    const renderer::Resized size = parse_size(text, "--resolution");
    overrides.push_back({"picture.width", std::to_string(size.width_px), "--resolution " + text});
    overrides.push_back({"picture.height", std::to_string(size.height_px), "--resolution " + text});
  });
}

std::string side_names() { return join(collect<std::string>(sides, &ViewSide::name)); }

void add_side(CLI::App& command, std::vector<Override>& overrides) {
  command.add_option_function<std::string>("--view", [&overrides](const std::string& text) {
    const ViewSide* const side = find_named(sides, text);
    if (side == nullptr) throw UsageError("--view " + text + ": expected one of " + side_names());
    for (const char* key : {"camera.box", "camera.eye", "camera.target"}) {
      overrides.push_back({key, "auto", "--view " + text});
    }
    overrides.push_back({"camera.azimuth", fmt::format("{}", side->azimuth_deg), "--view " + text});
    overrides.push_back({"camera.elevation", fmt::format("{}", side->elevation_deg), "--view " + text});
  });
}

void add_wind(CLI::App& command, std::vector<Override>& overrides) {
  command.add_option_function<std::string>("--wind", [&overrides](const std::string& text) {
    const std::string option = "--wind " + text;
    const std::size_t at = text.find('@');
    const auto angle_deg =
        at == std::string::npos ? std::nullopt : number_in<double>(std::string_view(text).substr(at + 1));
    if (!number_in<double>(text.substr(0, at)) || (at != std::string::npos && !angle_deg)) {
      throw UsageError(option + ": expected SPEED or SPEED@ANGLE, in m/s and degrees, such as 4@90");
    }
    overrides.push_back({"wind.speed", text.substr(0, at), option});
    if (angle_deg) overrides.push_back({"wind.direction", direction_from(*angle_deg), option});
  });
}

void add_keys(CLI::App& command, std::vector<Override>& overrides, std::initializer_list<KeyOption> options) {
  for (const KeyOption& o : options) {
    if (o.value != nullptr) {
      command.add_flag_callback(o.option, [&overrides, o] { overrides.push_back({o.key, o.value, o.option}); });
      continue;
    }
    const bool is_unit = std::string_view(o.key).ends_with(".scale");
    const auto set = [&overrides, o, is_unit](const std::string& text) {
      overrides.push_back({o.key, is_unit ? unit_value(o.option, text) : text, o.option + (' ' + text)});
    };
    command.add_option_function<std::string>(o.option, set);
  }
}

void add_set(CLI::App& command, std::vector<Override>& overrides) {
  const auto set = [&overrides](const std::vector<std::string>& texts) {
    std::ranges::transform(texts, std::back_inserter(overrides), parse_override);
  };
  command.add_option_function<std::vector<std::string>>("--set", set)->allow_extra_args(false);
}

void add_body(CLI::App& command, std::vector<Override>& overrides) {
  add_keys(command, overrides,
           {{"--body", "body.file"},
            {"--body-motion", "body.motion"},
            {"--body-clip", "body.clip"},
            {"--body-fps", "body.frame_rate"},
            {"--body-loop", "body.loop", "true"},
            {"--body-units", "body.scale"},
            {"--dress", "body.dress"},
            {"--body-up", "body.up"}});
}

void add_garment_arguments(CLI::App& command, std::vector<Override>& overrides) {
  add_keys(command, overrides,
           {{"--units", "garment.scale"},
            {"--up", "garment.up"},
            {"--fabric", "cloth.fabric"},
            {"--untangle", "garment.untangle", "true"}});
  add_body(command, overrides);
}

}  // namespace taut::app
