#include "app/viewer/measurements.hpp"

namespace taut::app {

void RecentValues::add(float value) {
  if (values_.size() == most) {
    values_.erase(values_.begin());
  }
  values_.push_back(value);
}

void Measurements::add(const FrameRecord& record) {
  constexpr double mm_per_m = 1000.0;
  max_stretch.add(static_cast<float>(record.stretch.max));
  convergence_mm.add(static_cast<float>(record.convergence_m * mm_per_m));
  simulate_ms.add(static_cast<float>(record.sim_ms));
}

void Measurements::forget() {
  for (RecentValues* values : {&max_stretch, &convergence_mm, &simulate_ms}) {
    values->clear();
  }
}

}  // namespace taut::app
