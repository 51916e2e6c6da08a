#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "sim/garment.hpp"

namespace taut::app {

/// One spring of a patch.
struct PatchSpring {
  std::array<std::size_t, 2> ends;  ///< indices of points of the patch
  sim::SpringKind kind;
};

/// Mass points and springs of a part of a garment, in a plane, for a diagram.
struct SpringPatch {
  std::vector<glm::vec2> points_m;  ///< x to the right, y up
  std::vector<PatchSpring> springs;

  /// How many springs of this kind there are.
  std::size_t count(sim::SpringKind kind) const;
};

/// All points and springs of a garment that lies in the xy plane.
SpringPatch whole_patch(const sim::Garment& garment);

/// The vertices within `rings` edges of a vertex, with their springs. Seen along the surface's normal at the
/// vertex.
SpringPatch patch_around(const sim::Garment& garment, sim::Index vertex, int rings);

}  // namespace taut::app
