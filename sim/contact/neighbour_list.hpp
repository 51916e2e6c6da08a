#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/bytes.hpp"
#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Pairs of vertices that may soon touch. The list also holds pairs that are farther apart than the thickness
/// by up to a margin, the skin. It stays valid until a vertex has moved by half the skin (Verlet 1967), so
/// that it is rarely rebuilt.
class NeighbourList {
 public:
  /// Makes the list hold every pair that is closer than `thickness_m` in `positions`. Pairs closer than twice
  /// `thickness_m` in `rest_positions` are left out: they are neighbours in the cloth itself. Both spans have
  /// one entry per vertex, in metres. `thickness_m` must be above 0.
  void update(std::span<const Vec3> rest_positions, std::span<const Vec3> positions, double thickness_m);

  /// The pairs in lexicographic order; valid until the next update.
  std::span<const Edge> pairs() const { return pairs_; }

  /// Saves what the list was made from. With the rest positions this decides its pairs and how long it is
  /// valid.
  void save(ByteWriter& memory) const;
  /// Rebuilds the saved list. `rest_positions` have one entry per vertex, in metres. Throws BadBytes.
  void restore(std::span<const Vec3> rest_positions, ByteReader& memory);

 private:
  void make(std::span<const Vec3> rest_positions, double thickness_m);
  bool is_current(std::span<const Vec3> positions, double thickness_m) const;
  void sort_into_cells(double cell_m);
  void collect_pairs(std::span<const Vec3> rest_positions, double thickness_m, double reach_m);

  std::vector<Edge> pairs_;
  std::vector<Vec3> made_at_;
  double made_for_thickness_m_ = 0.0;
  // Vertices of cell c are sorted_[cell_begin_[c]] up to cell_begin_[c + 1]; far away, cells begin again.
  std::uint64_t cells_per_axis_ = 0;
  std::vector<Index> cell_begin_;
  std::vector<Index> sorted_;
  std::vector<Vec3> sorted_positions_;
};

}  // namespace taut::sim
