#pragma once

#include "prelude.hpp"
#include "sim/solvers/bounded/kernels/vector_unit.hpp"

namespace taut::sim {

/// The largest number of threads a solver accepts.
inline constexpr int most_threads = 64;

/// The lengths that the bound on stretch limits.
enum class BoundKind {
  springs,  ///< the length of every structural and shear spring, as the paper has it
  /// The length along every direction within every triangle, which holds the springs too: the largest
  /// singular value of each triangle's deformation gradient (sim/surface.hpp).
  surface,
};

inline constexpr std::array all_bound_kinds = {BoundKind::springs, BoundKind::surface};

/// The name used in files and messages.
const char* name_of(BoundKind kind);

/// The settings of `bounded`.
struct BoundedSettings {
  BoundKind bound = BoundKind::surface;
  /// The bound on stretch: at the end of a frame every length that is held is at most (1 + max_stretch) times
  /// the length at rest.
  double max_stretch = 0.05;
  /// Accepts bounds and loads for which the bound is not promised (promise.hpp).
  bool allow_exceeding = false;
  /// Goes on where pins or bodies close in so that something may cross, instead of throwing ContactBlocked.
  bool allow_crossing = false;
  /// Keeps the cloth from crossing itself, in every frame. Without it only bodies are in its way, and frames
  /// take a third of the time or less.
  bool contact = true;
  /// Limits each vertex's distance from its pin to the length of the way along the cloth. Saves work.
  bool tethers = true;
  VectorUnit vector_unit = VectorUnit::best;  ///< never changes a result
  /// Never changes a result. Without a value the solver chooses: 1, or for garments of 8000 triangles and more as
  /// many as the machine has, up to 4.
  std::optional<int> threads = {};

  bool operator==(const BoundedSettings&) const = default;
};

}  // namespace taut::sim
