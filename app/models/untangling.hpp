#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/scene.hpp"
#include "app/verify/crossing_pairs.hpp"
#include "sim/garment.hpp"

namespace taut::app {

/// The outcome of parting a start in which the cloth crossed itself.
struct Untangling {
  std::size_t pairs_before = 0;  ///< of triangles that crossed
  std::size_t pairs_left = 0;
  double largest_move_m = 0.0;
};

/// Moves the garment, which begins in `start_m`, to a near shape in which it does not cross itself, or less
/// (sim/untangle), with the bound of the scene's solver, if it is not cut anew. Tells how many pairs cross,
/// round by round. Returns an empty value, and moves nothing, if there is nothing to be parted.
std::optional<Untangling> untangle_start(const Scene& scene, const sim::Garment& garment, bool is_cut_anew,
                                         std::vector<sim::Vec3>& start_m,
                                         const std::function<void(const std::string&)>& tell);

/// Returns "of 4 pairs of triangles that crossed at the start 0 are left, ...".
std::string describe(const Untangling& untangling);

}  // namespace taut::app
