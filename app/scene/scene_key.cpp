#include "app/scene/scene_key.hpp"

#include "app/base/errors.hpp"
#include "app/scene/scene_file.hpp"

namespace taut::app {

extern const char* const key_texts;  ///< assets/texts/keys.toml

namespace {

std::string message_word(const Json& value) {
  if (value.is_null()) return "not set";
  if (value.is_string()) return '"' + value.get<std::string>() + '"';
  return value.is_number_float() ? fmt::format("{:.6g}", value.get<double>()) : value.dump();
}

std::string toml_word(const Json& value) {
  if (value.is_string()) {
    const Json readable = Json::parse(value.dump(-1, ' ', false, Json::error_handler_t::replace));
    std::ostringstream text;
    text << toml::toml_formatter(toml::value(readable.get<std::string>()), toml::format_flags::none);
    return text.str();
  }
  if (!value.is_number_float()) return value.dump();
  // Writes the fewest digits that read back as the same bits, with a point: TOML would read -0 as the integer 0.
  const std::string text = fmt::format("{}", value.get<double>());
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string joined_words(const Json& value, std::string (*word)(const Json&)) {
  if (!value.is_structured()) return word(value);
  std::string text;
  for (const auto& [key, item] : value.items()) {
    text += (text.empty() ? "" : ", ") + (value.is_object() ? key + " = " : "") + joined_words(item, word);
  }
  return value.is_object() ? "{ " + text + " }" : '[' + text + ']';
}

/// Maximum number of dots in a key, and of nested brackets. The TOML library and the readers of its tables recurse as
/// deep on the stack.
constexpr int max_toml_depth = 32;

/// Returns the position after the quoted text that begins at `at`.
std::size_t quoted_end(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string end(text.substr(at).starts_with(std::string(3, quote)) ? 3 : 1, quote);
  for (at += end.size(); at < text.size() && !text.substr(at).starts_with(end); ++at) {
    if (end.size() == 1 && text[at] == '\n') return at;
    if (quote == '"' && text[at] == '\\') ++at;
  }
  at = std::min(at + end.size(), text.size());
  while (end.size() == 3 && at < text.size() && text[at] == quote) ++at;
  return at;
}

/// Returns true if keys and values nest at most max_toml_depth deep.
bool is_shallow(std::string_view text) {
  int dots = 0, brackets = 0;
  for (std::size_t at = 0; at < text.size() && dots <= max_toml_depth && brackets <= max_toml_depth;) {
    const char c = text[at];
    at = c == '#' ? std::min(text.find('\n', at), text.size()) : c == '"' || c == '\'' ? quoted_end(text, at) : at + 1;
    if (c == '\n' || c == ',' || c == '=') dots = 0;
    dots += c == '.' ? 1 : 0;
    brackets += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
  }
  return dots <= max_toml_depth && brackets <= max_toml_depth;
}

}  // namespace

std::string key_meaning(const std::string& key) {
  static const toml::table meanings = toml::parse(key_texts);
  return meanings[key].value_or(std::string());
}

std::string describe(const std::string& what, const Range& range) {
  const bool bounded_below = std::isfinite(range.lowest);
  const bool bounded_above = std::isfinite(range.highest);
  if (bounded_below && bounded_above) {
    return range.above_lowest ? fmt::format("{} above {} up to {}", what, range.lowest, range.highest)
                              : fmt::format("{} from {} to {}", what, range.lowest, range.highest);
  }
  if (bounded_below) return fmt::format("{} {} {}", what, range.above_lowest ? "above" : "of at least", range.lowest);
  return bounded_above ? fmt::format("{} of at most {}", what, range.highest) : what;
}

std::optional<double> finite_number(const toml::node& value) {
  if (const auto* whole = value.as_integer()) return static_cast<double>(whole->get());
  const auto* number = value.as_floating_point();
  return number != nullptr && std::isfinite(number->get()) ? std::optional(number->get()) : std::nullopt;
}

std::optional<std::int64_t> whole_number(const toml::node& value) { return value.value_exact<std::int64_t>(); }

std::optional<glm::vec3> colour_value(const toml::node& value) {
  constexpr std::string_view digits = "0123456789abcdef";
  const std::optional<std::string> text = text_in(value);
  if (!text || text->size() != 7 || text->front() != '#') return std::nullopt;
  glm::vec3 colour(0.0F);
  for (std::size_t i = 0; i < 6; ++i) {
    const char lower = static_cast<char>((*text)[i + 1] | 0x20);
    const std::size_t digit = digits.find(lower);
    if (digit == std::string_view::npos || ((*text)[i + 1] < '0')) return std::nullopt;
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

Json to_json_value(const toml::node& node) {
  return node.visit([](const auto& value) -> Json {
    using Type = decltype(value);
    if constexpr (toml::is_table<Type>) {
      Json object = Json::object();
      for (const auto& [key, item] : list_entries(value)) object[key] = to_json_value(*item);
      return object;
    } else if constexpr (toml::is_array<Type>) {
      return collect<Json>(value, [](const toml::node& item) { return to_json_value(item); });
    } else if constexpr (toml::is_chronological<Type>) {
      return *text_in(value);
    } else {
      return value.get();
    }
  });
}

void fail(const Source& source, int line, const std::string& message) {
  if (source.is_command_line) throw UsageError(source.name + ": " + message);
  throw InputError(line > 0 ? fmt::format("{}:{}: {}", source.name, line, message)
                            : fmt::format("{}: {}", source.name, message));
}

int line_number(const toml::node& value) { return static_cast<int>(value.source().begin.line); }

toml::table read_toml_text(const std::string& text, const std::string& name) {
  if (!is_shallow(text)) {
    fail({name}, 0, fmt::format("found keys or lists more than {} deep, expected a scene", max_toml_depth));
  }
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    fail({name}, static_cast<int>(error.source().begin.line), "this is not TOML: " + std::string(error.description()));
  }
}

toml::table read_toml_value(const std::string& text) {
  if (!is_shallow(text)) return toml::table{{"value", text}};
  try {
    return toml::parse("value = " + text);
  } catch (const toml::parse_error&) {
    return toml::table{{"value", text}};
  }
}

std::optional<std::string> text_in(const toml::node& value) {
  if (value.is_date() || value.is_time() || value.is_date_time()) {
    std::ostringstream text;
    text << toml::node_view(value);
    return text.str();
  }
  return value.value_exact<std::string>();
}

std::vector<std::pair<std::string, const toml::node*>> list_entries(const toml::table& table) {
  std::vector<std::pair<std::string, const toml::node*>> entries;
  for (const auto& [key, value] : table) entries.emplace_back(key.str(), &value);
  std::ranges::stable_sort(
      entries, [](const auto& a, const auto& b) { return line_number(*a.second) < line_number(*b.second); });
  return entries;
}

std::filesystem::path find_beside(const Source& source, const std::filesystem::path& file) {
  const auto folder =
      source.is_command_line ? std::filesystem::path() : std::filesystem::path(source.name).parent_path();
  const std::filesystem::path named = (folder / file).lexically_normal();
  std::error_code ignored;
  return std::filesystem::exists(named, ignored) ? named : find_asset(file).value_or(named);
}

Json::json_pointer pointer_to(std::string key) {
  std::ranges::replace(key, '.', '/');
  return Json::json_pointer('/' + key);
}

std::string to_text(const Json& value) { return joined_words(value, message_word); }

std::string to_text(const toml::node& value) { return to_text(to_json_value(value)); }

std::string toml_text(const Json& value) { return joined_words(value, toml_word); }

}  // namespace taut::app
