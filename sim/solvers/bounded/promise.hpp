#pragma once

#include <optional>
#include <string>

#include "sim/solvers/bounded/settings.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim {

/// What a refusal calls the settings it speaks of; a program whose users know them by other names passes
/// those.
struct PromiseNames {
  const char* bound = "max_stretch";
  const char* gusts = "gusts";
  const char* allow_exceeding = "allow_exceeding = true";
};

/// From this bound on one is promised.
inline constexpr double smallest_promised_bound = 1e-4;

/// Why `bounded` does not promise its bound in these surroundings; nothing where it does, and where it is
/// allowed to be exceeded.
std::optional<std::string> beyond_promise(const BoundedSettings& settings, const Surroundings& surroundings,
                                          const PromiseNames& names = {});

}  // namespace taut::sim
