#include "app/scene/scene_key.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace taut::app {
namespace {

// Names of CSS Color Module Level 4.
constexpr std::array<std::pair<const char*, const char*>, 35> named_colours = {{
    {"black", "#000000"},     {"white", "#ffffff"},     {"grey", "#808080"},   {"gray", "#808080"},
    {"silver", "#c0c0c0"},    {"red", "#ff0000"},       {"maroon", "#800000"}, {"crimson", "#dc143c"},
    {"coral", "#ff7f50"},     {"orange", "#ffa500"},    {"gold", "#ffd700"},   {"yellow", "#ffff00"},
    {"khaki", "#f0e68c"},     {"beige", "#f5f5dc"},     {"ivory", "#fffff0"},  {"olive", "#808000"},
    {"lime", "#00ff00"},      {"green", "#008000"},     {"teal", "#008080"},   {"turquoise", "#40e0d0"},
    {"cyan", "#00ffff"},      {"skyblue", "#87ceeb"},   {"blue", "#0000ff"},   {"steelblue", "#4682b4"},
    {"royalblue", "#4169e1"}, {"navy", "#000080"},      {"indigo", "#4b0082"}, {"purple", "#800080"},
    {"plum", "#dda0dd"},      {"magenta", "#ff00ff"},   {"pink", "#ffc0cb"},   {"salmon", "#fa8072"},
    {"brown", "#a52a2a"},     {"chocolate", "#d2691e"}, {"tan", "#d2b48c"},
}};

/// A unit that a text may end in: a number of it is one of `of` times ten to the exponent, times the factor.
struct UnitOfKey {
  std::string_view name;
  std::string_view of;
  int exponent = 0;
  double factor = 1.0;
};
constexpr std::array<UnitOfKey, 12> units_of_keys = {{
    {"mm", "m", -3},
    {"cm", "m", -2},
    {"m", "m"},
    {"km/h", "m/s", 0, 1.0 / 3.6},
    {"m/s", "m/s"},
    {"g/m2", "kg/m2", -3},
    {"kg/m2", "kg/m2"},
    {"rad", "degrees", 0, 57.29577951308232},
    {"deg", "degrees"},
    {"degrees", "degrees"},
    {"ms", "s", -3},
    {"s", "s"},
}};

std::optional<double> number_in(std::string_view text) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
  return is_number ? std::optional(number) : std::nullopt;
}

/// The number times a power of ten, as exact as if it had been written so: "0.18" of -3 is 0.00018.
std::optional<double> shifted_number_in(const std::string& text, int exponent) {
  if (!number_in(text)) {
    return std::nullopt;
  }
  const std::size_t end = std::min(text.find_first_of("eE"), text.size());
  const int own = end < text.size() ? std::atoi(text.c_str() + end + 1) : 0;
  return number_in(fmt::format("{}e{}", text.substr(0, end), own + exponent));
}

std::optional<double> number_with_unit(std::string_view text, std::string_view unit) {
  const std::size_t digits = std::min(text.find_first_not_of("+-0123456789.eE"), text.size());
  for (const UnitOfKey& known : units_of_keys) {
    const std::string_view name = text.substr(digits + (text.substr(digits).starts_with(' ') ? 1 : 0));
    if (known.of == unit && known.name == name) {
      const std::optional<double> number =
          shifted_number_in(std::string(text.substr(0, digits)), known.exponent);
      return number ? std::optional(*number * known.factor) : std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace

std::string units_like(std::string_view unit) {
  std::vector<std::string> names;
  for (const UnitOfKey& known : units_of_keys) {
    if (known.of == unit) {
      names.emplace_back(known.name);
    }
  }
  return joined(names, " or ");
}

std::string describe(const std::string& what, const Range& range) {
  const bool bounded_below = std::isfinite(range.lowest);
  const bool bounded_above = std::isfinite(range.highest);
  if (bounded_below && bounded_above) {
    return range.above_lowest ? fmt::format("{} above {} up to {}", what, range.lowest, range.highest)
                              : fmt::format("{} from {} to {}", what, range.lowest, range.highest);
  }
  if (bounded_below) {
    return fmt::format("{} {} {}", what, range.above_lowest ? "above" : "of at least", range.lowest);
  }
  return bounded_above ? fmt::format("{} of at most {}", what, range.highest) : what;
}

std::string describe(const VectorLimits& limits) {
  return fmt::format("three numbers [x, y, z] from {:g} to {:g}{}", -limits.largest, limits.largest,
                     limits.may_be_zero ? "" : ", not all zero");
}

bool allows(const VectorLimits& limits, const std::array<double, 3>& numbers) {
  double size = 0.0;
  for (const double number : numbers) {
    size = std::max(size, std::abs(number));
  }
  return size <= limits.largest && (limits.may_be_zero || size > 0.0);
}

std::optional<double> finite_number(const toml::node& value, std::string_view unit) {
  if (const auto* text = value.as_string()) {
    return number_with_unit(text->get(), unit);
  }
  if (const auto* whole = value.as_integer()) {
    return static_cast<double>(whole->get());
  }
  const auto* number = value.as_floating_point();
  return number != nullptr && std::isfinite(number->get()) ? std::optional(number->get()) : std::nullopt;
}

std::optional<std::int64_t> whole_number(const toml::node& value) {
  return value.value_exact<std::int64_t>();
}

std::optional<std::array<double, 3>> three_numbers(const toml::node& value, std::string_view unit) {
  const toml::array* list = value.as_array();
  if (list == nullptr || list->size() != 3) {
    return std::nullopt;
  }
  std::array<double, 3> numbers{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<double> number = finite_number((*list)[i], unit);
    if (!number) {
      return std::nullopt;
    }
    numbers[i] = *number;
  }
  return numbers;
}

std::optional<glm::vec3> colour_value(const toml::node& value) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::optional<std::string> text = text_in(value);
  const auto* const named =
      std::find_if(named_colours.begin(), named_colours.end(),
                   [&](const std::pair<const char*, const char*>& entry) { return text == entry.first; });
  if (named != named_colours.end()) {
    text = named->second;
  }
  if (!text || text->size() != 7 || text->front() != '#') {
    return std::nullopt;
  }
  glm::vec3 colour(0.0F);
  for (std::size_t i = 0; i < 6; ++i) {
    const char lower = static_cast<char>((*text)[i + 1] | 0x20);
    const std::size_t digit = digits.find(lower);
    if (digit == std::string_view::npos || ((*text)[i + 1] < '0')) {
      return std::nullopt;
    }
    colour[static_cast<int>(i / 2)] += static_cast<float>(digit * (i % 2 == 0 ? 16 : 1)) / 255.0F;
  }
  return colour;
}

std::string colour_text(const glm::vec3& colour) {
  std::string text = "#";
  for (const float channel : {colour.r, colour.g, colour.b}) {
    text += fmt::format("{:02x}", static_cast<int>(std::lround(std::clamp(channel, 0.0F, 1.0F) * 255.0F)));
  }
  return text;
}

}  // namespace taut::app
