#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/drawing/plots/plot.hpp"
#include "tests/study/claims/csv_file.hpp"
#include "tests/study/claims/trials.hpp"

namespace taut::app {
namespace {

struct Look {
  const char* name;
  const char* setting;
  Stroke stroke;
  Marker marker;
};

/// Looks of trial_methods, in their order.
const std::array<Look, trial_methods.size()> looks = {
    {{"ideal springs",
      "200 N/m; steps as short as these ask for",
      {palette::orange, 4.5F, {1.2F, 1.8F}},
      Marker::square},
     {"Provot 1995",
      "these springs; over-long ones pulled back once a step",
      {palette::vermilion, 4.5F, {5.0F, 2.0F}},
      Marker::square},
     {"Baraff and Witkin 1998",
      "implicit; 1000 N/m, 1 step a frame if it may",
      {palette::green, 4.5F, {}},
      Marker::disc},
     {"Vassilev 2001",
      "these springs; over-long ones part no further",
      {palette::purple, 4.5F, {3.0F, 1.5F}},
      Marker::ring},
     {"Goldenthal 2007", "fast projection of all edges; 5 steps a frame", {palette::sky, 4.5F, {}}, Marker::disc},
     {"the paper, literally",
      "strong constraint; 20 steps of 4 sweeps a frame",
      {palette::blue, 4.5F, {}},
      Marker::disc},
     {"bounded (this program)", "1 % of the surface; chooses its steps", {palette::ink, 9.0F, {}}, Marker::disc}}};

const Look& solver_look(sim::SolverKind kind) {
  return looks[static_cast<std::size_t>(std::ranges::find(trial_methods, kind) - trial_methods.begin())];
}

Curve make_curve(sim::SolverKind kind, bool has_markers) {
  const Look& look = solver_look(kind);
  return {"", {}, look.stroke, has_markers ? look.marker : Marker::none};
}

/// Returns the curves of all methods. `add_points` adds the points of a trial.
template <class AddPoints>
std::vector<Curve> make_curves(const MethodTrials& trials, bool has_markers, AddPoints add_points) {
  std::vector<Curve> curves;
  for (const sim::SolverKind kind : trial_methods) {
    Curve curve = make_curve(kind, has_markers);
    for (const MethodTrial& trial : trials) {
      if (trial.kind == kind) add_points(trial, curve);
    }
    curves.push_back(std::move(curve));
  }
  // The last method's line is the thickest and is drawn below the others.
  std::rotate(curves.begin(), curves.end() - 1, curves.end());
  return curves;
}

Curve line_at(double x, const Axis& y) {
  return {"", {{x, y.minimum}, {x, y.maximum}}, {palette::quiet_ink, 3.0F, {2.0F, 4.0F}}};
}

/// Returns an axis around the percentages, with powers of ten written in full.
Axis stretch_axis(const std::vector<double>& percents) {
  Axis axis = decades_around("largest stretch of an edge", percents);
  axis.suffix = " %";
  for (double tick = axis.minimum; tick < 0.99 * axis.maximum; tick *= 10.0) axis.chosen.push_back(tick);
  const double largest = *std::ranges::max_element(percents);
  axis.maximum = std::clamp(1.7 * largest, 2.0 * axis.minimum, axis.maximum);
  return axis;
}

PlotPanel time_panel(const MethodTrials& trials) {
  Plot plot;
  std::vector<double> times_ms, stretches = {100.0 * trial_max_stretch};
  plot.curves = make_curves(trials, true, [&](const MethodTrial& trial, Curve& curve) {
    if (trial.is_lost || trial.frames.empty()) return;
    curve.points.push_back({100.0 * trial.max_stretch_seen(), trial.ranked_ms(0.5)});
    curve.bars.push_back({trial.ranked_ms(0.25), trial.ranked_ms(0.75)});
    times_ms.push_back(trial.ranked_ms(0.5));
    stretches.push_back(curve.points.back()[0]);
  });
  plot.x = stretch_axis(stretches);
  plot.y = decades_around("processor time of a frame in ms", times_ms);
  plot.curves.insert(plot.curves.begin(), line_at(100.0 * trial_max_stretch, plot.y));
  return {std::move(plot),
          {'a', "time and stretch, on four meshes", "upwards: 9x9 cloth, T-shirts of 1028, 5280, 10600 triangles"}};
}

PlotPanel energy_panel(const MethodTrials& trials) {
  Plot plot;
  double min_mj = 0.0, max_mj = 0.0, end_s = 0.0;
  plot.curves = make_curves(trials, false, [&](const MethodTrial& trial, Curve& curve) {
    for (const TrialFrame& frame : trial.frames) {
      curve.points.push_back({frame.time_s, 1e3 * frame.energy_j});
      min_mj = std::min(min_mj, 1e3 * frame.energy_j);
      max_mj = std::max(max_mj, 1e3 * frame.energy_j);
      end_s = std::max(end_s, frame.time_s);
    }
  });
  const double room_mj = 0.06 * (max_mj - min_mj);
  plot.x = {"time in s", 0.0, std::max(end_s, 1e-3)};
  plot.y = {"energy of motion and height in mJ", min_mj - room_mj, max_mj + room_mj + 1e-6};
  return {std::move(plot),
          {'b', "energy in the fall, without air", "T-shirt of 1028; what springs store is not in it"}};
}

PlotPanel rest_panel(const MethodTrials& trials) {
  Plot plot;
  std::vector<double> speeds;
  double end_s = shaken_s;
  plot.curves = make_curves(trials, false, [&](const MethodTrial& trial, Curve& curve) {
    // Swings would hide each other, so the curve shows the largest value of every quarter of a second.
    constexpr std::size_t window = 15;
    for (std::size_t i = 0; i < trial.frames.size(); i += window) {
      double largest = 0.0;
      for (std::size_t k = i; k < std::min(i + window, trial.frames.size()); ++k) {
        largest = std::max(largest, trial.frames[k].speed_m_per_s);
        end_s = std::max(end_s, trial.frames[k].time_s);
      }
      curve.points.push_back({trial.frames[i].time_s, largest});
      speeds.push_back(largest);
    }
  });
  plot.x = {"time in s", 0.0, end_s};
  plot.y = decades_around("RMS speed in m/s, the largest in 1/4 s", speeds);
  plot.curves.insert(plot.curves.begin(), line_at(shaken_s, plot.y));
  return {
      std::move(plot),
      {'c', fmt::format("speed; pins are shaken, and held from {:g} s on", shaken_s),
       fmt::format("T-shirt of 1028, in air; shaken by {:g} cm, {:g} times a second", 1e2 * shaken_by_m, shaken_hz)}};
}

Axis factor_axis() { return {"length of a time step, times its own", 0.85, 7.5, true, "", {1.0, 2.0, 5.0}}; }

PlotPanel steps_panel(const MethodTrials& trials) {
  Plot plot;
  std::vector<double> stretches = {1.0};
  plot.curves = make_curves(trials, true, [&](const MethodTrial& trial, Curve& curve) {
    const double percent = 100.0 * trial.max_stretch_seen();
    curve.points.push_back({static_cast<double>(trial.step_factor), percent});
    if (std::isfinite(percent)) stretches.push_back(percent);
  });
  plot.x = factor_axis();
  plot.y = decades_around("largest stretch of an edge", stretches);
  plot.y.suffix = " %";
  // Space above all measurements.
  plot.y.maximum *= 10.0;
  const double lost_at = std::pow(10.0, -0.4) * plot.y.maximum;
  plot.levels = {{lost_at, "lost"}, {100.0 * trial_max_stretch, ""}};
  for (std::size_t i = 0; i < trial_methods.size(); ++i) {
    Curve lost = make_curve(trial_methods[i], true);
    lost.stroke.thickness_px = 0.0F;
    lost.marker = Marker::cross;
    for (const MethodTrial& trial : trials) {
      if (trial.kind == trial_methods[i] && trial.is_lost) {
        // Crosses of several methods are side by side.
        lost.points.push_back({trial.step_factor * std::pow(1.07, static_cast<double>(i) - 3.0), lost_at});
      }
    }
    plot.curves.push_back(std::move(lost));
  }
  return {std::move(plot), {'d', "stretch with longer time steps", "T-shirt of 1028, 1 s; a cross: lost"}};
}

PlotPanel sunk_panel(const MethodTrials& trials) {
  Plot plot;
  double deepest_cm = 1.0;
  plot.curves = make_curves(trials, true, [&](const MethodTrial& trial, Curve& curve) {
    if (!trial.is_lost && !trial.frames.empty()) {
      curve.points.push_back({static_cast<double>(trial.step_factor), 1e2 * trial.frames.back().sunk_m});
      deepest_cm = std::max(deepest_cm, curve.points.back()[1]);
    }
  });
  plot.x = factor_axis();
  plot.y = {"centre of mass, cm below the start", 0.0, 1.1 * deepest_cm};
  return {std::move(plot), {'e', "how far it sinks into folds", "the same runs at their end; near 0 it is locked"}};
}

void draw_methods(renderer::Canvas& canvas, const Area& area, const PlotSheet& sheet) {
  const float row_px = area.height_px / static_cast<float>(trial_methods.size());
  float top_px = area.y_px + 0.6F * sheet.plot.text_px;
  for (const sim::SolverKind kind : trial_methods) {
    Curve entry = make_curve(kind, true);
    entry.name = solver_look(kind).name;
    draw_legend_entry(canvas, entry, area.x_px + 60.0F, top_px + 0.5F * sheet.plot.text_px, sheet.plot);
    canvas.text(area.x_px + 60.0F + 3.1F * sheet.plot.text_px, top_px + 2.1F * sheet.plot.text_px,
                solver_look(kind).setting, text_style(sheet.caption.measured_px, palette::quiet_ink));
    top_px += row_px;
  }
  canvas.text(area.x_px + 60.0F, top_px + 1.2F * sheet.plot.text_px,
              fmt::format("no contact, one thread; asked for {:g} % where possible", 100.0 * trial_max_stretch),
              text_style(sheet.caption.measured_px));
}

constexpr const char* columns =
    "test,triangles,method,step_factor,substeps,time_s,frame_ms,max_stretch,max_surface_stretch,energy_j,"
    "rms_speed_m_per_s,sunk_m";

/// Returns the value whose name is in a cell.
template <class Values>
auto find_named(const CsvFile& table, std::size_t row, std::size_t column, const Values& values) {
  std::vector<std::string> names;
  for (const auto value : values) {
    if (table.text(row, column) == to_name(value)) return value;
    names.emplace_back(to_name(value));
  }
  table.fail_cell(row, column, "one of " + join(names));
}

/// Adds a row to its trial, which is the last one or a new one.
void read_row(const CsvFile& table, std::size_t row, ClaimResults& results) {
  MethodTrial next = {find_named(table, row, 0, all_method_tests),
                      find_named(table, row, 2, trial_methods),
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

// Figure 8: cost and effect of the methods of sections I and III, on the same meshes.
Drawing draw_figure8(const ClaimResults& results, LazyOffscreenRenderer&) {
  PlotSheet sheet;
  sheet.plot = {.text_px = 38.0F, .marker_px = 13.0F};
  sheet.row_gap_px = 30.0F;
  const MethodTrials& steps = results.trials_of(MethodTest::steps);
  std::vector<PlotPanel> panels = {
      time_panel(results.trials_of(MethodTest::time)), energy_panel(results.trials_of(MethodTest::energy)),
      rest_panel(results.trials_of(MethodTest::rest)), steps_panel(steps), sunk_panel(steps)};
  for (PlotPanel& panel : panels) panel.plot.legend = LegendCorner::none;
  const Area free = plot_area(sheet, panels.size());
  Drawing drawing = draw_plot_sheet(std::move(panels), sheet);
  drawing.draw = [=, draw_plots = drawing.draw](renderer::Canvas& canvas) {
    draw_plots(canvas);
    draw_methods(canvas, free, sheet);
  };
  return drawing;
}

}  // namespace

std::string figure8_csv(const ClaimResults& results) {
  CsvTable table(columns);
  for (const MethodTest test : all_method_tests) {
    for (const MethodTrial& trial : results.trials_of(test)) {
      const auto add = [&](const TrialFrame& frame) {
        table.add(to_name(test), trial.triangles, to_name(trial.kind), trial.step_factor, trial.substeps, frame.time_s,
                  frame.frame_ms, frame.stretch, frame.surface_stretch, frame.energy_j, frame.speed_m_per_s,
                  frame.sunk_m);
      };
      std::ranges::for_each(trial.frames, add);
      if (trial.is_lost) {
        // The frame in which the trial diverged has no values.
        add({NAN, NAN, NAN, NAN, NAN, NAN, NAN});
      }
    }
  }
  return table.text();
}

void read_figure8(ClaimResults& results, const std::filesystem::path& folder) {
  const CsvFile table(folder / "fig8.csv", columns);
  for (std::size_t row = 0; row < table.rows(); ++row) read_row(table, row, results);
  for (const MethodTest test : all_method_tests) {
    const std::size_t found = results.trials_of(test).size(), expected = trials_in(test);
    if (found != expected) {
      throw InputError("{}: found {} trials of the test {}, expected {}", (folder / "fig8.csv").string(), found,
                       to_name(test), expected);
    }
  }
}

Figure make_figure8(ClaimResults& results) {
  const auto time = [&results](const ProgressCallback& report) {
    results.trials_of(MethodTest::time) = make_trials(MethodTest::time, report);
  };
  const auto of = [&results](auto function) { return std::bind_front(function, std::ref(results)); };
  return {"fig8",
          "The field in one figure: the methods the paper argues with, on the same shirts",
          {to_name(MethodTest::energy), to_name(MethodTest::rest), to_name(MethodTest::steps)},
          of(draw_figure8),
          of(figure8_csv),
          nullptr,
          time};
}

}  // namespace taut::app
