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

/// Keeps cloth from crossing itself and bodies: says when to look for what is near, and gives each row its
/// region until the next time (regions.hpp). How and why: bounded.md beside this file.
class Contacts {
 public:
  /// With `within_cloth` false only bodies are in the way of the cloth.
  Contacts(bool within_cloth, double max_stretch) : within_cloth_(within_cloth), max_stretch_(max_stretch) {}

  /// Returns whether anything could touch in this frame.
  bool is_on() const { return is_on_; }

  /// Call it before each attempt at a frame or a part of it, with the memory of the last kept one. Things that
  /// cross when the first one begins are left out until they are apart. It goes the slower the more attempts at
  /// the frame there were.
  /// It should do no more than `most_work`, see work().
  void begin_attempt(const Frame& frame, const Layout& layout, const Motion& motion, const ContactMemory& memory,
                     const TimeSpan& time, int earlier_attempts, double most_work);
  /// Returns what an attempt leaves to the next frame.
  [[nodiscard]] ContactMemory memory() const;
  /// Returns the work of the attempt.
  [[nodiscard]] ContactReport report();
  /// Returns what the attempt's searches and regions cost until now, in sweeps over all of the cloth.
  double work() const;
  /// Returns whether anything was near in the attempt.
  bool is_near() const { return report_.most_pairs > 0; }
  /// Returns whether something is near and the attempt has cost more than it should, with so many sweeps
  /// besides.
  bool is_spent(double sweeps = 0.0) const { return is_near() && !lets_cross_ && work() + sweeps > most_work_; }
  /// Returns the processor time that the attempt's searches took, in ms.
  double search_ms() const { return search_ms_; }

  /// Returns whether regions have to be made before the time step that begins now.
  bool are_due(double time_s, double time_step_s) const {
    return is_on_ && time_s + 0.5 * time_step_s > until_s_;  // times are rounded
  }

  /// Ends the time of the last regions, to learn from it how rows move.
  void observe(const Layout& layout, const Motion& motion, double time_s);

  /// Returns until when regions that are made now should last: a time at which a time step ends.
  double suitable_end_s(double time_s, double time_step_s, double frame_end_s) const;

  /// Returns a bound on how far bodies are off their chords at any time of the span, in m.
  double bodies_off_chord_m(const TimeSpan& time) const { return bodies_.off_chord_m(time); }

  /// Makes regions for this time. Returns false where they do not soon fit and may be for a shorter one: then
  /// call it with that. `pins_moved_m` is how far pins are from the start of the frame at its end; pins and
  /// bodies are up to `off_chord_m` off their chords until then.
  [[nodiscard]] bool make_regions(const Frame& frame, const Layout& layout, const Motion& motion,
                                  const Float4* accelerations, std::span<const Vec3> pins_moved_m, double off_chord_m,
                                  const TimeSpan& time, bool may_be_shorter, ParallelKernels& kernels);

  /// Makes regions for a correction of displacements at the end of a frame, which is expected to be about
  /// `expected`.
  void make_regions(const Frame& frame, const Layout& layout, const Motion& motion, const Float4Array& displacements,
                    const Float4Array& expected, double time_s, ParallelKernels& kernels);

  /// Keeps things apart at the end of a time step, with friction.
  void keep_apart(const Layout& layout, double time_s, double time_step_s, ParallelKernels& kernels, Motion& motion);

  /// Keeps things apart in a correction. Returns whether regions should be made anew.
  bool keep_apart(ParallelKernels& kernels, Float4Array& displacements);

  /// Returns whether a vertex may be displaced by so much since the frame began, in m, where things were kept
  /// apart last.
  [[nodiscard]] bool allow(Index row, const Vec3& displacement_m) const;

  /// Returns the first pair that could not be kept apart in the attempt, if there is one.
  const std::optional<BlockedContact>& blocked() const { return blocked_; }
  /// Something may cross, as the frame ends outside of its regions.
  void give_up(const Layout& layout, const Motion& motion);
  /// Keeps nothing apart until the frame ends, and gives up.
  void let_cross(const Layout& layout, const Motion& motion, ParallelKernels& kernels);

 private:
  void lay_out(const Garment& garment, const Layout& layout, const std::vector<Body>& bodies);
  void add_loose_vertices(const Layout& layout);
  void leave_out(const ContactMemory& memory, const Layout& layout, const Motion& motion, double time_s);
  std::vector<LeftOutTriangle> left_out() const;
  double left_out_share() const;
  void measure_edges(const Mesh& mesh, const Layout& layout);
  /// Returns how far a row may deviate from where it is expected, in m.
  float room_of(std::size_t row) const;
  float most_room_m() const { return tuning::most_room_per_edge * static_cast<float>(mean_edge_m_); }
  /// Corrections of a frame are known less well, and larger balls do not fit into lists that last.
  float correction_room_of(std::size_t row) const { return 0.5F * room_of(row); }
  void begin_rows(const Layout& layout, const Motion& motion, const Float4Array& displacements);
  void expect_within_bound(const Layout& layout, ParallelKernels& kernels);
  bool find_regions(const Frame& frame, const Layout& layout, const Motion& motion, const TimeSpan& time,
                    bool may_be_shorter, ParallelKernels& kernels);
  bool are_many_large() const;
  std::span<const NearPair> find_near(const TimeSpan& time, float thickness_m, float error_m, ParallelKernels& kernels);
  void collect_pairs(const Material& material, float thickness_m, std::span<const NearPair> found, const TimeSpan& time,
                     const Vec3& origin_m, ParallelKernels& kernels);
  ContactPair contact_of(const NearPair& near, const Material& material, float thickness_m) const;
  static void let_go(std::span<const HeldBack> held_back, Motion& motion);
  void confine_nothing(ParallelKernels& kernels);
  void note_blocked(const Layout& layout, const Vec3& origin_m, bool fits);
  float thickness_of(const NearPair& near, float thickness_m) const;

  bool within_cloth_;
  double max_stretch_;
  bool is_on_ = false;
  std::vector<Triangle> triangles_;  ///< of the cloth, by row
  std::vector<Triangle> solid_;      ///< the same, and vertices without triangles as triangles of one place
  Float4Array rest_;                 ///< its positions at rest, by row, in m
  double mean_edge_m_ = 0.0;
  float longest_edge_m_ = 0.0F;
  float largest_gravity_m_per_s2_ = 0.0F;  ///< neighbours that change faster tremble
  std::vector<float> edges_m_;             ///< mean length of the edges that meet in a row
  BodyContacts bodies_;
  std::optional<LastingPairs> near_;
  Crossings left_out_;
  std::vector<LeftOutTriangle> triangle_of_;  ///< by triangle, of the cloth and then of bodies: which one it is
  std::vector<double> areas_;                 ///< of those of the cloth, at rest, in m^2
  std::vector<Body> bodies_of_frame_;
  std::vector<ContactPair> pairs_;
  RowMoves rows_;
  std::vector<float> reaches_;  ///< by row, see Regions::reach_m
  Float4Array expected_ends_;   ///< by row, displacements since the start of the frame
  Regions regions_;
  std::optional<BlockedContact> blocked_;
  ContactReport report_;
  double search_ms_ = 0.0;
  double most_work_ = 0.0;
  double pairs_made_ = 0.0;  ///< in all regions of the attempt
  bool lets_cross_ = false;  ///< nothing is kept apart until the frame ends
  double caution_ = 1.0;
  double from_s_ = 0.0;  ///< the time of the regions
  double until_s_ = 0.0;
  double off_chord_m_ = 0.0;
  double frame_ends_s_ = 0.0;
  float kept_at_ = 0.0F;  ///< the time from 0 to 1 at which they were last kept to
  Float4Array since_;     ///< displacements when they were made; empty before the first
  RowMemory memory_;      ///< of the attempt
};

}  // namespace taut::sim::bounded
