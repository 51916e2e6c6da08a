#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/garment.hpp"
#include "sim/solvers/solver.hpp"

namespace taut::sim {

/// Positions near those given in which no structural or shear spring is longer than `bounded` allows by these
/// settings; none where the settings promise no bound, or the positions keep it already. Pinned vertices
/// stay, so that where pins hold the cloth too far apart the bound cannot be kept everywhere. In metres, by
/// vertex.
std::optional<std::vector<Vec3>> moved_within_bound(const Garment& garment, std::span<const Vec3> positions,
                                                    const SolverSettings& settings);

}  // namespace taut::sim
