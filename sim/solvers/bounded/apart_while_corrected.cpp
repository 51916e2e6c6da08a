#include "sim/solvers/bounded/apart_while_corrected.hpp"

namespace taut::sim::bounded {
void ApartWhileCorrected::begin(const Float4Array& raw, const Float4Array& expected) {
  cloth_.contacts.make_regions(frame_, cloth_.layout, cloth_.motion, raw, expected, time_s_, kernels_);
  last_ = raw;
  is_held_back_ = false;
  rounds_ = 0;
}

// Where vertices are held back by their balls there is more room from where they have come; and so there is
// beside planes from which one of the two has moved away.
void ApartWhileCorrected::bring_back(Float4Array& displacements) {
  frame_.ask();
  ++rounds_;
  if (is_held_back_ || rounds_ % tuning::most_rounds == 0) {
    moved_.resize(last_.size());
    for (std::size_t row = 0; row < last_.size(); ++row) {
      moved_[row] = scaled_sum(displacements[row], last_[row], -1.0F);
    }
    cloth_.contacts.renew_regions(frame_, cloth_.layout, cloth_.motion, last_, moved_, time_s_, kernels_);
  }
  is_held_back_ = cloth_.contacts.keep_apart(kernels_, displacements);
  last_ = displacements;
}

}  // namespace taut::sim::bounded
