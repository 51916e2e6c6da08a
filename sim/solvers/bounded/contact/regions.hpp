#pragma once

#include "sim/solvers/bounded/contact/near_pair.hpp"
#include "sim/solvers/bounded/contact/plane_gap.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"

namespace taut::sim::bounded {

/// A near pair with what decides how its two things touch.
struct ContactPair {
  NearPair near;
  /// The distance kept, in m. Things that are nearer are moved apart little by little.
  float thickness_m = 0.0F;
  float friction = 0.0F;  ///< Coulomb's coefficient
  /// How far the second thing's surface slides along itself until the time 1, beyond its moves, in m: a ball
  /// that turns about its centre does not move and yet drags the cloth along.
  glm::vec3 surface_slides = glm::vec3(0.0F);
  /// Of length 1, towards the first thing; where it is not given, along the shortest distance.
  std::optional<glm::vec3> normal = {};
};

/// Rows as contact sees them. One entry per row each, in m.
struct RowMoves {
  Float4Array positions;     ///< at the time 0, from an origin
  Float4Array moves;         ///< until the time 1, as expected
  std::vector<float> radii;  ///< how much further than its move, in any direction, a row may go
  /// In 1/kg. Rows of 0 move by exactly their moves.
  std::vector<float> inverse_masses_per_kg;
  /// Where rows go whose pairs leave them no way of their own: with what leads the cloth.
  Float4 carried = {};
  /// Normals of any length at the rows of the cloth; no entry for rows whose normal is not known.
  Float4Array normals = {};
  float displaced_m = 0.0F;     ///< how far a row has gone since the frame began, at most
  std::size_t cloth_count = 0;  ///< rows from here on are of bodies, and have no displacements
};

/// A pair that cannot be kept apart, and the distance of its two things at the time 0, in m.
struct BlockedPair {
  NearPair near;
  float distance;
};

/// A row that had gone out of its ball, and how far, in m.
struct HeldBack {
  Index row;
  glm::vec3 out;
};

/// For every row a convex region that moves from the time 0 to the time 1. Things that stay within their regions
/// crosses nothing, on straight ways between any two times.
///
/// A region is a ball around the row as it moves, for all that was not near, and a half-space for each near
/// pair: a plane between the two things at right angles to their distance, or along their surfaces where that lets both
/// go on as they are expected to. It moves along with them. Corners that are on one side keep their triangle on that
/// side. Where a row is expected to be lies within its region at any time, so that rows can always be brought back,
/// each by itself. (Planes: "divide and truncate", 2026; balls: Chen and others 2025. That planes move lets layers in
/// contact move together.)
class Regions {
 public:
  /// Makes the regions for the time 0 to 1. Every pair that could meet has to be among `pairs`. Returns false
  /// where contact moves rows further from where they are expected than their radii; then `rows` has larger
  /// radii, for pairs to be found anew, and the regions are those in which nothing moves but what must.
  /// `is_again` where it was that, and nothing but radii has changed since.
  bool make(std::span<const ContactPair> pairs, RowMoves& rows, ParallelKernels& kernels, bool is_again = false);

  /// Returns the first pair that cannot be kept apart, as rows that move by exactly their moves close in on
  /// it or as it touched from the beginning.
  const std::optional<BlockedPair>& blocked() const { return blocked_; }

  /// Parts pairs that a time step brought nearer than they should be, at a time from 0 to 1: without rebound,
  /// with friction, and without a change of momentum. The step took `step` of the whole time. `since` are
  /// displacements at the time 0, `previous` a time step ago.
  void collide(float time, float step, const Float4Array& since, Float4Array& previous, Float4Array& current) const;

  /// Brings rows back into their regions at a time from 0 to 1. `since` are their displacements at the time
  /// 0, `previous` a time step ago, which are changed so that planes change no velocity. Returns those that had gone
  /// out of their balls, in their order, until the next call.
  std::span<const HeldBack> bring_back(float time, const Float4Array& since, Float4Array& previous,
                                       Float4Array& current, ParallelKernels& kernels);

  /// The same at the time 1, where no time passes. Returns how many rows had gone out of their balls.
  std::size_t bring_back(const Float4Array& since, Float4Array& current, ParallelKernels& kernels);

  /// Returns whether a vertex may be moved by so much since the time 0, in m, at a time from 0 to 1.
  [[nodiscard]] bool contains(Index row, float time, const Vec3& moved_m) const;

  /// Returns the distance in m up to which things collide. Things further apart are left to their planes.
  static float touched_m(float thickness_m);

  /// Returns how far around its expected way a row has to be looked for, in m, so that every pair is found that its
  /// ball alone does not keep apart by what planes leave, or that is expected to collide.
  static float reach_m(float radius_m, float thickness_m, float error_m) {
    return std::max(radius_m + least_gap_m(thickness_m, error_m), 0.5F * touched_m(thickness_m));
  }

  std::size_t pair_count() const { return pairs_.size(); }

  /// Returns how far kinematic vertices, together with those of the other thing, may be off their chords at
  /// any time without a crossing, in m: infinite where none is near.
  float kinematic_gap_m() const { return kinematic_gap_m_; }

  /// Returns the radius of a row's ball, in m.
  float radius(std::size_t row) const { return radii_[row]; }

  /// Returns how far contact would move a row from where it was expected, in m: out of its ball too.
  float deviation(std::size_t row) const { return deviations_[row]; }

 private:
  /// A pair with its geometry at the time 0.
  struct Pair {
    ContactPair contact;
    glm::vec3 normal;                  ///< towards the first thing, of length 1
    std::array<float, 4> heights;      ///< of the corners along it
    std::array<float, 4> weights;      ///< of the corners, where the two things are nearest
    float distance;                    ///< of the two things along it, in m
    float error;                       ///< how far rounding may put the true distance below it
    float needed;                      ///< the least distance that has to be left
    float wanted;                      ///< the distance that expected moves leave
    bool is_told_apart;                ///< it is certain which side each thing is on
    std::array<Index, 4> half_spaces;  ///< of its corners, among those of all rows
  };
  struct HalfSpace {
    glm::vec3 normal;
    float start;    ///< displacements along the normal are at least so much at the time 0
    float rate;     ///< and so much more at the time 1
    float room;     ///< how far the row's expected move stays within it, at both times
    bool is_fixed;  ///< the other thing cannot be moved
  };
  enum class Held : std::uint8_t { no, carried, still };
  /// A pair that may touch until the time 1. Of the corners only those are kept that are rows of the cloth.
  struct Touch {
    std::array<Index, 4> rows;
    std::array<float, 4> weights;     ///< where the two things are nearest; those of the second are negative
    std::array<float, 4> mobilities;  ///< how far a row goes for each m that parts the two
    Float4 normal;
    /// How far bodies move the first thing against the second until the time 1, and along their surfaces
    /// (ContactPair).
    Float4 carried;
    float distance;  ///< at the time 0
    float wanted;    ///< the least distance at the time 0
    float rate;      ///< and how far the cloth has to part the two besides until the time 1
    float friction;
    std::uint32_t count;  ///< of rows
  };
  /// Lowest of the first thing and highest of the second, along a pair's normal.
  struct Span {
    float low;
    float high;
    float apart() const { return low - high; }
  };

  PairExtent extent_of(const NearPair& near, const std::array<glm::vec3, 4>& positions) const;
  Pair pair_of(const ContactPair& contact, const RowMoves& rows) const;
  void level(const std::array<glm::vec3, 4>& positions, const RowMoves& rows, Pair& pair) const;
  void make_pairs(std::span<const ContactPair> pairs, const RowMoves& rows, bool is_again, ParallelKernels& kernels);
  void find_same(std::span<const ContactPair> pairs, std::size_t rows);
  void note_blocked(const NearPair& near, float distance);
  void note_kinematic_gap(std::span<const float> inverse_masses);
  void stand_still(const RowMoves& rows);
  static void set_heights(const std::array<glm::vec3, 4>& positions, Pair& pair);
  static Span span_of(const NearPair& near, const std::array<float, 4>& heights);
  Span span_at_end(const Pair& pair) const;
  void resolve(const Pair& pair, float left, bool is_urgent, std::span<const float> inverse_masses);
  void resolve_moves(std::span<const float> inverse_masses);
  void hold_where_needed(const RowMoves& rows);
  bool hold(const NearPair& near, Held how, const RowMoves& rows);
  bool fit_radii(RowMoves& rows);
  bool needs_larger_balls(RowMoves& rows) const;
  void place_half_spaces();
  void make_half_spaces(std::span<const float> inverse_masses, ParallelKernels& kernels);
  void set_half_spaces(const Pair& pair, std::span<const float> inverse_masses);
  float room_of(Index row) const;
  void make_touches(const RowMoves& rows);
  void add_touch(const Pair& pair, const std::array<float, 4>& weights, const RowMoves& rows);
  static void collide(const Touch& touch, float time, float step, const Float4* since, Float4* previous,
                      Float4* current);
  std::span<const HalfSpace> half_spaces_of(Index row) const;
  glm::vec3 moved_less(Index row, float time, const glm::vec3& aim, const glm::vec3& end) const;
  glm::vec3 slid(Index row, float time, const glm::vec3& aim, const glm::vec3& end) const;
  static glm::vec3 end_within_ball(const glm::vec3& centre, float radius, const glm::vec3& aim, const glm::vec3& end);
  glm::vec3 projected(Index row, float time, const glm::vec3& start, glm::vec3& stopped) const;
  void bring_all_back(float time, const Float4Array& since, Float4Array* previous, Float4Array& current,
                      ParallelKernels& kernels);
  /// Where planes let a row go since the time 0, and where its ball does besides.
  struct BroughtBack {
    glm::vec3 within_planes;
    glm::vec3 end;
    glm::vec3 stopped;  ///< what planes of kinematic things took of the way
  };
  BroughtBack bring_row_back(Index row, float time, const glm::vec3& moved) const;

  /// How far a row is from the origin, and how far it may go, in m.
  struct RowExtent {
    float from_origin;
    float moved;
  };
  std::vector<RowExtent> extents_;
  std::vector<Pair> earlier_;  ///< pairs and extents of the regions that did not fit
  std::vector<RowExtent> earlier_extents_;
  std::vector<const Pair*> same_;  ///< by pair: the earlier one of the same rows in the same places, if known
  float displaced_m_ = 0.0F;
  std::vector<Pair> pairs_;
  std::optional<BlockedPair> blocked_;
  float kinematic_gap_m_ = 0.0F;
  Float4Array expected_;  ///< the centres of balls at the time 1
  /// As contact lets them, within the balls; `fourth` is how far from there a row is certainly within its
  /// region, and infinite where it moves by exactly its moves.
  Float4Array moves_;
  std::vector<Held> held_;
  std::vector<float> radii_;
  std::vector<float> deviations_;
  std::vector<std::uint8_t> is_cut_short_;  ///< which rows contact would move out of their balls
  std::vector<Index> half_space_begin_;
  std::vector<HalfSpace> half_spaces_;  ///< by row
  std::vector<Touch> touches_;
  /// The rows that one thread brings back, from its first block on.
  struct Part {
    Lanes<std::uint32_t> rows;
    std::vector<HeldBack> held_back;
  };
  std::vector<Part> parts_;
  std::vector<HeldBack> held_back_;
};

}  // namespace taut::sim::bounded
