#pragma once

#include "sim/rigid_motion.hpp"
#include "sim/solvers/bounded/contact/near_pairs.hpp"

namespace taut::sim::bounded {

/// Positions and predicted motions within a time; in m, one entry per vertex.
struct ExpectedRows {
  const Float4Array& positions;  ///< positions at the start of the time
  const Float4Array& moves;      ///< predicted motion until its end
  std::span<const float> radii;  ///< slack around the predicted motion
  TimeSpan time;
};

/// Finds near pairs like NearPairs, but with fewer searches of the whole mesh. For slow cloth it makes a list of pairs
/// that could become near in a longer time, and then searches only around vertices that leave their predicted motion.
class LastingPairs {
 public:
  /// Takes the arguments of NearPairs.
  LastingPairs(const ContactMesh& mesh, bool within_cloth, std::span<const Vec3> positions_m)
      : near_(mesh, within_cloth, positions_m) {}

  /// Forgets the list and the number of searches, so that the next result depends on nothing earlier.
  void forget() {
    begin_.clear();
    searches_ = {};
  }

  /// Numbers of searches.
  struct Searches {
    int all = 0;     ///< searches of the whole mesh
    int marked = 0;  ///< searches around vertices that left their predicted motion
  };
  const Searches& searches() const { return searches_; }
  /// Returns the searches since the last call.
  Searches take_searches() { return std::exchange(searches_, {}); }

  /// Finds all pairs that could meet during the predicted motion. A list lasts until `until_s` if vertices are slow
  /// enough compared with the mean edge `edge_m`.
  std::span<const NearPair> find(const ExpectedRows& rows, double until_s, float edge_m, ParallelKernels& kernels);

 private:
  /// Solver indices of the pairs' corners, times 4, as kernels take them.
  using List = std::array<Lanes<std::uint32_t>, 4>;

  struct Marked {
    std::size_t all;
    std::size_t unexpected;
  };

  bool is_list_for(const ExpectedRows& rows) const;
  void make_list(const ExpectedRows& rows, double until_s, float edge_m, ParallelKernels& kernels);
  Marked mark_unexpected(const ExpectedRows& rows);
  void renew_marked(const ExpectedRows& rows, float edge_m, ParallelKernels& kernels);
  float list_time_fraction(double time_s, float at_once) const;
  void sort_by_kind(std::span<const NearPair> pairs);
  void keep_near(const MovingRows& rows, Index first_count, const ContactKernels& kernels);

  NearPairs near_;
  Searches searches_;
  Float4Array begin_;           ///< positions when the list was made; empty without a list
  Float4Array motions_;         ///< predicted motions in the life of the list
  std::vector<float> reaches_;  ///< slack around the predicted motion
  TimeSpan time_;
  bool is_lasting_ = false;          ///< the list covers more than the time asked for
  std::vector<std::uint8_t> marks_;  ///< marks of vertices that left their predicted motion
  std::span<const NearPair> list_pairs_;  ///< pairs of the list
  std::array<List, 2> lists_;        ///< pairs of vertices and triangles, and of edges
  List kept_list_;
  Float4Array moving_;  ///< see MovingRows
  std::vector<NearPair> pairs_;
};

}  // namespace taut::sim::bounded
