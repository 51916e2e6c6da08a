#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/bytes.hpp"
#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Pairs of vertices that may touch soon. The list reaches beyond the thickness by a skin and stays good
/// until a vertex has moved half the skin (Verlet 1967), so that it is seldom made anew.
class NeighbourList {
 public:
  /// Makes sure that the list holds every pair closer than `thickness_m` in `positions`, but for pairs that
  /// are closer than twice that in `rest_positions`: those are neighbours in the cloth itself.
  void update(std::span<const Vec3> rest_positions, std::span<const Vec3> positions, double thickness_m);

  std::span<const Edge> pairs() const { return pairs_; }

  /// What the list was made from: with the rest positions that decides its pairs, and until when it is good.
  void save(ByteWriter& memory) const;
  /// Throws BadBytes.
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
