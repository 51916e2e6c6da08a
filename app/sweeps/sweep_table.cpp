#include "app/sweeps/sweep_table.hpp"

#include <algorithm>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/figures/csv.hpp"
#include "app/models/image_reading.hpp"
#include "app/report/report.hpp"
#include "app/sweeps/sweep_results.hpp"

namespace taut::app {
namespace {

constexpr std::array measures = {
    SweepMeasure{"max_stretch", "largest stretch of springs", 100.0, " %"},
    SweepMeasure{"max_surface_stretch", "largest stretch of the surface", 100.0, " %"},
    SweepMeasure{"max_p99_stretch", "99th percentile of stretch", 100.0, " %"},
    SweepMeasure{"max_p99_surface_stretch", "99th percentile of the surface's stretch", 100.0, " %"},
    SweepMeasure{"final_max_stretch", "stretch of springs at the end", 100.0, " %"},
    SweepMeasure{"frames_over_bound", "frames over the bound"},
    SweepMeasure{"smallest_distance", "smallest distance", 1000.0, " mm"},
    SweepMeasure{"mean_substeps", "time steps in a frame"},
    SweepMeasure{"mean_sim_ms", "processor time for a frame", 1.0, " ms"},
    SweepMeasure{"total_sim_ms", "processor time for the run", 0.001, " s"},
    SweepMeasure{"final_rms_speed", "root mean square speed at the end", 1.0, " m/s"},
    SweepMeasure{"frames", "frames"},
    SweepMeasure{"vertices", "vertices"},
    SweepMeasure{"triangles", "triangles"},
};
constexpr std::array texts = {"state_hash", "host", "where"};

/// Empty where the result does not say it.
std::string cell_of(const Json* result, const char* name) {
  const Json value = result != nullptr && result->contains(name) ? result->at(name) : Json();
  return value.is_null() ? "" : value.is_string() ? cell(value.get<std::string>()) : value.dump();
}

/// The values of a run that differ between runs.
std::string title_of(const Sweep& sweep, std::size_t run) {
  std::string title;
  const std::vector<std::size_t> choice = sweep.choice(run);
  for (std::size_t k = 0; k < choice.size(); ++k) {
    const SweepAxis& axis = sweep.axes[k];
    if (const Json& value = axis.values[choice[k]]; axis.values.size() > 1) {
      // Numbers do not say what they are.
      const std::string name = value.is_string() ? "" : axis.key.substr(axis.key.rfind('.') + 1) + ' ';
      title += (title.empty() ? "" : ", ") + name + value_label(value);
    }
  }
  return title;
}

renderer::Image read_picture(const std::filesystem::path& file) {
  const TextureImage image = decode_image(read_text_file(file));
  return {static_cast<int>(image.width_px), static_cast<int>(image.height_px), 4, *image.rgba};
}

std::size_t columns_of(const Sweep& sweep) {
  for (std::size_t k = sweep.axes.size(); k-- > 0;) {
    if (const std::size_t values = sweep.axes[k].values.size(); values > 1) {
      return std::min<std::size_t>(values, 10);
    }
  }
  return 1;
}

}  // namespace

std::span<const SweepMeasure> sweep_measures() {
  return measures;
}

std::string sweep_table(const Sweep& sweep) {
  std::vector<std::string> columns = {"index"};
  for (const SweepAxis& axis : sweep.axes) {
    columns.push_back(cell(axis.key));
  }
  columns.emplace_back("end");
  for (const SweepMeasure& measure : measures) {
    columns.emplace_back(measure.name);
  }
  columns.insert(columns.end(), texts.begin(), texts.end());
  CsvTable table(columns);
  for_each_result(sweep, [&](std::size_t run, const Json* result) {
    std::vector<std::string> row = {std::to_string(run)};
    const Json values = sweep.values(run);
    for (const Json& value : values) {
      row.push_back(cell(value_label(value)));
    }
    row.push_back(result != nullptr ? cell_of(result, "end") : "missing");
    for (const SweepMeasure& measure : measures) {
      row.push_back(cell_of(result, measure.name));
    }
    for (const char* name : texts) {
      row.push_back(cell_of(result, name));
    }
    table.add(std::move(row));
  });
  return table.text();
}

renderer::Image sweep_sheet(const Sweep& sweep) {
  const std::size_t step = (sweep.runs() + most_on_sheet - 1) / most_on_sheet;
  std::vector<DrawnFigure> pictures;
  for (std::size_t run = 0; run < sweep.runs(); run += step) {
    const std::filesystem::path file = sweep.file(run, ".png");
    if (std::error_code error; std::filesystem::exists(file, error)) {
      pictures.push_back({title_of(sweep, run), "", read_picture(file)});
    }
  }
  if (pictures.empty()) {
    return {};
  }
  // Where some are missing, what is there fills up.
  const std::size_t columns = step == 1 ? columns_of(sweep) : 10;
  return contact_sheet(pictures, 1.0F,
                       {.columns = static_cast<int>(columns), .cell_px = 400, .title_px = 16.0F});
}

}  // namespace taut::app
