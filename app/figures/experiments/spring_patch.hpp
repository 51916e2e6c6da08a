#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "sim/garment.hpp"

namespace taut::app {

struct PatchSpring {
  std::array<std::size_t, 2> ends;  ///< points of the patch
  sim::SpringKind kind;
};

/// Mass points and the springs between them, laid flat for a diagram: what the mapping made, nothing added.
struct SpringPatch {
  std::vector<glm::vec2> points_m;  ///< x to the right, y up
  std::vector<PatchSpring> springs;

  std::size_t count(sim::SpringKind kind) const;
};

/// All of a garment that lies in the xy plane.
SpringPatch whole_patch(const sim::Garment& garment);

/// The vertices within so many edges of one vertex, seen along the surface's normal there.
SpringPatch patch_around(const sim::Garment& garment, sim::Index vertex, int rings);

}  // namespace taut::app
