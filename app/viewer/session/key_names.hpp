#pragma once

#include <optional>
#include <string>

namespace taut::app {

/// The name of a key in sessions: "space", "f12", "left", its character in lower case, or "#348" if it has no
/// name.
std::string key_name(int key);
/// The key with this name; empty if there is none.
std::optional<int> key_named(const std::string& name);

}  // namespace taut::app
