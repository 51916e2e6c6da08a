#include "app/sweeps/sweep_columns.hpp"

#include "app/sweeps/sweep_results.hpp"

namespace taut::app {
namespace {

constexpr std::size_t most_columns = 4;

std::vector<std::size_t> others_of(const Sweep& sweep, const AxesOfPlot& axes, std::size_t run) {
  std::vector<std::size_t> choice = sweep.choice(run);
  choice[axes.x] = 0;
  if (axes.curves < choice.size()) {
    choice[axes.curves] = 0;
  }
  return choice;
}

}  // namespace

Columns columns_of(const Sweep& sweep, const AxesOfPlot& axes) {
  Columns columns;
  for (std::size_t run = 0; run < sweep.runs() && columns.of_choice.size() <= most_columns; ++run) {
    const std::vector<std::size_t> choice = others_of(sweep, axes, run);
    if (columns.of_choice.emplace(choice, columns.of_choice.size()).second) {
      std::string title;
      for (std::size_t k = 0; k < choice.size(); ++k) {
        if (k != axes.x && k != axes.curves && sweep.axes[k].values.size() > 1) {
          title += (title.empty() ? "" : ", ") + sweep.axes[k].key + " = " +
                   value_label(sweep.axes[k].values[choice[k]]);
        }
      }
      columns.titles.push_back(title);
    }
  }
  return columns.of_choice.size() <= most_columns
             ? columns
             : Columns{{"mean, smallest and largest of the other axes"}, {}};
}

Table gather(const Sweep& sweep, const AxesOfPlot& axes, const Columns& columns,
             const SweepMeasure& measure) {
  Table table;
  for_each_result(sweep, [&](std::size_t run, const Json* result) {
    if (result == nullptr || !result->contains(measure.name) || !result->at(measure.name).is_number()) {
      return;
    }
    const std::vector<std::size_t> choice = sweep.choice(run);
    const std::size_t column =
        columns.of_choice.empty() ? 0 : columns.of_choice.at(others_of(sweep, axes, run));
    const std::size_t curve = axes.curves < choice.size() ? choice[axes.curves] : 0;
    Found& found = table[{column, curve, choice[axes.x]}];
    found.values.push_back(measure.factor * result->at(measure.name).get<double>());
    found.is_broken = found.is_broken || result->value("end", "") == "broken";
  });
  return table;
}

}  // namespace taut::app
