#pragma once

#include <optional>
#include <string>

#include "app/scene/scene.hpp"

namespace taut::app {

/// Why the bounded solver's bound is not promised for this scene; nothing where it is, where no bound is
/// asked for and where the scene allows that it is exceeded.
std::optional<std::string> beyond_promise(const Scene& scene);

/// The stretch that the scene's solver means not to exceed; none where it means none.
std::optional<double> stretch_bound(const Scene& scene);

/// What to call it: a bound is kept, a threshold is what springs are pulled back to.
const char* bound_word(const Scene& scene);

}  // namespace taut::app
