#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/base/errors.hpp"
#include "app/base/suggest.hpp"
#include "app/figures/csv.hpp"
#include "app/figures/figures.hpp"

namespace taut::app {
namespace {

const std::vector<std::string> columns = {
    "test",        "triangles",           "method",   "step_factor",       "substeps", "time_s", "frame_ms",
    "max_stretch", "max_surface_stretch", "energy_j", "rms_speed_m_per_s", "sunk_m"};

/// The value that has its name in a cell.
template <class Values>
auto named(const CsvFile& table, std::size_t row, std::size_t column, const Values& values) {
  std::vector<std::string> names;
  for (const auto value : values) {
    if (table.text(row, column) == name_of(value)) {
      return value;
    }
    names.emplace_back(name_of(value));
  }
  table.fail(row, fmt::format("{}: found '{}', expected one of {}", columns[column], table.text(row, column),
                              joined(names)));
}

/// Adds a row to the trial it belongs to, which is the last one or a new one.
void read_row(const CsvFile& table, std::size_t row, Results& results) {
  MethodTrial next = {named(table, row, 0, all_method_tests),
                      named(table, row, 2, trial_methods),
                      table.whole_number(row, 1),
                      table.whole_number(row, 3),
                      table.whole_number(row, 4),
                      false,
                      {}};
  MethodTrials& trials = results.trials_of(next.test);
  if (trials.empty() || trials.back().kind != next.kind || trials.back().triangles != next.triangles ||
      trials.back().step_factor != next.step_factor) {
    trials.push_back(std::move(next));
  }
  if (table.text(row, 7).empty()) {
    trials.back().is_lost = true;
    return;
  }
  const double frame_ms = table.text(row, 6).empty() ? NAN : table.number(row, 6);
  trials.back().frames.push_back({table.number(row, 5), frame_ms, table.number(row, 7), table.number(row, 8),
                                  table.number(row, 9), table.number(row, 10), table.number(row, 11)});
}

std::size_t trials_in(MethodTest test) {
  return trial_methods.size() * (test == MethodTest::time    ? trial_meshes.size()
                                 : test == MethodTest::steps ? trial_step_factors.size()
                                                             : 1);
}

}  // namespace

std::string figure8_csv(const Results& results) {
  CsvTable table(columns);
  for (const MethodTest test : all_method_tests) {
    for (const MethodTrial& trial : results.trials_of(test)) {
      const auto add = [&](const TrialFrame& frame) {
        table.add({name_of(test), std::to_string(trial.triangles), name_of(trial.kind),
                   std::to_string(trial.step_factor), std::to_string(trial.substeps), cell(frame.time_s),
                   cell(frame.frame_ms), cell(frame.stretch), cell(frame.surface_stretch),
                   cell(frame.energy_j), cell(frame.speed_m_per_s), cell(frame.sunk_m)});
      };
      std::for_each(trial.frames.begin(), trial.frames.end(), add);
      if (trial.is_lost) {
        // Of the frame in which it was lost nothing is known.
        add({NAN, NAN, NAN, NAN, NAN, NAN, NAN});
      }
    }
  }
  return table.text();
}

void read_figure8(const std::filesystem::path& folder, Results& results) {
  const CsvFile table(folder / "fig8.csv", columns);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    read_row(table, row, results);
  }
  for (const MethodTest test : all_method_tests) {
    const std::size_t found = results.trials_of(test).size(), expected = trials_in(test);
    if (found != expected) {
      throw InputError(fmt::format("{}: found {} trials of the test {}, expected {}",
                                   (folder / "fig8.csv").string(), found, name_of(test), expected));
    }
  }
}

}  // namespace taut::app
