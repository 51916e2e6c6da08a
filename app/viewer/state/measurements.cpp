#include "app/viewer/state/measurements.hpp"

#include <fmt/core.h>

#include "app/base/counted.hpp"

namespace taut::app {
namespace {

// Time constant of the averages of RealTime. A larger value is steadier and reacts more slowly.
constexpr double memory_s = 1.0;
// RealTime::factor says nothing before this much real time.
constexpr double first_moments_s = 0.5;
// Fraction of the speed asked for, or of the time a frame may take, that counts as all of it.
constexpr double as_good_as_asked = 0.95;
// Share of the processors' time above which this program itself is the reason.
constexpr double most_of_it = 0.75;

}  // namespace

void RecentValues::add(float value) {
  if (values_.size() == most) values_.erase(values_.begin());
  values_.push_back(value);
}

void RealTime::add(double elapsed_s, double simulated_s, double busy_s) {
  const double kept = std::exp(-elapsed_s / memory_s);
  elapsed_s_ = kept * elapsed_s_ + elapsed_s;
  simulated_s_ = kept * simulated_s_ + simulated_s;
  busy_s_ = kept * busy_s_ + busy_s;
}

std::optional<double> RealTime::factor() const {
  return elapsed_s_ > first_moments_s ? std::optional(simulated_s_ / elapsed_s_) : std::nullopt;
}

double RealTime::busy_share() const { return elapsed_s_ > 0.0 ? busy_s_ / elapsed_s_ : 0.0; }

SlowedBy slowed_by(double factor, double asked, double simulate_ms, double frame_ms, double busy_share) {
  if (factor >= as_good_as_asked * asked) return SlowedBy::nothing;
  if (simulate_ms >= as_good_as_asked * frame_ms) return SlowedBy::simulation;
  return busy_share >= most_of_it ? SlowedBy::drawing : SlowedBy::other_programs;
}

std::string in_little_room(double value, int decimals) {
  return std::abs(value) < 1e5 ? fmt::format("{:.{}f}", value, decimals) : fmt::format("{:.1e}", value);
}

std::string other_stretches(const FrameRecord& record, sim::BoundKind plotted) {
  const auto percent = [](double stretch) { return in_little_room(100.0 * stretch, 2); };
  const bool plots_springs = plotted == sim::BoundKind::springs;
  const double p99 = plots_springs ? record.stretch.p99 : record.surface_stretch.p99;
  const double other = plots_springs ? record.surface_stretch.max : record.stretch.max;
  const double other_p99 = plots_springs ? record.surface_stretch.p99 : record.stretch.p99;
  return fmt::format("p99 {} %, {} {} %, p99 {} %", percent(p99), plots_springs ? "surface" : "springs",
                     percent(other), percent(other_p99));
}

std::string contact_text(const sim::ContactReport& contact) {
  const std::string nearest =
      std::isfinite(contact.smallest_distance_m)
          ? "nearest " + in_little_room(1000.0 * contact.smallest_distance_m, 2) + " mm"
          : std::string("nothing near");
  return contact.left_out_share > 0.0
             ? fmt::format("{}, {} pairs cross, {:.1f} % left out", nearest, contact.crossing_pairs,
                           100.0 * contact.left_out_share)
             : fmt::format("{}, {}", nearest, counted(contact.crossing_pairs, "pair crosses", "pairs cross"));
}

void Measurements::add(const FrameRecord& record) {
  constexpr double mm_per_m = 1000.0;
  max_stretch.add(static_cast<float>(record.stretch.max));
  max_surface_stretch.add(static_cast<float>(record.surface_stretch.max));
  convergence_mm.add(static_cast<float>(record.convergence_m * mm_per_m));
  simulate_ms.add(static_cast<float>(record.sim_ms));
}

void Measurements::forget() {
  for (RecentValues* values : {&max_stretch, &max_surface_stretch, &convergence_mm, &simulate_ms}) {
    values->clear();
  }
}

}  // namespace taut::app
