#include "app/frame_loop.hpp"

#include <algorithm>

#include "app/interruption.hpp"
#include "app/stopwatch.hpp"

namespace taut::app {

std::vector<FrameRecord> run_frames(sim::Simulation& simulation, int last_frame,
                                    const FrameOutputs& outputs) {
  const auto is_drawn = [&](int frame) {
    return std::binary_search(outputs.pictures.begin(), outputs.pictures.end(), frame);
  };
  std::vector<FrameRecord> records;
  for (int frame = is_drawn(0) ? 0 : 1; frame <= last_frame; ++frame) {
    throw_if_interrupted();

    Stopwatch simulating;
    if (frame > 0) {
      simulation.advance_frame();
    }
    const double sim_ms = simulating.elapsed_ms();

    FrameRecord record = measure_frame(simulation, frame);
    record.sim_ms = sim_ms;

    if (is_drawn(frame)) {
      Stopwatch drawing;
      const renderer::Image picture = outputs.draw_picture(simulation);
      record.draw_ms = drawing.elapsed_ms();

      Stopwatch writing;
      outputs.write_picture(frame, picture);
      record.encode_ms = writing.elapsed_ms();
    }
    if (outputs.write_shape) {
      Stopwatch writing;
      outputs.write_shape(frame, simulation);
      record.encode_ms += writing.elapsed_ms();
    }

    records.push_back(record);
    if (outputs.report) {
      outputs.report(record);
    }
  }
  return records;
}

}  // namespace taut::app
