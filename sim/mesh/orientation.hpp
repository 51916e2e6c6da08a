#pragma once

#include <cstddef>

#include "sim/mesh/mesh.hpp"

namespace taut::sim {

/// Turns triangles until both triangles of every edge face the same side. Of each connected part it turns the
/// smaller number. On a surface with one side only, such as a Moebius strip, some neighbours still disagree.
/// Returns how many triangles were turned.
std::size_t orient_consistently(Mesh& mesh);

}  // namespace taut::sim
