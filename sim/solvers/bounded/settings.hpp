#pragma once

#include <optional>

#include "sim/solvers/bounded/kernels/vector_unit.hpp"

namespace taut::sim {

inline constexpr int most_threads = 64;

struct BoundedSettings {
  /// No structural or shear spring is longer than this beyond its rest length at the end of a frame.
  double max_stretch = 0.05;
  /// Takes on bounds and loads for which the bound is not promised (promise.hpp).
  bool allow_exceeding = false;
  /// No vertex gets further from its pin than the way along the cloth is long. Less work.
  bool tethers = true;
  VectorUnit vector_unit = VectorUnit::best;  ///< never changes a result
  /// Never changes a result. None: one, or for garments above some 20 000 triangles as many as the machine
  /// has, up to 4.
  std::optional<int> threads = {};

  bool operator==(const BoundedSettings&) const = default;
};

}  // namespace taut::sim
