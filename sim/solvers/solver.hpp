#pragma once

#include "sim/blocked_contact.hpp"
#include "sim/bytes.hpp"
#include "sim/state.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim {

/// Cost and result of contact in a frame, including repeated attempts.
struct ContactReport {
  int detections = 0;          ///< number of searches of the whole cloth and all bodies
  int partial_detections = 0;  ///< number of searches around single vertices
  int max_pairs = 0;           ///< largest number of near pairs kept apart at a time
  /// Smallest distance in the final shape of the frame, in m, as ContactMeasure measures it for any solver: 0 if
  /// something crosses, below 0 in a plane, sphere or capsule, infinite if nothing is near.
  double min_distance_m = std::numeric_limits<double>::infinity();
  std::size_t crossing_pairs = 0;  ///< crossing pairs in that shape, measured the same way
  /// `bounded`: fraction of the cloth's rest area left out of contact because it crossed something at the start.
  double excluded_area_fraction = 0.0;

  bool operator==(const ContactReport&) const = default;
};

/// Triangle near a crossing that exists since the start. Contact does not act within its group.
struct ExcludedTriangle {
  std::optional<std::size_t> body = {};  ///< index into the surroundings' bodies; empty for the cloth
  Index triangle = 0;
  Index group = 0;

  bool operator==(const ExcludedTriangle&) const = default;
  bool operator<(const ExcludedTriangle& other) const {
    return std::tie(body, triangle, group) < std::tie(other.body, other.triangle, other.group);
  }
};

/// Processor time of all threads. It differs between runs, so all values compare equal.
struct CpuTime {
  double ms = 0.0;

  bool operator==(const CpuTime&) const { return true; }
};

/// Report of a frame.
struct FrameReport {
  int substeps = 0;
  bool bound_promised = false;   ///< the solver promises a bound on stretch
  bool bound_kept = true;        ///< the frame keeps the bound
  double raw_max_stretch = 0.0;  ///< largest stretch before the last correction of the frame
  /// `bounded`: sweeps over all springs and triangles, including repeated frames and the projection.
  double sweeps = 0.0;
  /// `bounded`: approximate largest compression stiffness that time steps of this length can express. Stiffer springs
  /// push as if they had this one. Infinite if nothing limits it.
  double followed_compression_n_per_m = std::numeric_limits<double>::infinity();
  /// `bounded`: the contact that may cross in this frame, if the settings accept crossings. Not saved.
  std::optional<BlockedContact> blocked = {};
  ContactReport contact = {};
  CpuTime search = {};  ///< `bounded`: time of the broad phase. Not saved.
  std::vector<ExcludedTriangle> excluded_triangles =
      {};  ///< `bounded`: in this frame; the cloth's come first. Not saved.

  bool operator==(const FrameReport&) const = default;
};

/// Input of one frame: cloth, influences and duration.
struct Frame {
  const Garment& garment;
  const Pins& pins;
  const Surroundings& surroundings;
  double duration_s;  ///< above 0
  /// Called at least once in every time step and search. An exception that it throws ends the frame; cloth and solver
  /// are then unchanged.
  const std::function<void()>& poll;
  std::span<const float> wind_fractions = {};  ///< find_wind_fractions() at the beginning of the frame

  void ask() const {
    if (poll) poll();
  }
};

/// Moves cloth from one frame to the next. The solver decides how to divide a frame.
class Solver {
 public:
  virtual ~Solver() = default;

  /// Throws std::invalid_argument if the solver makes promises that it cannot keep for this garment or in these
  /// surroundings.
  virtual void require_promised(const Garment&, const Surroundings&) const {}

  /// Moves a start within the promised bound on stretch, if any, and keeps its velocity.
  virtual void move_within_bound(const Garment&, const Pins&, State&) const {}

  /// Returns whether the solver does not prevent cloth from crossing itself.
  virtual bool ignores_contact() const { return false; }

  /// Does what the first frame would do once, and changes no result.
  virtual void prepare_first_frame(const Frame&) {}

  /// Advances `state` by one frame. The solver itself is unchanged until keep_frame(). Throws ContactBlocked if it
  /// cannot prevent a crossing; `state` is then undefined.
  [[nodiscard]] virtual FrameReport advance_frame(const Frame& frame, State& state) = 0;

  /// Accepts the last advanced frame as the start of the next one.
  virtual void keep_frame() {}

  /// Writes the solver state that later frames depend on, as flat data, without measurements that only save time.
  virtual void save(const Garment& garment, const Pins& pins, ByteWriter& memory) const = 0;

  /// Restores the state saved by a solver with the same settings; `frame` is the next frame. Throws BadBytes.
  virtual void restore(const Frame& frame, ByteReader& memory) = 0;
};

}  // namespace taut::sim
