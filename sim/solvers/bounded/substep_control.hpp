#pragma once

#include "sim/bytes.hpp"
#include "sim/garment.hpp"
#include "sim/solvers/bounded/layout.hpp"
#include "sim/solvers/bounded/projection.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim::bounded {

/// Chooses the number of time steps per frame: as few as leave little for the projection to do. It depends only on
/// counts and lengths of earlier frames, so that a run repeats itself bit for bit.
class SubstepControl {
 public:
  SubstepControl() = default;
  /// `first` is the number for the first frame, `least` the number that the forces need, and `most` the budget.
  SubstepControl(int first, int least, int most, double frame_time_s);

  int substeps() const { return substeps_; }
  bool is_spent() const { return substeps_ >= max_substeps_; }

  /// Learns from a kept frame: `projection_cost` is the work of its projection in sweeps, `shift` its largest
  /// correction as a fraction of the largest allowed. After frames that were repeated with more steps, each cheap frame
  /// halves them, down to the usual number.
  void frame_kept(double projection_cost, double shift);

  /// Sets the smallest number, within the budget, for later frames until the next call. NaN, which lost cloth gives,
  /// counts as infinity.
  void need_at_least(double substeps);

  /// Increases the number to repeat a frame that broke its bound; its steps stretched to `raw_bounds` times the bound.
  /// Returns false if the budget is spent.
  bool try_more(double raw_bounds);

  /// Reduces the number after a frame that needed many steps at first; its last steps stretched to `raw_bounds`
  /// times the bound.
  void reduce_substeps(double raw_bounds);

  /// Saves all its counts.
  void save(ByteWriter& memory) const;
  /// Throws BadBytes.
  void restore(ByteReader& memory);

 private:
  void need_more();

  int min_substeps_ = 1;
  int max_substeps_ = 1;
  int min_calm_frames_ = 1;
  int needed_substeps_ = 1;  ///< see need_at_least()
  int substeps_ = 1;
  int usual_substeps_ = 0;  ///< substeps before frames were repeated with more; 0 if none were lately
  int calm_frames_ = 0;
  int frames_since_more_ = 0;
  int calm_frames_needed_ = 1;
  bool took_fewer_ = false;  ///< the number was reduced since more were last needed
};

/// Returns the largest desired motion of a vertex by the last correction of a frame, in m: some thousandths of the
/// cloth's reach from its pins.
double allowed_shift_m(const Layout& layout);

/// Returns the substeps of the first frame. Next to its pins hanging cloth stretches by about c g dt^2 M / (m L), with
/// the hanging mass M, the mass m of the vertices joined to pins and the mean rest length L of the springs between
/// them.
int first_substeps(const Garment& garment, const Layout& layout, const Surroundings& surroundings, double frame_time_s,
                   double max_stretch);

}  // namespace taut::sim::bounded
