#pragma once

#include "sim/solvers/bounded/contact/pair_batch.hpp"
#include "sim/solvers/bounded/contact/plane_gap.hpp"
#include "sim/solvers/bounded/kernels/parallel_kernels.hpp"

namespace taut::sim::bounded {

/// Near pair with its contact properties.
struct ContactPair {
  NearPair near;
  /// Distance kept, in m. Nearer primitives are separated gradually.
  float thickness_m = 0.0F;
  float friction = 0.0F;  ///< Coulomb's coefficient
  /// Tangential motion of the second primitive's surface until the time 1, besides its moves, in m: a ball that spins
  /// about its centre does not move but drags the cloth along.
  glm::vec3 surface_slide_m = glm::vec3(0.0F);
  /// Unit normal towards the first primitive; if not set, along the shortest distance.
  std::optional<glm::vec3> normal = {};
};

/// Vertices with their predicted motion; one entry per vertex, in m.
struct RowMoves {
  Float4Array positions;     ///< positions at the time 0, relative to an origin
  Float4Array moves;         ///< predicted motion until the time 1
  std::vector<float> radii;  ///< radii of the trust regions around the predicted motion
  /// Inverse masses in 1/kg; 0 for kinematic vertices, which move exactly by `moves`.
  std::vector<float> inverse_masses_per_kg;
  /// Motion of vertices without free motion: the mean motion of the pins.
  Float4 kinematic_motion = {};
  /// Normals of any length; `fourth` is positive where they are known. Missing entries are not.
  Float4Array normals = {};
  float displaced_m = 0.0F;     ///< largest displacement since the frame began
  std::size_t cloth_count = 0;  ///< entries from here on belong to bodies and have no displacements
};

/// Pair that cannot be kept apart, and its distance at the time 0, in m.
struct BlockedPair {
  NearPair near;
  float distance;
};

/// Vertex clamped by its trust region, and the removed part of its motion, in m.
struct ClampedRow {
  Index row;
  glm::vec3 out;
};

/// A time step of vertices in their regions.
struct StepMotion {
  float fraction = 0.0F;       ///< fraction of the regions' time
  float max_stopped_m = 0.0F;  ///< largest motion of it that planes between movable primitives stop
};

/// A moving convex region for every vertex, from the time 0 to the time 1. Primitives whose vertices stay within their
/// regions do not cross, on straight paths between any two times.
///
/// A region is a trust region (a ball around the predicted motion), which excludes pairs that were not near, and one
/// half-space per near pair. The half-space ends at a moving plane between the two primitives, at right angles to their
/// distance, or along their surfaces if that lets both follow their predictions. Corners on one side of a plane keep
/// their triangle there. The predicted motion is within the region at any time, so each vertex can be projected into
/// its region by itself. (Planes: "divide and truncate", 2026; balls: Chen and others 2025. Planes move so that layers
/// in contact can move together.)
class Regions {
 public:
  /// Makes the regions for the time 0 to 1. `pairs` has to contain every pair that could meet. Returns false if contact
  /// moves vertices out of their trust regions. Then `rows` has larger radii for a new search, and in the present
  /// regions only kinematic vertices move. `is_again` says that the last call returned false and only radii have
  /// changed since.
  bool make(std::span<const ContactPair> pairs, RowMoves& rows, ParallelKernels& kernels, bool is_again = false);

  /// Returns the first pair that cannot be kept apart, because kinematic vertices close in on it or it touched from the
  /// start.
  const std::optional<BlockedPair>& blocked() const { return blocked_; }

  /// Resolves collisions at a time from 0 to 1: separates pairs that a time step brought too near, without rebound,
  /// with friction, and without a change of momentum. `step` is the time step as a fraction of the whole time. `since`
  /// are displacements at the time 0, `previous` those a time step ago.
  void collide(float time, float step, const Float4Array& since, Float4Array& previous, Float4Array& current) const;

  /// Projects vertices into their regions at a time from 0 to 1. `since` are their displacements at the time 0,
  /// `previous` those a time step ago, which are adjusted so that planes leave each vertex the velocity of its
  /// predicted motion. Returns the vertices clamped by their trust regions, in ascending order, valid until the next
  /// call.
  std::span<const ClampedRow> project_into_region(float time, const StepMotion& step, const Float4Array& since,
                                                  Float4Array& previous, Float4Array& current,
                                                  ParallelKernels& kernels);

  /// Projects vertices into their regions at the time 1, without time passing. Returns the number of vertices clamped
  /// by their trust regions.
  std::size_t project_into_region(const Float4Array& since, Float4Array& current, ParallelKernels& kernels);

  /// Returns whether the region contains a motion since the time 0, in m, at a time from 0 to 1.
  [[nodiscard]] bool contains(Index row, float time, const Vec3& moved_m) const;

  /// Returns the search radius around a vertex's predicted motion, in m, that finds every pair that could collide or
  /// that its trust region alone does not keep apart by the gap of planes.
  static float reach_m(float radius_m, float thickness_m, float error_m) {
    return std::max(radius_m + planned_gap_m(thickness_m, error_m), 0.5F * collision_distance_m(thickness_m));
  }

  std::size_t pair_count() const { return pairs_.size(); }

  /// Returns the largest total distance from their chords of both primitives of a pair with kinematic vertices, in m,
  /// that causes no crossing; infinite if none is near.
  float kinematic_gap_m() const { return kinematic_gap_m_; }

  /// Returns the radius of a vertex's trust region, in m.
  float radius(std::size_t row) const { return radii_[row]; }

  /// Returns the deviation by contact from the predicted motion, in m, which may exceed the trust region.
  float deviation(std::size_t row) const { return deviations_[row]; }

 private:
  /// Pair with its geometry at the time 0.
  struct RegionPair {
    ContactPair contact;
    glm::vec3 normal;                  ///< unit vector towards the first primitive
    std::array<float, 4> heights;      ///< heights of the corners along the normal
    std::array<float, 4> weights;      ///< corner weights of the closest points
    float distance;                    ///< distance along the normal, in m
    float error;                       ///< rounding error of the distance
    float min_distance;                ///< smallest distance that has to remain
    float target_distance;             ///< distance that predicted motions should keep
    bool is_resolved;                  ///< resolved above rounding: the side of each primitive is certain
    std::array<Index, 4> half_spaces;  ///< half-space indices of its corners
  };
  struct HalfSpace {
    glm::vec3 normal;
    float start;    ///< smallest displacement along the normal at the time 0
    float rate;     ///< increase of that until the time 1
    float room;     ///< distance of the predicted motion from the plane, the smaller of both ends
    bool is_fixed;  ///< the other primitive is kinematic
  };
  enum class HoldKind : std::uint8_t { no, carried, still };
  /// Pair that may touch until the time 1. Only corners on the cloth are stored.
  struct Touch {
    std::array<Index, 4> rows;
    std::array<float, 4> weights;     ///< weights of the closest points; negative for the second primitive
    std::array<float, 4> mobilities;  ///< motion of the vertex per m of separation
    Float4 normal;
    /// Motion by bodies of the first primitive relative to the second until the time 1, including their surfaces'
    /// sliding (ContactPair).
    Float4 kinematic_motion;
    float distance;         ///< distance at the time 0
    float target_distance;  ///< smallest allowed distance at the time 0
    float rate;             ///< separation that the cloth has to add until the time 1
    float friction;
    std::uint32_t count;  ///< number of stored corners
  };
  /// Lowest corner of the first primitive and highest of the second, along a pair's normal.
  struct HeightSpan {
    float low;
    float high;
    float apart() const { return low - high; }
  };

  void place_plane(const RowMoves& rows, RegionPair& pair) const;
  void take_planes(const PairBatches::Batch& batch, std::span<const ContactPair> pairs);
  static void set_distances(RegionPair& pair);
  void make_pairs(std::span<const ContactPair> pairs, const RowMoves& rows, std::size_t begin, std::size_t end,
                  const ContactKernels& kernels);
  void make_pairs(std::span<const ContactPair> pairs, const RowMoves& rows, bool is_again, ParallelKernels& kernels);
  void find_same(std::span<const ContactPair> pairs, std::size_t rows);
  void note_blocked(const NearPair& near, float distance);
  void note_kinematic_gap(std::span<const float> inverse_masses);
  void stand_still(const RowMoves& rows);
  static HeightSpan height_span(const NearPair& near, const std::array<float, 4>& heights);
  HeightSpan span_at_end(const RegionPair& pair) const;
  void resolve(const RegionPair& pair, float left, bool is_urgent, std::span<const float> inverse_masses);
  void resolve_moves(std::span<const float> inverse_masses);
  void hold_where_needed(const RowMoves& rows);
  bool hold(const NearPair& near, HoldKind how, const RowMoves& rows);
  bool fit_radii(RowMoves& rows);
  bool needs_larger_balls(RowMoves& rows) const;
  void place_half_spaces();
  void make_half_spaces(std::span<const float> inverse_masses, ParallelKernels& kernels);
  void set_half_spaces(const RegionPair& pair, std::span<const float> inverse_masses);
  float region_slack_m(Index row) const;
  void make_touches(const RowMoves& rows);
  void add_touch(const RegionPair& pair, const std::array<float, 4>& weights, const RowMoves& rows);
  static void collide(const Touch& touch, float time, float step, const Float4* since, Float4* previous,
                      Float4* current);
  std::span<const HalfSpace> half_spaces_at(Index row) const;
  glm::vec3 limit_motion(Index row, float time, const glm::vec3& aim, const glm::vec3& end) const;
  glm::vec3 slide_along_planes(Index row, float time, const glm::vec3& aim, const glm::vec3& end) const;
  static glm::vec3 end_within_ball(const glm::vec3& centre, float radius, const glm::vec3& aim, const glm::vec3& end);
  glm::vec3 project_onto_planes(Index row, float time, const glm::vec3& start, glm::vec3& stopped) const;
  void project_all(float time, const StepMotion& step, const Float4Array& since, Float4Array* previous,
                   Float4Array& current, ParallelKernels& kernels);
  /// Motion since the time 0 projected onto planes, and then clamped by the trust region.
  struct RegionProjection {
    glm::vec3 within_planes;
    glm::vec3 end;
    glm::vec3 stopped;  ///< motion removed by planes of kinematic primitives
  };
  RegionProjection project_row(Index row, float time, const glm::vec3& moved) const;
  glm::vec3 kept_push(Index row, const StepMotion& step, const glm::vec3& last_move, const glm::vec3& push) const;

  Float4Array extents_;              ///< see PairRows
  std::vector<RegionPair> earlier_;  ///< pairs of the last regions, which did not fit
  Float4Array earlier_extents_;
  std::vector<const RegionPair*> unchanged_pairs_;  ///< unchanged earlier pair of each pair, if known
  std::vector<RegionPair> pairs_;
  std::optional<BlockedPair> blocked_;
  float kinematic_gap_m_ = 0.0F;
  Float4Array expected_;  ///< centres of the trust regions at the time 1
  /// Motions that contact allows, within the trust regions. `fourth` is the distance from them that is certainly within
  /// the region; infinite for kinematic vertices.
  Float4Array planned_motions_;
  std::vector<HoldKind> held_;
  std::vector<float> radii_;
  std::vector<float> deviations_;
  std::vector<std::uint8_t> is_clamped_;  ///< marks vertices that contact would move out of their trust regions
  std::vector<Index> half_space_begin_;
  std::vector<HalfSpace> half_spaces_;  ///< half-spaces by vertex
  std::vector<Touch> touches_;
  /// Vertices that one thread projects.
  struct ThreadPart {
    Lanes<std::uint32_t> rows;
    std::vector<ClampedRow> held_back;
  };
  std::vector<ThreadPart> parts_;
  std::vector<ClampedRow> clamped_rows_;
};

}  // namespace taut::sim::bounded
