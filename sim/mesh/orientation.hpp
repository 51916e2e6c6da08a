#pragma once

#include <cstddef>

#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// Turns triangles so that neighbours across an edge with two triangles run along it in opposite directions,
/// and of every connected part as few as possible. A Moebius strip keeps a seam where they disagree.
/// Returns how many were turned.
std::size_t orient_consistently(Mesh& mesh);

}  // namespace taut::sim
