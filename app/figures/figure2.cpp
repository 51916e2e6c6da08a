#include <fmt/core.h>

#include "app/figures/figures.hpp"
#include "app/figures/moment_tables.hpp"
#include "app/figures/print.hpp"

namespace taut::app {

std::string figure2_csv(const Results& results) {
  return moments_csv(std::array{&results.fall->frames});
}

std::string figure2_shapes_csv(const Results& results) {
  return shapes_csv(std::array{&results.fall->frames});
}

void read_figure2(const std::filesystem::path& folder, Results& results) {
  results.fall = results.fall ? std::move(results.fall) : StepRecording{};
  results.fall->frames = read_recording(folder, "fig2", fall_scene);
}

// Simulation of cloth falling under the effect of gravity.
Drawing draw_figure2(const Results& results, LazyOffscreenRenderer& offscreen) {
  const Recording& fall = results.fall->frames;
  std::vector<PrintedMoment> moments;
  for (const Moment& moment : fall.moments) {
    moments.push_back({&fall, &moment, false});
  }
  Prints prints = print_moments(offscreen, moments, {720, 620});
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const FrameRecord& record = moments[i].moment->record;
    panels.push_back({std::move(prints.pictures[i]),
                      {static_cast<char>('a' + static_cast<int>(i)),
                       fmt::format("{:.2f} s{}", record.time_s, record.asleep ? ", at rest" : ""),
                       fmt::format("largest stretch {:.4g} %", 100.0 * record.stretch.max)}});
  }
  return sheet_of(std::move(panels), prints.size,
                  {.columns = 4, .caption = {.text_px = 48.0F, .measured_px = 42.0F}},
                  {0.5F * prints.metre_px, "0.5 m"});
}

}  // namespace taut::app
