#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/drawing/plots/plot_sheet.hpp"
#include "app/figures/csv.hpp"
#include "app/figures/figures.hpp"

namespace taut::app {
namespace {

const std::vector<std::string> columns = {"method", "time_step_s", "time_s", "max_stretch", "moved_rms_m"};

Stroke stroke_of(sim::SolverKind kind) {
  switch (kind) {
    case sim::SolverKind::ideal:
      return {palette::orange, 4.0F, {1.2F, 1.8F}};
    case sim::SolverKind::provot:
      return {palette::vermilion, 4.0F, {5.0F, 2.0F}};
    case sim::SolverKind::strong:
      return {palette::blue, 4.5F, {}};
    default:
      return {};
  }
}

std::string legend_name(const MethodRun& run) {
  constexpr std::array names = {"ideal springs", "threshold of 5 %", "strong constraint"};
  std::string name = names[static_cast<std::size_t>(run.kind)];
  if (run.diverged_at_s) {
    name += fmt::format(" (diverge after {:.2f} s)", *run.diverged_at_s);
  }
  return name;
}

Curve curve_of(const MethodRun& run, const std::vector<double>& values, double factor) {
  Curve curve;
  curve.name = legend_name(run);
  curve.stroke = stroke_of(run.kind);
  // Between two figures of a vibration there is nothing to see: one line for the largest in a 64th second.
  const auto window = static_cast<std::size_t>(std::max(1L, std::lround(1.0 / 64.0 / run.time_step_s)));
  for (std::size_t i = 0; i < values.size(); i += window) {
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(std::min(values.size(), i + window));
    const double largest = *std::max_element(values.begin() + static_cast<std::ptrdiff_t>(i), end);
    curve.points.push_back({static_cast<double>(i + 1) * run.time_step_s, factor * largest});
  }
  return curve;
}

std::vector<MethodRun> runs_with(const Results& results, std::size_t rate) {
  return {results.methods.begin() + static_cast<std::ptrdiff_t>(3 * rate),
          results.methods.begin() + static_cast<std::ptrdiff_t>(3 * rate + 3)};
}

Plot stretch_plot(const std::vector<MethodRun>& runs) {
  Plot plot;
  plot.x = {"time in s", 0.0, 10.0};
  plot.y = {"largest stretch", 0.0, 20.0, false, " %"};
  for (const MethodRun& run : runs) {
    plot.curves.push_back(curve_of(run, run.max_stretch, 100.0));
  }
  plot.levels = {{5.0, ""}};
  return plot;
}

Plot unrest_plot(const std::vector<MethodRun>& runs) {
  Plot plot;
  plot.x = {"time in s", 0.0, 10.0};
  plot.y = {"RMS of |p(t) − p(t − Δt)|  in metres", 1e-18, 1.0, true};
  for (const MethodRun& run : runs) {
    plot.curves.push_back(curve_of(run, run.moved_rms_m, 1.0));
  }
  plot.legend = LegendCorner::none;
  return plot;
}

std::string speed_text(const MethodRun& run) {
  const auto unrest = measure_unrest(run);
  return unrest ? scientific(unrest->speed_m_per_s) : "lost";
}

std::string unrest_text(const std::vector<MethodRun>& runs) {
  return fmt::format("speed at the end in m/s: threshold {}, strong {}",
                     speed_text(runs[static_cast<std::size_t>(sim::SolverKind::provot)]),
                     speed_text(runs[static_cast<std::size_t>(sim::SolverKind::strong)]));
}

// A run that diverges has cells left empty at its end.
double number_or_infinity(const CsvFile& table, std::size_t row, std::size_t column) {
  return table.text(row, column).empty() ? INFINITY : table.number(row, column);
}

}  // namespace

std::string figure7_csv(const Results& results) {
  CsvTable table(columns);
  for (const MethodRun& run : results.methods) {
    for (std::size_t i = 0; i < run.max_stretch.size(); ++i) {
      table.add({name_of(run.kind), cell(run.time_step_s), cell(static_cast<double>(i + 1) * run.time_step_s),
                 cell(run.max_stretch[i]), cell(run.moved_rms_m[i])});
    }
  }
  return table.text();
}

void read_figure7(const std::filesystem::path& folder, Results& results) {
  const CsvFile table(folder / "fig7.csv", columns);
  std::size_t row = 0;
  for (const double rate_hz : method_rates_hz) {
    for (const sim::SolverKind kind : compared_methods) {
      MethodRun run;
      run.kind = kind;
      run.time_step_s = 1.0 / rate_hz;
      const auto belongs = [&] {
        return table.text(row, 0) == name_of(kind) &&
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
  if (row < table.rows()) {
    table.fail(row, "found a method or a time step out of turn");
  }
}

// Section III: do springs that are pulled back to a threshold vibrate, and does the strong constraint not?
Drawing draw_figure7(const Results& results, LazyOffscreenRenderer&) {
  std::vector<PlotPanel> stretch, unrest;
  for (std::size_t rate = 0; rate < method_rates_hz.size(); ++rate) {
    const std::vector<MethodRun> runs = runs_with(results, rate);
    const std::string step = fmt::format("steps of 1/{:.0f} s", method_rates_hz[rate]);
    const char letter = rate == 0 ? 'a' : 'b';
    stretch.push_back({stretch_plot(runs), {letter, "stretch, " + step, ""}});
    unrest.push_back({unrest_plot(runs),
                      {static_cast<char>(letter + 2), "movement in a step, " + step, unrest_text(runs)}});
  }
  stretch.insert(stretch.end(), unrest.begin(), unrest.end());
  return draw_plot_sheet(std::move(stretch), {});
}

}  // namespace taut::app
