#pragma once

#include <optional>
#include <string>

namespace taut::app {

/// How a key is called in sessions: "space", "f12", "left", the character it carries in small letters, or
/// "#348" for one without a name.
std::string key_name(int key);
/// The other way round; nothing for any other word.
std::optional<int> key_named(const std::string& name);

}  // namespace taut::app
