#include "app/sweeps/sweep_results.hpp"

#include <fstream>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/interruption.hpp"
#include "app/figures/draw_figures.hpp"
#include "app/models/surface_colours.hpp"
#include "app/output/csv.hpp"
#include "app/sweeps/sweep_run.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

bool is_as_planned(const Sweep& sweep, std::size_t run, const Json& result) {
  return result.is_object() && result.value("index", most_runs) == run &&
         result.value("scene", "") == sweep.scene_hash(run) && result.value("program", "") == sweep.program;
}

/// How many files of the runs have this ending.
std::set<std::string> stems_of(const Sweep& sweep, const char* ending) {
  std::set<std::string> stems;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(sweep.folder / "runs", error)) {
    if (entry.path().extension() == ending) stems.insert(entry.path().stem().string());
  }
  return stems;
}

constexpr std::array measures = {"max_stretch",
                                 "max_surface_stretch",
                                 "max_p99_stretch",
                                 "max_p99_surface_stretch",
                                 "final_max_stretch",
                                 "frames_over_bound",
                                 "smallest_distance",
                                 "mean_substeps",
                                 "mean_sim_ms",
                                 "total_sim_ms",
                                 "final_rms_speed",
                                 "frames",
                                 "vertices",
                                 "triangles",
                                 "state_hash",
                                 "host",
                                 "where"};

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

/// Hands out every run with its result, or null, in order.
void for_each_result(const Sweep& sweep, const std::function<void(std::size_t run, const Json* result)>& use) {
  for (std::size_t run = 0; run < sweep.runs(); ++run) {
    throw_if_interrupted();
    const std::optional<Json> result = result_of(sweep, run);
    use(run, result ? &*result : nullptr);
  }
}

}  // namespace

std::optional<Json> result_of(const Sweep& sweep, std::size_t run) {
  std::ifstream in(sweep.file(run, ".json"));
  Json result = in ? Json::parse(in, nullptr, false) : Json();
  return is_as_planned(sweep, run, result) ? std::optional(std::move(result)) : std::nullopt;
}

bool is_final(const Json& result) { return result.value("end", "") == "done" || result.value("end", "") == "broken"; }

SweepStatus status_of(const Sweep& sweep) {
  SweepStatus status;
  for_each_result(sweep, [&](std::size_t run, const Json* result) {
    const std::string end = result != nullptr ? result->value("end", "") : "";
    status.done += end == "done" ? 1 : 0;
    status.broken += end == "broken" ? 1 : 0;
    status.failed += end == "failed" ? 1 : 0;
    if (end == "failed" && status.first_failure.empty()) {
      status.first_failure = fmt::format("run {}: {}", run, result->value("where", ""));
    }
    if (result == nullptr || !is_final(*result)) status.missing.push_back(run);
  });
  std::set<std::string> locked = stems_of(sweep, ".lock");
  std::erase_if(locked,
                [&](const std::string& stem) { return !RunLock::is_anybodys(sweep.file(std::stoul(stem), ".lock")); });
  const std::set<std::string> saved = stems_of(sweep, ".checkpoint");
  status.working = locked.size();
  status.stopped = static_cast<std::size_t>(
      std::ranges::count_if(saved, [&](const std::string& stem) { return !locked.contains(stem); }));
  return status;
}

std::string ranges_text(std::span<const std::size_t> numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text +=
        (text.empty() ? "" : ",") + std::to_string(numbers[i]) + (last > i ? '-' + std::to_string(numbers[last]) : "");
    i = last + 1;
  }
  return text;
}

std::string sweep_table(const Sweep& sweep) {
  std::vector<std::string> columns = {"index"};
  for (const SweepAxis& axis : sweep.axes) columns.push_back(cell(axis.key));
  columns.emplace_back("end");
  columns.insert(columns.end(), measures.begin(), measures.end());
  CsvTable table(columns);
  for_each_result(sweep, [&](std::size_t run, const Json* result) {
    std::vector<std::string> row = {std::to_string(run)};
    const Json values = sweep.values(run);
    for (const Json& value : values) row.push_back(cell(value_label(value)));
    row.push_back(result != nullptr ? cell_of(result, "end") : "missing");
    for (const char* name : measures) row.push_back(cell_of(result, name));
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
  if (pictures.empty()) return {};
  // Where some are missing, what is there fills up.
  const std::size_t columns = step == 1 ? columns_of(sweep) : 10;
  return contact_sheet(pictures, 1.0F, {.columns = static_cast<int>(columns), .cell_px = 400, .title_px = 16.0F});
}

}  // namespace taut::app
