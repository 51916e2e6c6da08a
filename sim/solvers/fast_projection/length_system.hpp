#pragma once

#include <memory>
#include <span>
#include <vector>

#include "sim/pins.hpp"

namespace taut::sim {

/// The equations of one projection: as many rows as edges that have a free end. Which entries are not zero,
/// and in which order they are eliminated, is found once.
class LengthSystem {
 public:
  LengthSystem(std::span<const Edge> edges, std::span<const double> rest_lengths_m, const Pins& pins);
  ~LengthSystem();

  /// Returns the largest | |e| / l - 1 | of the edges that have a free end.
  double largest_strain(std::span<const Vec3> positions_m) const;
  /// Moves the free vertices by one projection. Returns false, with nothing moved, where a number is not
  /// finite.
  bool project(std::span<Vec3> positions_m);

 private:
  struct Factors;

  void fill(std::span<const Vec3> positions_m);
  Vec3 gradient(std::size_t edge, Index end, std::span<const Vec3> positions_m) const;

  std::vector<Edge> edges_;
  std::vector<double> rest_lengths_m_;
  std::vector<double> inverse_masses_per_kg_;
  std::unique_ptr<Factors> factors_;
};

}  // namespace taut::sim
