#include "app/scene/scene_text.hpp"

#include <fmt/core.h>

#include <vector>

#include "app/scene/scene_file.hpp"
#include "app/scene/scene_lookup.hpp"

namespace taut::app {
namespace {

constexpr char32_t replacement = 0xFFFD;

// The code point at `i`, which moves behind it. Bytes that are no UTF-8 (file names can hold any) become
// U+FFFD.
char32_t next_code_point(const std::string& text, std::size_t& i) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char first = byte(i++);
  const int more = first < 0x80 ? 0 : first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : -1;
  if (more < 0 || i + static_cast<std::size_t>(more) > text.size()) {
    return replacement;
  }
  char32_t code = more == 0 ? first : first & (0x3FU >> static_cast<unsigned>(more));
  for (int k = 0; k < more; ++k) {
    if ((byte(i) & 0xC0U) != 0x80U) {
      return replacement;
    }
    code = (code << 6U) | (byte(i++) & 0x3FU);
  }
  return code > 0x10FFFF || (code >= 0xD800 && code < 0xE000) ? replacement : code;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (std::size_t i = 0; i < text.size();) {
    const char32_t code = next_code_point(text, i);
    if (code == U'"' || code == U'\\') {
      result += {'\\', static_cast<char>(code)};
    } else if (code >= 0x20 && code < 0x7F) {
      result += static_cast<char>(code);
    } else {
      result += fmt::format("\\U{:08X}", static_cast<std::uint32_t>(code));
    }
  }
  return result + '"';
}

struct TomlWriter {
  std::string operator()(std::monostate) const { return "\"\""; }
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
  // The fewest digits that read back as the same bits; with a point, or TOML takes -0 for a whole 0.
  std::string operator()(double value) const {
    std::string text = fmt::format("{}", value);
    return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
  }
  std::string operator()(const std::string& value) const { return quoted(value); }
  std::string operator()(const ValueList& values) const {
    std::string text;
    for (const Value& value : values) {
      text += (text.empty() ? "" : ", ") + std::visit(*this, value.data);
    }
    return '[' + text + ']';
  }
  std::string operator()(const ValueTable& table) const {
    std::string text;
    for (const auto& [key, value] : table) {
      text += (text.empty() ? "" : ", ") + key + " = " + std::visit(*this, value.data);
    }
    return "{ " + text + " }";
  }
};

// Keys first, then the sections below: behind a section's header TOML has no way back.
void append_section(std::string& text, const std::string& section, const ValueTable& table) {
  for (const auto& [key, value] : table) {
    if (is_set(value) && value.table() == nullptr) {
      text += key + " = " + std::visit(TomlWriter{}, value.data) + '\n';
    }
  }
  for (const auto& [key, value] : table) {
    if (value.table() != nullptr) {
      const std::string name = section.empty() ? key : section + '.' + key;
      text += "\n[" + name + "]\n";
      append_section(text, name, *value.table());
    }
  }
}

std::filesystem::path garment_name(const std::filesystem::path& garment, GarmentNaming naming) {
  const std::filesystem::path full = std::filesystem::absolute(garment).lexically_normal();
  if (naming == GarmentNaming::full_path) {
    return full;
  }
  const std::filesystem::path assets = assets_folder();
  const std::filesystem::path relative = full.lexically_relative(assets);
  const bool is_inside = !assets.empty() && !relative.empty() && *relative.begin() != "..";
  return is_inside ? relative : full;
}

void name_files(const GarmentSource& source, GarmentNaming naming, ValueTable& garment) {
  for (auto& [key, value] : garment) {
    for (const auto& [name, member] : garment_files) {
      if (key == name && is_set(value)) {
        value = {garment_name(source.*member, naming).string()};
      }
    }
  }
}

}  // namespace

std::string text_of(ValueTable settings, const Scene& scene, GarmentNaming naming) {
  const bool has_file = !scene.garment.file.empty();
  for (auto& [key, value] : settings) {
    if (key == "garment") {
      ValueTable& garment = std::get<ValueTable>(value.data);
      std::erase_if(garment, [&](const auto& entry) { return has_file && entry.key == "grid"; });
      name_files(scene.garment, naming, garment);
    }
  }
  std::string text;
  append_section(text, "", settings);
  return text;
}

}  // namespace taut::app
