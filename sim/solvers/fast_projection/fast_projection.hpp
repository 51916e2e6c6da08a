#pragma once

#include <memory>

#include "sim/solvers/fast_projection/length_system.hpp"
#include "sim/solvers/ideal.hpp"

namespace taut::sim {

/// The settings of `fast-projection`.
struct FastProjectionSettings {
  SpringStiffness stiffness = {};  ///< the structural one is not used: those springs are the constraints
  /// How much longer or shorter than at rest a structural spring may be when projections end. Less takes
  /// more projections.
  double max_strain = 0.05;
  /// The most projections in a time step, at least 1. Where they do not suffice the strain stays larger.
  int most_projections = 10;

  bool operator==(const FastProjectionSettings&) const = default;
};

/// Cloth that keeps its lengths (Goldenthal, Harmon, Fattal, Bercovier and Grinspun 2007). Structural springs
/// neither stretch nor shorten; shear and flexural springs obey Hooke's law. With the constraint of an edge e
/// of length l at rest, C = |e|^2 / l - l, each projection takes one step of Newton's method towards C = 0,
/// in directions of the shape that it has reached (the implicit constraint direction, section 4):
///   (h^2 grad C M^-1 grad C^T) dl = C,   dx = -h^2 M^-1 grad C^T dl.
/// On a grid these are the warp and the weft, and all can be kept. A triangle model has about as many edges
/// as its vertices have coordinates: if all keep their lengths it cannot drape freely, and flat parts make the
/// system singular. Its diagonal is raised by a little, so that it can always be solved; the lengths that
/// contradict each other are then not all kept.
class FastProjection : public IdealSprings {
 public:
  explicit FastProjection(const FastProjectionSettings& settings);

  void compensate(const Garment& garment, const Pins& pins, State& state) override;

 private:
  FastProjectionSettings settings_;
  std::unique_ptr<LengthSystem> system_;  ///< for the pins below; its past decides nothing
  std::vector<Index> pinned_;
};

/// Returns the springs of `fast-projection` that are forces.
SpringStiffness soft_springs(const FastProjectionSettings& settings);

}  // namespace taut::sim
