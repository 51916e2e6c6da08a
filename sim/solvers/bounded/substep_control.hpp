#pragma once

#include "sim/bytes.hpp"
#include "sim/garment.hpp"
#include "sim/solvers/bounded/layout.hpp"
#include "sim/solvers/bounded/projection.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim::bounded {

/// Chooses how many time steps a frame is divided into: as few as leave little for the projection to do. All
/// it goes by are counts and lengths of earlier frames, so that a run repeats itself bit for bit.
class SubstepControl {
 public:
  SubstepControl() = default;
  /// `most` is the budget. `least` is what the forces need. `first` is for the first frame.
  SubstepControl(int first, int least, int most, double frame_time_s);

  int substeps() const { return substeps_; }
  bool is_spent() const { return substeps_ >= most_; }

  /// After a frame whose projection took work worth `projection_cost` sweeps over all springs and moved no
  /// vertex further than `shift`, in parts of the largest that is allowed.
  /// Where frames were repeated with more steps, each cheap one halves them, down to the usual ones.
  void frame_kept(double projection_cost, double shift);

  /// Takes at least so many, within the budget, in the frames to come until it is told otherwise.
  void need_at_least(int substeps);

  /// Takes more steps to repeat a frame that broke its bound, whose steps stretched something by `raw` times
  /// the bound. Returns false if the budget is spent.
  bool try_more(double raw);

  /// Takes fewer steps after a frame that needed many at first, whose last steps stretched something by `raw`
  /// times the bound.
  void ease(double raw);

  /// Saves all its counts.
  void save(ByteWriter& memory) const;
  /// Throws BadBytes.
  void restore(ByteReader& memory);

 private:
  void need_more();

  int least_ = 1;
  int most_ = 1;
  int fewest_calm_frames_ = 1;
  int needed_ = 1;  ///< set in every frame that sets it at all
  int substeps_ = 1;
  int usual_ = 0;  ///< substeps before frames were repeated with more; 0 where they were not lately
  int calm_frames_ = 0;
  int frames_since_more_ = 0;
  int calm_frames_needed_ = 1;
  bool took_fewer_ = false;  ///< since more were last needed
};

/// Returns how far the last correction of a frame should move a vertex at most, in m. This is some
/// thousandths of the cloth's reach from its pins.
double allowed_shift_m(const Layout& layout);

/// For the first frame: hanging cloth stretches next to its pins by about c g dt^2 M / (m L), with the mass M
/// that hangs, the mass m of the vertices joined to pins and the mean rest length L of the springs between
/// them.
int first_substeps(const Garment& garment, const Layout& layout, const Surroundings& surroundings, double frame_time_s,
                   double max_stretch);

}  // namespace taut::sim::bounded
