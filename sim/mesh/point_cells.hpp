#pragma once

#include <unordered_map>

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Returns the hash extended by one value.
inline std::size_t mix_hash(std::size_t hash, std::uint64_t value) {
  hash = (hash ^ value) * 0x9E3779B97F4A7C15ULL;
  return hash ^ (hash >> 32);
}

/// Returns the hash of three numbers. Adding zero turns -0 into +0, which compares equal and so has to hash equal.
inline std::size_t hash_numbers(double x, double y, double z) {
  std::size_t hash = 0;
  for (const double number : {x, y, z}) hash = mix_hash(hash, std::bit_cast<std::uint64_t>(number + 0.0));
  return hash;
}

/// Points sorted into cubes, for the search of near points.
class PointCells {
 public:
  /// `cell` is the width of a cube, in the points' unit; above 0.
  explicit PointCells(double cell) : cell_(cell) {}

  void add(const Vec3& point, Index index) {
    cells_[hash_numbers(number(point.x), number(point.y), number(point.z))].push_back(index);
  }

  /// Calls `visit` with the index of every point within a cell's width of the place, and of some farther ones. Points of
  /// one cube come in the order in which they were added.
  template <class Visit> void visit_near(const Vec3& place, const Visit& visit) const {
    for (int k = 0; k < 27; ++k) {
      const auto cell = cells_.find(
          hash_numbers(number(place.x) + k % 3 - 1, number(place.y) + k / 3 % 3 - 1, number(place.z) + k / 9 - 1));
      if (cell == cells_.end()) continue;
      for (const Index near : cell->second) visit(near);
    }
  }

 private:
  double number(double coordinate) const { return std::floor(coordinate / cell_); }

  double cell_;
  std::unordered_map<std::size_t, std::vector<Index>> cells_;
};

}  // namespace taut::sim
