#pragma once

#include <optional>
#include <string>

#include "sim/solvers/bounded/settings.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim {

/// The names that messages use for settings. A program passes the names that its users know.
struct PromiseNames {
  const char* bound = "max_stretch";
  const char* gusts = "gusts";
  const char* allow_exceeding = "allow_exceeding = true";
};

/// The smallest bound on stretch that is promised.
inline constexpr double smallest_promised_bound = 1e-4;

/// Returns why `bounded` does not promise its bound in these surroundings, as a message for the user. Returns
/// nothing if it does promise it, and if the settings allow exceeding it.
std::optional<std::string> beyond_promise(const BoundedSettings& settings, const Surroundings& surroundings,
                                          const PromiseNames& names = {});

}  // namespace taut::sim
