#pragma once

#include <optional>
#include <string>

#include "app/scene/scene.hpp"

namespace taut::app {

/// Says why the `bounded` solver cannot promise its bound for this scene. Empty if it promises the bound, if
/// the scene has no bound, or if the scene allows exceeding it.
std::optional<std::string> beyond_promise(const Scene& scene);

/// Says why the `bounded` solver does not keep layers of this scene's cloth apart: it is too thin, or too
/// thick for its mesh. Empty if it keeps them apart or is not asked to.
std::optional<std::string> beyond_contact(const Scene& scene, const sim::Garment& garment);

/// The largest stretch that the scene's solver tries to keep, a fraction. Empty if it has none.
std::optional<double> stretch_bound(const Scene& scene);

/// The lengths that the bound holds: springs for every solver other than `bounded`.
sim::BoundKind bound_kind(const Scene& scene);

/// "bound" if the solver keeps it; "threshold" if springs are only pulled back to it.
const char* bound_word(const Scene& scene);

}  // namespace taut::app
