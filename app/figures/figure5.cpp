#include <fmt/core.h>

#include "app/figures/figures.hpp"
#include "app/figures/moment_tables.hpp"
#include "app/figures/print.hpp"

namespace taut::app {
namespace {

std::array<const Recording*, 3> recordings_of(const Results& results) {
  return {&*results.shirts[0], &*results.shirts[1], &*results.shirts[2]};
}

}  // namespace

std::string figure5_csv(const Results& results) {
  return moments_csv(recordings_of(results));
}

std::string figure5_shapes_csv(const Results& results) {
  return shapes_csv(recordings_of(results));
}

void read_figure5(const std::filesystem::path& folder, Results& results) {
  for (std::size_t i = 0; i < results.shirts.size(); ++i) {
    results.shirts[i] = read_recording(folder, "fig5", shirt_scenes[i]);
  }
}

// The T-shirt without wind and in two winds.
Drawing draw_figure5(const Results& results, LazyOffscreenRenderer& offscreen) {
  std::vector<PrintedMoment> moments;
  for (const auto& recording : results.shirts) {
    moments.push_back({&*recording, &recording->last(), false});
  }
  Prints prints = print_moments(offscreen, moments, {980, 860});
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const FrameRecord& record = moments[i].moment->record;
    const double speed_m_per_s = moments[i].recording->scene.surroundings.forces.wind.speed_m_per_s;
    const std::string wind =
        speed_m_per_s == 0.0 ? "gravity alone" : fmt::format("wind {:.1f} m/s", speed_m_per_s);
    panels.push_back({std::move(prints.pictures[i]),
                      {static_cast<char>('a' + static_cast<int>(i)),
                       fmt::format("{}, after {:.1f} s", wind, record.time_s),
                       fmt::format("largest stretch {:.3f} %, surface {:.3f} %", 100.0 * record.stretch.max,
                                   100.0 * record.surface_stretch.max)}});
  }
  return sheet_of(std::move(panels), prints.size,
                  {.columns = 3, .caption = {.text_px = 50.0F, .measured_px = 43.0F}},
                  {0.2F * prints.metre_px, "20 cm"});
}

}  // namespace taut::app
