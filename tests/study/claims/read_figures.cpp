#include "app/base/errors.hpp"
#include "tests/study/claims/csv_file.hpp"
#include "tests/study/claims/trials.hpp"
#include "tests/study/claims/truth.hpp"

namespace taut::app {
namespace {

Moment read_moment(const CsvFile& moments, std::size_t row) {
  Moment moment;
  moment.record.frame = moments.whole_number(row, 2);
  moment.record.time_s = moments.number(row, 3);
  moment.record.asleep = moments.whole_number(row, 4) != 0;
  return moment;
}

std::vector<sim::Vec3> read_shape(const CsvFile& shapes, const std::string& panel) {
  std::vector<sim::Vec3> positions;
  for (std::size_t row = 0; row < shapes.rows(); ++row) {
    if (shapes.text(row, 0) != panel) continue;
    if (shapes.whole_number(row, 1) != static_cast<int>(positions.size())) {
      shapes.fail(row,
                  fmt::format("panel {}: found vertex {}, expected {}", panel, shapes.text(row, 1), positions.size()));
    }
    positions.emplace_back(shapes.number(row, 2), shapes.number(row, 3), shapes.number(row, 4));
  }
  return positions;
}

/// Returns a recording of a scene and its garment, as their files are at present, without moments.
Recording begin_recording(const std::string& scene_name) {
  Recording recording;
  recording.scene = find_scene(scene_name, {});
  LoadedGarment loaded = load_garment(recording.scene);
  recording.garment = std::move(loaded.garment);
  recording.pins = std::move(loaded.pins);
  return recording;
}

/// Reads the moments of one scene from FIGURE.csv and FIGURE_shapes.csv in the folder. Stretch is measured again from
/// the shapes, and the largest numbers cover only these moments. Throws InputError that names the file and the line if
/// a table is broken, has no moment of this scene, or has another number of vertices than the garment.
Recording read_recording(const std::filesystem::path& folder, const std::string& figure,
                         const std::string& scene_name) {
  const CsvFile moments(folder / (figure + ".csv"), moment_columns);
  const std::filesystem::path shapes_file = folder / (figure + "_shapes.csv");
  const CsvFile shapes(shapes_file, shape_columns);
  Recording recording = begin_recording(scene_name);
  const std::size_t vertices = recording.garment->mesh.positions.size();
  for (std::size_t row = 0; row < moments.rows(); ++row) {
    if (moments.text(row, 1) != scene_name) continue;
    Moment moment = read_moment(moments, row);
    moment.positions = read_shape(shapes, moments.text(row, 0));
    if (moment.positions.size() != vertices) {
      throw InputError("{}: panel {}: found {} vertices, expected {}, as the garment of {} has", shapes_file.string(),
                       moments.text(row, 0), moment.positions.size(), vertices, scene_name);
    }
    moment.record.stretch = sim::measure_stretch(recording.garment->springs, moment.positions);
    moment.record.surface_stretch = sim::measure_surface_stretch(*recording.garment, moment.positions);
    add_stretch(moment.record, recording);
    recording.moments.push_back(std::move(moment));
  }
  if (recording.moments.empty()) {
    throw InputError("{}: found no moment of the scene {}, expected one", (folder / (figure + ".csv")).string(),
                     scene_name);
  }
  return recording;
}

/// Reads the recordings of several scenes in one figure.
template <std::size_t count>
void read_recordings(const std::filesystem::path& folder, const std::string& figure,
                     const std::array<const char*, count>& scenes,
                     std::array<std::optional<Recording>, count>& places) {
  for (std::size_t i = 0; i < count; ++i) places[i] = read_recording(folder, figure, scenes[i]);
}

void read_figure3(Results& results, const std::filesystem::path& folder) {
  const CsvFile table(folder / "fig3.csv", figure3_columns);
  if (!results.fall) results.fall.emplace().frames = begin_recording(fall_scene);
  StepRecording& fall = *results.fall;
  fall.vertex = followed_vertex(fall.frames.scene);
  fall.time_step_s = table.number(0, 1);
  for (std::size_t row = 0; row < table.rows(); ++row) fall.moved_m.push_back(table.number(row, 2));
  // A run that ends before its last frame ends with the cloth at rest.
  const auto max_steps = static_cast<std::size_t>(
      fall_frames.back() * sim::equal_substeps(solver_settings(fall.frames.scene.simulation.solver)));
  fall.came_to_rest = table.rows() < max_steps;
}

void read_figure6(Results& results, const std::filesystem::path& folder) {
  const CsvFile table(folder / "fig6.csv", figure6_columns);
  std::vector<FrameTimes>& times = results.frame_times;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const FrameTimes next{table.whole_number(row, 0), table.whole_number(row, 1), table.whole_number(row, 2), {}};
    if (times.empty() || times.back().triangles != next.triangles || times.back().substeps != next.substeps) {
      times.push_back(next);
    }
    const double frame_ms = table.number(row, 4);
    if (frame_ms <= 0.0 || next.triangles <= 0) {
      table.fail(row, "found a time or a number of triangles of 0 or less, expected more");
    }
    times.back().frame_ms.push_back(frame_ms);
  }
}

// Returns a number, or infinity for the empty cells at the end of a run that diverged.
double number_or_infinity(const CsvFile& table, std::size_t row, std::size_t column) {
  return table.text(row, column).empty() ? INFINITY : table.number(row, column);
}

void read_figure7(Results& results, const std::filesystem::path& folder) {
  const CsvFile table(folder / "fig7.csv", figure7_columns);
  std::size_t row = 0;
  for (const double rate_hz : method_rates_hz) {
    for (const sim::SolverKind kind : compared_methods) {
      MethodRun run;
      run.kind = kind;
      run.time_step_s = 1.0 / rate_hz;
      const auto belongs = [&] {
        return table.text(row, 0) == to_name(kind) &&
               std::abs(table.number(row, 1) - run.time_step_s) < 1e-3 * run.time_step_s;
      };
      for (; row < table.rows() && belongs(); ++row) {
        run.max_stretch.push_back(number_or_infinity(table, row, 3));
        run.moved_rms_m.push_back(number_or_infinity(table, row, 4));
      }
      if (run.max_stretch.size() < static_cast<std::size_t>(std::lround(methods_duration_s * rate_hz))) {
        run.diverged_at_s = run.time_step_s * static_cast<double>(run.max_stretch.size() + 1);
      }
      results.methods.push_back(std::move(run));
    }
  }
  if (row < table.rows()) table.fail(row, "found a method or a time step out of turn");
}

}  // namespace

void read_figure(const std::string& name, const std::filesystem::path& folder, ClaimResults& results) {
  if (name == "fig2") {
    if (!results.fall) results.fall.emplace();
    results.fall->frames = read_recording(folder, name, fall_scene);
  }
  if (name == "fig3") read_figure3(results, folder);
  if (name == "fig4") read_recordings(folder, name, pinned_scenes, results.pinned);
  if (name == "fig5") read_recordings(folder, name, shirt_scenes, results.shirts);
  if (name == "fig6") read_figure6(results, folder);
  if (name == "fig7") read_figure7(results, folder);
  if (name == "fig8") read_figure8(results, folder);
  if (name == "truth" || name == "fig9") read_truth(results.truth, folder / (name + ".csv"));
}

}  // namespace taut::app
