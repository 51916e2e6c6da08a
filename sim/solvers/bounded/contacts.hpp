#pragma once

#include "sim/blocked_contact.hpp"
#include "sim/solvers/bounded/contact/body_contacts.hpp"
#include "sim/solvers/bounded/contact/crossings.hpp"
#include "sim/solvers/bounded/contact/lasting_pairs.hpp"
#include "sim/solvers/bounded/contact/regions.hpp"
#include "sim/solvers/bounded/layout.hpp"
#include "sim/solvers/bounded/memory.hpp"
#include "sim/solvers/bounded/motion.hpp"
#include "sim/solvers/bounded/tuning.hpp"
#include "sim/solvers/solver.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim::bounded {

/// Keeps cloth from crossing itself and bodies. It decides when to search for near pairs, and gives each vertex a
/// region until the next search (regions.hpp). Method and reasons: bounded.md beside this file.
class Contacts {
 public:
  /// `within_cloth` false: the cloth may cross itself.
  Contacts(bool within_cloth, double max_stretch) : within_cloth_(within_cloth), max_stretch_(max_stretch) {}

  /// Returns whether anything could touch in this frame.
  bool is_on() const { return is_on_; }

  /// Prepares the search for what is near, unless it is prepared for these bodies. It takes as long as several frames.
  void prepare(const Garment& garment, const Layout& layout, const std::vector<Body>& bodies);

  /// Begins an attempt at a frame or a part of it. `memory` belongs to the last kept one. Pairs that cross at the start
  /// of the first frame are left out until they are apart. Every earlier attempt at the frame makes this one more
  /// cautious. Its work should not exceed `max_work`, see work(); a negative one is spent.
  void begin_attempt(const Frame& frame, const Layout& layout, const Motion& motion, const ContactMemory& memory,
                     const TimeSpan& time, int earlier_attempts, double max_work);
  /// Returns the memory for the next frame.
  [[nodiscard]] ContactMemory memory() const;
  /// Returns the report of the attempt.
  [[nodiscard]] ContactReport report();
  /// Returns the cost of the attempt's searches and regions so far, in sweeps over the whole cloth.
  double work() const;
  /// Returns whether anything was near in the attempt.
  bool is_near() const { return report_.max_pairs > 0; }
  /// Returns whether something is near and the work, with this number of sweeps added, exceeds the budget.
  bool is_spent(double sweeps = 0.0) const { return is_near() && !lets_cross_ && work() + sweeps > max_work_; }
  /// Returns the processor time of the attempt's searches, in ms.
  double search_ms() const { return search_ms_; }

  /// Returns whether new regions are needed before the time step that begins now.
  bool are_due(double time_s, double time_step_s) const {
    return is_on_ && time_s + 0.5 * time_step_s > until_s_;  // times are rounded
  }

  /// Records how vertices moved during the last regions.
  void observe(const Layout& layout, const Motion& motion, double time_s);

  /// Returns the end time for regions made now; it is the end of a time step.
  double suitable_end_s(double time_s, double time_step_s, double frame_end_s) const;

  /// Returns a bound in m on the distance of bodies from their chords, at any time of the span.
  double bodies_off_chord_m(const TimeSpan& time) const { return bodies_.off_chord_m(time); }

  /// Makes regions for this span. Returns false if they do not fit within a few searches and the span may be shortened:
  /// then call it with a shorter one. `pins_moved_m` is the displacement of the pins from the start of the frame to the
  /// end of the span. Until then pins and bodies stay within `off_chord_m` of their chords.
  [[nodiscard]] bool make_regions(const Frame& frame, const Layout& layout, const Motion& motion,
                                  const Float4* accelerations, std::span<const Vec3> pins_moved_m, double off_chord_m,
                                  const TimeSpan& time, bool may_be_shorter, ParallelKernels& kernels);

  /// Makes regions for a correction of `displacements` at the end of a frame; `expected` is the predicted correction.
  void make_regions(const Frame& frame, const Layout& layout, const Motion& motion, const Float4Array& displacements,
                    const Float4Array& expected, double time_s, ParallelKernels& kernels);

  /// Projects vertices into their regions at the end of a time step, with friction.
  void keep_apart(const Layout& layout, double time_s, double time_step_s, ParallelKernels& kernels, Motion& motion);

  /// Projects a correction into the regions. Returns whether new regions are needed.
  bool keep_apart(ParallelKernels& kernels, Float4Array& displacements);

  /// Returns whether the region at the last projection allows this displacement since the start of the frame, in m.
  [[nodiscard]] bool allow(Index row, const Vec3& displacement_m) const;

  /// Returns the first pair of the attempt that could not be kept apart, if any.
  const std::optional<BlockedContact>& blocked() const { return blocked_; }
  /// Records that something may cross: the frame ends outside of its regions.
  void give_up(const Layout& layout, const Motion& motion);
  /// Gives up and disables contact until the frame ends.
  void let_cross(const Layout& layout, const Motion& motion, ParallelKernels& kernels);

 private:
  void lay_out(const Garment& garment, const Layout& layout, const std::vector<Body>& bodies);
  void add_loose_vertices(const Layout& layout);
  void leave_out(const ContactMemory& memory, const Layout& layout, const Motion& motion, double time_s);
  std::vector<ExcludedTriangle> left_out() const;
  double excluded_area_fraction() const;
  void measure_edges(const Mesh& mesh, const Layout& layout);
  /// Returns the slack of a vertex: its allowed deviation from its predicted motion, in m.
  float slack_m(std::size_t row) const;
  float max_slack_m() const { return tuning::max_slack_per_edge * static_cast<float>(mean_edge_m_); }
  /// Returns the slack of a correction. Predictions of corrections are less certain, and larger trust regions do not
  /// fit into lists that last.
  float correction_slack_m(std::size_t row) const { return 0.5F * slack_m(row); }
  void begin_rows(const Layout& layout, const Motion& motion, const Float4Array& displacements);
  void expect_within_bound(const Layout& layout, ParallelKernels& kernels);
  bool find_regions(const Frame& frame, const Layout& layout, const Motion& motion, const TimeSpan& time,
                    bool may_be_shorter, ParallelKernels& kernels);
  bool are_many_large() const;
  std::span<const NearPair> find_near(const TimeSpan& time, float thickness_m, float error_m, ParallelKernels& kernels);
  void collect_pairs(const Material& material, float thickness_m, std::span<const NearPair> near_pairs,
                     const TimeSpan& time, const Vec3& origin_m, ParallelKernels& kernels);
  void make_contact_pairs(std::span<const NearPair> near_pairs, const Material& material, float thickness_m,
                          std::size_t begin, std::size_t end, const ContactKernels& kernels);
  static void release_clamped(std::span<const ClampedRow> held_back, Motion& motion);
  void confine_nothing(ParallelKernels& kernels);
  void note_blocked(const Layout& layout, const Vec3& origin_m, bool fits);

  bool within_cloth_;
  double max_stretch_;
  bool is_on_ = false;
  std::vector<Triangle> triangles_;  ///< cloth triangles by solver index
  std::vector<Triangle> solid_;      ///< cloth triangles, plus loose vertices as triangles of three equal corners
  Float4Array rest_;                 ///< rest positions by solver index, in m
  double mean_edge_m_ = 0.0;
  float max_gravity_m_per_s2_ = 0.0F;  ///< limit of learned accelerations: faster changes are trembling
  std::vector<float> edges_m_;         ///< mean length of a vertex's edges
  BodyContacts bodies_;
  std::optional<LastingPairs> near_;
  Crossings excluded_;
  std::vector<ExcludedTriangle> contact_triangles_;  ///< identity of each contact triangle, cloth first, then bodies
  std::vector<double> areas_;                        ///< rest areas of the cloth's contact triangles, in m^2
  std::vector<Body> bodies_of_frame_;
  std::vector<ContactPair> pairs_;
  RowMoves rows_;
  std::vector<float> reaches_;  ///< search radii by solver index, see Regions::reach_m
  Float4Array expected_ends_;   ///< predicted displacements since the start of the frame, by solver index
  Regions regions_;
  std::optional<BlockedContact> blocked_;
  ContactReport report_;
  double search_ms_ = 0.0;
  double max_work_ = 0.0;
  double pairs_made_ = 0.0;  ///< number of pairs in all regions of the attempt
  bool lets_cross_ = false;  ///< contact is disabled until the frame ends
  double retry_level_ = 1.0;
  double from_s_ = 0.0;  ///< start time of the regions
  double until_s_ = 0.0;
  double off_chord_m_ = 0.0;
  double frame_ends_s_ = 0.0;
  float kept_time_ = 0.0F;           ///< time, 0 to 1, of the last projection into the regions
  Float4Array start_displacements_;  ///< displacements when the regions were made; empty before the first
  RowMemory memory_;                 ///< memory of the attempt
};

}  // namespace taut::sim::bounded
