#pragma once

#include "sim/rigid_motion.hpp"
#include "sim/solvers/bounded/contact/near_pairs.hpp"

namespace taut::sim::bounded {

/// Where rows are and what is expected of them in some time; in m, one entry per row each.
struct ExpectedRows {
  const Float4Array& positions;  ///< when it begins
  const Float4Array& moves;      ///< until it ends
  std::span<const float> radii;  ///< and how much more or less that may be
  TimeSpan time;
};

/// Finds what is near as NearPairs does, but seldom looks through all: where cloth is slow it makes a list of
/// what could become near in a longer time, and then looks only around rows that do not keep to what was
/// expected of them in it.
class LastingPairs {
 public:
  /// See NearPairs.
  LastingPairs(const ContactMesh& mesh, bool within_cloth, std::span<const Vec3> positions_m)
      : near_(mesh, within_cloth, positions_m) {}

  /// Forgets the list, so that what is found next depends on nothing from before, and the count of searches.
  void forget() {
    begin_.clear();
    searches_ = {};
  }

  /// How often it has looked.
  struct Searches {
    int all = 0;     ///< through all
    int marked = 0;  ///< around rows that did not keep to what was expected
  };
  const Searches& searches() const { return searches_; }
  /// Returns the searches since the last call.
  Searches take_searches() { return std::exchange(searches_, {}); }

  /// Finds all pairs that could meet while rows move as expected. A list lasts until `until_s` where rows are
  /// slow enough, in parts of the mean edge.
  std::span<const NearPair> find(const ExpectedRows& rows, double until_s, float edge_m, ParallelKernels& kernels);

 private:
  /// Where the rows of pairs begin, corner by corner, as kernels take them.
  using List = std::array<Lanes<std::uint32_t>, 4>;

  struct Marked {
    std::size_t all;
    std::size_t unexpected;
  };

  bool is_list_for(const ExpectedRows& rows) const;
  void make_list(const ExpectedRows& rows, double until_s, float edge_m, ParallelKernels& kernels);
  Marked mark_unexpected(const ExpectedRows& rows);
  void renew_marked(const ExpectedRows& rows, float edge_m, ParallelKernels& kernels);
  float part_at(double time_s, float at_once) const;
  void sort_by_kind(std::span<const NearPair> pairs);
  void keep_near(const MovingRows& rows, Index first_count, const ContactKernels& kernels);

  NearPairs near_;
  Searches searches_;
  Float4Array begin_;           ///< where rows were when the list was made; empty if there is none
  Float4Array ways_;            ///< how they are expected to move in its time
  std::vector<float> reaches_;  ///< and how much more or less that may be
  TimeSpan time_;
  bool lasts_ = false;               ///< it is for more than was asked for when it was made
  std::vector<std::uint8_t> marks_;  ///< of rows that did not keep to it since it was made
  std::span<const NearPair> found_;  ///< the list
  std::array<List, 2> lists_;        ///< of vertices and triangles, and of edges
  List kept_;
  Float4Array moving_;  ///< see MovingRows
  std::vector<NearPair> pairs_;
};

}  // namespace taut::sim::bounded
