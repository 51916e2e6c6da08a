#pragma once

#include <span>
#include <vector>

#include "sim/solvers/bounded/contact/near_pair.hpp"

namespace taut::sim::bounded {

/// Pairs of triangles that cross each other when the cloth begins. They are not kept apart as long as they
/// cross, and from then on like all others.
class Crossings {
 public:
  Crossings() = default;

  /// Finds the pairs that cross where the rows are, in m: of the cloth and bodies and, if asked for, within
  /// the cloth.
  Crossings(std::span<const Triangle> cloth, std::span<const Triangle> bodies, bool within_cloth,
            std::span<const Vec3> positions_m);

  /// Forgets the pairs that are apart.
  void update(std::span<const Vec3> positions_m);

  bool empty() const { return pairs_.empty(); }
  std::size_t size() const { return pairs_.size(); }

  /// Returns whether both things are of triangles that cross each other.
  bool has(const NearPair& near) const;

 private:
  using Key = std::array<Index, 5>;
  static Key key_of(const NearPair& near);
  void find_keys();

  std::vector<std::array<Triangle, 2>> pairs_;
  std::vector<Key> keys_;  ///< of their vertices and edges, sorted
};

}  // namespace taut::sim::bounded
