#include "app/viewer/session/key_names.hpp"

#include <array>
#include <charconv>
#include <utility>

#include "renderer/context/window_event.hpp"

namespace taut::app {
namespace {

namespace keys = renderer::keys;

constexpr std::array<std::pair<int, const char*>, 23> named_keys = {{
    {keys::space, "space"},
    {keys::escape, "escape"},
    {keys::enter, "enter"},
    {keys::tab, "tab"},
    {keys::backspace, "backspace"},
    {keys::insert, "insert"},
    {keys::del, "delete"},
    {keys::right, "right"},
    {keys::left, "left"},
    {keys::down, "down"},
    {keys::up, "up"},
    {keys::page_up, "page-up"},
    {keys::page_down, "page-down"},
    {keys::home, "home"},
    {keys::end, "end"},
    {keys::left_shift, "left-shift"},
    {keys::left_control, "left-control"},
    {keys::left_alt, "left-alt"},
    {keys::right_shift, "right-shift"},
    {keys::right_control, "right-control"},
    {keys::right_alt, "right-alt"},
    {keys::f10, "f10"},
    {keys::f12, "f12"},
}};

// Small letters are no keys; the name of a capital's key is the small letter.
bool is_character(int key) {
  return key > keys::space && key < 127 && !(key >= 'a' && key <= 'z');
}

}  // namespace

std::string key_name(int key) {
  for (const auto& [code, name] : named_keys) {
    if (code == key) {
      return name;
    }
  }
  if (is_character(key) && key != '#') {
    return {static_cast<char>(key >= 'A' && key <= 'Z' ? key - 'A' + 'a' : key)};
  }
  return '#' + std::to_string(key);
}

std::optional<int> key_named(const std::string& name) {
  for (const auto& [code, known] : named_keys) {
    if (name == known) {
      return code;
    }
  }
  if (name.size() == 1 && name[0] != '#') {
    const int key = name[0] >= 'a' && name[0] <= 'z' ? name[0] - 'a' + 'A' : name[0];
    return is_character(key) ? std::optional(key) : std::nullopt;
  }
  int key = -1;
  const char* end = name.data() + name.size();
  if (name.size() > 1 && name[0] == '#') {
    const auto [stop, error] = std::from_chars(name.data() + 1, end, key);
    if (error == std::errc() && stop == end && key >= 0 && key <= keys::last) {
      return key;
    }
  }
  return std::nullopt;
}

}  // namespace taut::app
