#pragma once

#include <optional>
#include <string>

#include "app/scene/scene.hpp"

namespace taut::app {

/// Why the bounded solver's bound is not promised for this scene; nothing where it is, where no bound is
/// asked for and where the scene allows that it is exceeded.
std::optional<std::string> beyond_promise(const Scene& scene);

}  // namespace taut::app
