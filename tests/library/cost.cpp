#include <cstdio>
#include <cstdlib>

#include "app/base/progress.hpp"
#include "app/library/session.hpp"
#include "app/runs/frame_record.hpp"
#include "cloths.hpp"

// Cost of the C interface. library_cost SCENE FRAMES advances two equal cloths in turn: one by sim::Simulation
// itself, one through the C interface with a copy of the positions. It prints the mean processor times of a frame in
// ms.
int main(int count, char** arguments) {
  using namespace taut;
  if (count != 3) {
    std::fputs("usage: library_cost SCENE FRAMES\n", stderr);
    return 2;
  }
  const int frames = std::atoi(arguments[2]);
  const TautOptions options = test::OwnCloth::options_of(arguments[1], 1);
  library::Start start = library::load(options);
  sim::Simulation inside = app::make_simulation(start.scene, start.loaded, start.bodies.all);
  const test::OwnCloth through(options);
  auto frame = test::make_struct<TautFrame>(taut_frame_init);
  std::vector<float> positions(3 * through.info().vertex_count);
  const TautPointsOut out = {positions.data(), positions.size() / 3, 12, TAUT_FLOAT};
  double inside_ms = 0.0, measuring_ms = 0.0, through_ms = 0.0;
  for (int k = 1; k <= frames; ++k) {
    const app::Stopwatch stepping(CLOCK_THREAD_CPUTIME_ID);
    inside.advance_frame();
    inside_ms += stepping.elapsed_ms();
    const app::Stopwatch measuring(CLOCK_THREAD_CPUTIME_ID);
    const app::FrameRecord record = app::measure_frame(inside, k);
    measuring_ms += measuring.elapsed_ms();
    const app::Stopwatch calling(CLOCK_THREAD_CPUTIME_ID);
    if (taut_step(through, &frame) != TAUT_OK || taut_get_positions(through, &out) != TAUT_OK ||
        frame.state_hash != record.state_hash) {
      std::printf("%s: frame %d is another: %s\n", arguments[1], k, through.error().c_str());
      return 1;
    }
    through_ms += calling.elapsed_ms();
  }
  std::printf("C: inside %.3f ms, measured %.3f ms, through the interface %.3f ms, %.4f of both\n", inside_ms / frames,
              measuring_ms / frames, through_ms / frames, through_ms / (inside_ms + measuring_ms));
  return 0;
}
