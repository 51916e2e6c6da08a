#pragma once

#include "prelude.hpp"
#include "sim/solvers/bounded/kernels/vector_unit.hpp"

namespace taut::sim {

/// Largest number of threads that a solver accepts.
inline constexpr int max_threads = 64;

/// Lengths limited by the bound on stretch.
enum class BoundKind {
  springs,  ///< length of every structural and shear spring, as in the paper
  /// Length along every direction within every triangle, which bounds the springs too: the largest singular value of
  /// each triangle's deformation gradient (sim/surface.hpp).
  surface,
};

inline constexpr std::array all_bound_kinds = {BoundKind::springs, BoundKind::surface};

/// Returns the name in files and messages.
const char* to_name(BoundKind kind);

/// Settings of `bounded`.
struct BoundedSettings {
  BoundKind bound = BoundKind::surface;
  /// Bound on stretch: at the end of a frame every bounded length is at most (1 + max_stretch) times its rest length.
  double max_stretch = 0.05;
  /// Accepts bounds and loads for which the bound is not promised (promise.hpp).
  bool allow_exceeding = false;
  /// Continues when pins or bodies close in so that something may cross, instead of throwing ContactBlocked.
  bool allow_crossing = false;
  /// Keeps the cloth from crossing itself in every frame. Without it only bodies stop the cloth, and frames take a
  /// third of the time or less.
  bool contact = true;
  /// Limits each vertex's distance from its pin to the length of the path along the cloth. Saves work.
  bool tethers = true;
  VectorUnit vector_unit = VectorUnit::best;  ///< never changes a result
  /// Number of threads; never changes a result. If not set, the solver takes 1, or for garments of 8000 triangles and
  /// more as many as the machine has, up to 4.
  std::optional<int> threads = {};

  bool operator==(const BoundedSettings&) const = default;
};

}  // namespace taut::sim
