#include "app/figures/moment_tables.hpp"

#include <fmt/core.h>

#include <vector>

#include "app/base/errors.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/figures/csv.hpp"
#include "app/models/garment_loading.hpp"

namespace taut::app {
namespace {

const std::vector<std::string> moment_columns = {"panel",
                                                 "scene",
                                                 "frame",
                                                 "time_s",
                                                 "at_rest",
                                                 "max_stretch",
                                                 "p99_stretch",
                                                 "max_surface_stretch",
                                                 "p99_surface_stretch",
                                                 "mean_stretch"};
const std::vector<std::string> shape_columns = {"panel", "vertex", "x_m", "y_m", "z_m"};

// The panels of a figure go on from one recording to the next.
template <class Visit>
void for_each_panel(std::span<const Recording* const> recordings, const Visit& visit) {
  char letter = 'a';
  for (const Recording* recording : recordings) {
    for (const Moment& moment : recording->moments) {
      visit(std::string(1, letter++), *recording, moment);
    }
  }
}

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
    if (shapes.text(row, 0) != panel) {
      continue;
    }
    if (shapes.whole_number(row, 1) != static_cast<int>(positions.size())) {
      shapes.fail(row, fmt::format("panel {}: found vertex {}, expected {}", panel, shapes.text(row, 1),
                                   positions.size()));
    }
    positions.emplace_back(shapes.number(row, 2), shapes.number(row, 3), shapes.number(row, 4));
  }
  return positions;
}

}  // namespace

std::string moments_csv(std::span<const Recording* const> recordings) {
  CsvTable table(moment_columns);
  for_each_panel(recordings, [&](const std::string& panel, const Recording& recording, const Moment& moment) {
    const FrameRecord& record = moment.record;
    const sim::SurfaceStretch& surface = moment.record.surface_stretch;
    table.add({panel, cell(recording.scene.name), std::to_string(record.frame), cell(record.time_s),
               record.asleep ? "1" : "0", cell(record.stretch.max), cell(record.stretch.p99),
               cell(surface.max), cell(surface.p99), cell(record.stretch.mean)});
  });
  return table.text();
}

std::string shapes_csv(std::span<const Recording* const> recordings) {
  CsvTable table(shape_columns);
  for_each_panel(recordings, [&](const std::string& panel, const Recording&, const Moment& moment) {
    for (std::size_t v = 0; v < moment.positions.size(); ++v) {
      const sim::Vec3& p = moment.positions[v];
      table.add({panel, std::to_string(v), cell(p.x), cell(p.y), cell(p.z)});
    }
  });
  return table.text();
}

Recording read_recording(const std::filesystem::path& folder, const std::string& figure,
                         const std::string& scene_name) {
  const CsvFile moments(folder / (figure + ".csv"), moment_columns);
  const std::filesystem::path shapes_file = folder / (figure + "_shapes.csv");
  const CsvFile shapes(shapes_file, shape_columns);
  Recording recording;
  recording.scene = find_scene(scene_name, {});
  LoadedGarment loaded = load_garment(recording.scene);
  recording.garment = loaded.garment;
  recording.pins = std::move(loaded.pins);
  const std::size_t vertices = recording.garment->mesh.positions.size();
  for (std::size_t row = 0; row < moments.rows(); ++row) {
    if (moments.text(row, 1) != scene_name) {
      continue;
    }
    Moment moment = read_moment(moments, row);
    moment.positions = read_shape(shapes, moments.text(row, 0));
    if (moment.positions.size() != vertices) {
      throw InputError(fmt::format("{}: panel {}: found {} vertices, expected {}, as the garment of {} has",
                                   shapes_file.string(), moments.text(row, 0), moment.positions.size(),
                                   vertices, scene_name));
    }
    moment.record.stretch = sim::measure_stretch(recording.garment->springs, moment.positions);
    moment.record.surface_stretch = sim::measure_surface_stretch(*recording.garment, moment.positions);
    note_stretch(moment.record, recording);
    recording.moments.push_back(std::move(moment));
  }
  if (recording.moments.empty()) {
    throw InputError(fmt::format("{}: found no moment of the scene {}, expected one",
                                 (folder / (figure + ".csv")).string(), scene_name));
  }
  return recording;
}

}  // namespace taut::app
