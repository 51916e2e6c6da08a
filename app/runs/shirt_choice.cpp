#include "app/runs/shirt_choice.hpp"

#include "app/base/progress.hpp"

namespace taut::app {
namespace {

/// Frames until the cloth flutters, and frames that are timed from there on.
constexpr int frames_before = 12, frames_timed = 24;

/// A built-in T-shirt, and the time of its frames over that of the smallest's. Larger values choose a smaller shirt.
struct TimedShirt {
  int triangles;
  double time_ratio;
};
constexpr std::array timed_shirts = {TimedShirt{10600, 21.0}, TimedShirt{5280, 7.4}, TimedShirt{2640, 2.6},
                                     TimedShirt{1028, 1.0}};

/// Largest time of a frame, as a fraction of real time: in 20 m/s it takes 2.3 times as long, and drawing slows it.
/// Larger values choose a larger shirt, which falls behind there.
constexpr double max_time_fraction = 0.5;

}  // namespace

int find_shirt_in_real_time(const sim::Simulation& timed, const std::function<void()>& advance_frame) {
  const auto count = static_cast<int>(timed.garment().mesh.triangles.size());
  const auto own = std::ranges::find(timed_shirts, count, &TimedShirt::triangles);
  if (own == timed_shirts.end()) throw std::invalid_argument("expected one of the built-in T-shirts");
  for (int frame = 0; frame < frames_before; ++frame) advance_frame();
  const Stopwatch watch;
  for (int frame = 0; frame < frames_timed; ++frame) advance_frame();
  const double real_ms = 1e3 * frames_timed * timed.frame_time_s();
  const double smallest_fraction = watch.elapsed_ms() / real_ms / own->time_ratio;
  const auto largest = std::ranges::find_if(
      timed_shirts, [&](const TimedShirt& shirt) { return smallest_fraction * shirt.time_ratio <= max_time_fraction; });
  return largest == timed_shirts.end() ? timed_shirts.back().triangles : largest->triangles;
}

}  // namespace taut::app
