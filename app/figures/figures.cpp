#include "app/figures/figures.hpp"

namespace taut::app {
namespace {

// Repeats of each timing. One disturbance does not change their median. Each repeat takes a fraction of a
// second.
constexpr int frame_time_repeats = 15;

void time_strong_shirts(const ProgressCallback& report_progress, Results& results) {
  measure_frame_times(frame_time_repeats, report_progress, results);
}

std::vector<const Recording*> falls_of(const Results& results) { return {&results.fall->frames}; }

std::vector<const Recording*> pinned_of(const Results& results) {
  return {&*results.pinned[0], &*results.pinned[1]};
}

std::vector<const Recording*> shirts_of(const Results& results) {
  return {&*results.shirts[0], &*results.shirts[1], &*results.shirts[2]};
}

template <auto recordings_of> std::string moments_of(const Results& results) {
  return moments_csv(recordings_of(results));
}

template <auto recordings_of> std::string shapes_of(const Results& results) {
  return shapes_csv(recordings_of(results));
}

void read_fall(const std::filesystem::path& folder, Results& results) {
  results.fall = results.fall ? std::move(results.fall) : StepRecording{};
  results.fall->frames = read_recording(folder, "fig2", fall_scene);
}

void read_pinned(const std::filesystem::path& folder, Results& results) {
  for (std::size_t i = 0; i < results.pinned.size(); ++i) {
    results.pinned[i] = read_recording(folder, "fig4", pinned_scenes[i]);
  }
}

void read_shirts(const std::filesystem::path& folder, Results& results) {
  for (std::size_t i = 0; i < results.shirts.size(); ++i) {
    results.shirts[i] = read_recording(folder, "fig5", shirt_scenes[i]);
  }
}

void time_methods(const ProgressCallback& report_progress, Results& results) {
  results.trials_of(MethodTest::time) = make_trials(MethodTest::time, report_progress);
}

}  // namespace

const std::vector<Figure>& all_figures() {
  using enum Experiment;
  static const std::vector<Figure> figures = {
      {"fig1",
       "The mass-spring model and its types of springs, as the mapping makes them",
       {mapping},
       draw_figure1},
      {"fig2",
       "A cloth falls under gravity, held by two corners",
       {fall},
       draw_figure2,
       moments_of<falls_of>,
       shapes_of<falls_of>,
       read_fall},
      {"fig3", "One mass point converges", {fall}, draw_figure3, figure3_csv, nullptr, read_figure3},
      {"fig4",
       "Over-stretch of up to 5 % and up to 20 %, and where it is",
       {pinned_5, pinned_20},
       draw_figure4,
       moments_of<pinned_of>,
       shapes_of<pinned_of>,
       read_pinned},
      {"fig5",
       "The T-shirt under gravity and in two winds",
       {shirt_still, shirt_wind_1, shirt_wind_10},
       draw_figure5,
       moments_of<shirts_of>,
       shapes_of<shirts_of>,
       read_shirts},
      {"fig6",
       "What a frame costs for models of different precision",
       {},
       draw_figure6,
       figure6_csv,
       nullptr,
       read_figure6,
       time_strong_shirts},
      {"fig7",
       "Ideal springs, a threshold and the strong constraint: stretch and unrest",
       {methods},
       draw_figure7,
       figure7_csv,
       nullptr,
       read_figure7},
      {"fig8",
       "The field in one figure: the methods the paper argues with, on the same shirts",
       {methods_energy, methods_rest, methods_steps},
       draw_figure8,
       figure8_csv,
       nullptr,
       read_figure8,
       time_methods},
  };
  return figures;
}

std::vector<std::string> figure_names() {
  std::vector<std::string> names;
  for (const Figure& figure : all_figures()) names.push_back(figure.name);
  return names;
}

}  // namespace taut::app
