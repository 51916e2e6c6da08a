#pragma once

#include "sim/blocked_contact.hpp"
#include "sim/bytes.hpp"
#include "sim/state.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim {

/// The cost of keeping things apart in a frame, its repeated attempts included.
struct ContactReport {
  int detections = 0;          ///< how often all of the cloth and the bodies was searched for what is near
  int partial_detections = 0;  ///< how often that was done around single vertices alone
  int most_pairs = 0;          ///< near pairs that were kept apart at a time, the most of them
  /// Distance of the two nearest things in the shape that the frame ended with, in m, as ContactMeasure measures it
  /// whatever the solver does: 0 where they cross, below 0 in a plane, sphere or capsule, infinite where nothing is
  /// near.
  double smallest_distance_m = std::numeric_limits<double>::infinity();
  std::size_t crossing_pairs = 0;  ///< in that shape, measured likewise
  /// `bounded`: the part of the cloth's area at rest that was not kept apart from all else, as it crossed something
  /// when the run began.
  double left_out_share = 0.0;

  bool operator==(const ContactReport&) const = default;
};

/// A triangle around what crosses since the cloth began. Within a group nothing is kept apart.
struct LeftOutTriangle {
  std::optional<std::size_t> body = {};  ///< its place among the surroundings' bodies; empty: of the cloth
  Index triangle = 0;
  Index group = 0;

  bool operator==(const LeftOutTriangle&) const = default;
  bool operator<(const LeftOutTriangle& other) const {
    return std::tie(body, triangle, group) < std::tie(other.body, other.triangle, other.group);
  }
};

/// Processor time of all threads: no two runs take the same, and so it is no reason for reports to differ.
struct Took {
  double ms = 0.0;

  bool operator==(const Took&) const { return true; }
};

/// How a frame went.
struct FrameReport {
  int substeps = 0;
  bool bound_promised = false;   ///< whether the solver promises a bound on stretch
  bool bound_kept = true;        ///< whether it could keep its promise in this frame
  double raw_max_stretch = 0.0;  ///< before the last correction of the frame
  /// `bounded`: sweeps over all that is held, including repeated frames and the projection.
  double sweeps = 0.0;
  /// `bounded`: about the largest stiffness against compression that time steps of this length answer to:
  /// springs of a fabric that is stiffer push back as if they had this one. Infinite where nothing limits it.
  double followed_compression_n_per_m = std::numeric_limits<double>::infinity();
  /// `bounded`: what may cross in this frame, where its settings accept that. Not saved.
  std::optional<BlockedContact> blocked = {};
  ContactReport contact = {};
  Took search = {};                            ///< `bounded`: of finding what is near. Not saved.
  std::vector<LeftOutTriangle> left_out = {};  ///< `bounded`: in this frame, the cloth's first. Not saved.

  bool operator==(const FrameReport&) const = default;
};

/// A frame to be made: which cloth, under which influences, and how long.
struct Frame {
  const Garment& garment;
  const Pins& pins;
  const Surroundings& surroundings;
  double duration_s;  ///< above 0
  /// Called at least once in every time step and search. An exception that it throws ends the frame; the
  /// cloth and the solver are then as they were.
  const std::function<void()>& poll;

  void ask() const {
    if (poll) poll();
  }
};

/// Moves cloth from one frame to the next. The solver decides how it divides a frame.
class Solver {
 public:
  virtual ~Solver() = default;

  /// Throws std::invalid_argument if the solver makes promises and cannot make them for this garment or in
  /// these surroundings.
  virtual void require_promised(const Garment&, const Surroundings&) const {}

  /// Moves a start, keeping its velocity, within the bound on stretch that the solver promises, if any.
  virtual void move_within_bound(const Garment&, const Pins&, State&) const {}

  /// Returns whether cloth may cross itself and nobody asks whether it does.
  virtual bool ignores_contact() const { return false; }

  /// Advances `state` by one frame. The solver itself stays as it was until keep_frame(). Throws
  /// ContactBlocked where the solver keeps things from crossing and cannot; `state` is undefined then.
  [[nodiscard]] virtual FrameReport advance_frame(const Frame& frame, State& state) = 0;

  /// The last frame that was advanced is kept: the next one goes on from it.
  virtual void keep_frame() {}

  /// The state that its next frames depend on besides their arguments, as flat data; no measurements that only
  /// save time.
  virtual void save(const Garment& garment, const Pins& pins, ByteWriter& memory) const = 0;

  /// Takes over what a solver of the same settings saved; `frame` is its next one. Throws BadBytes.
  virtual void restore(const Frame& frame, ByteReader& memory) = 0;
};

}  // namespace taut::sim
