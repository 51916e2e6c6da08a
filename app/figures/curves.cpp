#include "app/base/words.hpp"
#include "app/drawing/plots/plot.hpp"
#include "app/figures/figures.hpp"
#include "app/runs/csv.hpp"

namespace taut::app {
namespace {

Plot convergence_plot(const StepRecording& fall) {
  Curve curve;
  curve.stroke = {palette::blue, 4.0F, {}};
  for (std::size_t i = 0; i < fall.moved_m.size(); ++i) {
    curve.points.push_back({static_cast<double>(i + 1), fall.moved_m[i]});
  }
  return {.x = {"iteration (time step)", 0.0, static_cast<double>(fall.moved_m.size())},
          .y = decades_around("|p(t) − p(t − Δt)|  in metres", fall.moved_m),
          .curves = {std::move(curve)},
          .legend = LegendCorner::none};
}

// Returns the plot with linear axes, as in the paper.
Plot linear_inset(const Plot& plot, const StepRecording& fall) {
  Plot inset = plot;
  const double largest_mm = 1e3 * *std::ranges::max_element(fall.moved_m);
  inset.x.label = "iteration";
  inset.x.chosen = {0.0, 5000.0, 10000.0, 15000.0};
  std::erase_if(inset.x.chosen, [&](double value) { return value > inset.x.maximum; });
  inset.y = {"the same in mm, linear", 0.0, 1.05 * largest_mm};
  for (DataPoint& point : inset.curves.front().points) point[1] *= 1e3;
  inset.curves.front().stroke.thickness_px = 2.5F;
  return inset;
}

// Draws the cloth as modelled, from above, and the followed vertex.
void draw_followed_point(renderer::Canvas& canvas, const StepRecording& fall, const Area& area) {
  const sim::GridSettings& grid = fall.frames.scene.garment.grid;
  const float side_px = area.width_px;
  for (sim::Index i = 0; i < grid.columns; ++i) {
    const float x_px = area.x_px + side_px * static_cast<float>(i) / static_cast<float>(grid.columns - 1);
    canvas.line(x_px, area.y_px, x_px, area.y_px + side_px, palette::quiet_ink, 1.0F);
  }
  for (sim::Index i = 0; i < grid.rows; ++i) {
    const float y_px = area.y_px + side_px * static_cast<float>(i) / static_cast<float>(grid.rows - 1);
    canvas.line(area.x_px, y_px, area.x_px + side_px, y_px, palette::quiet_ink, 1.0F);
  }
  const auto place = [&](sim::Index vertex) {
    return glm::vec2(
        area.x_px + side_px * static_cast<float>(vertex % grid.columns) / static_cast<float>(grid.columns - 1),
        area.y_px + side_px * static_cast<float>(vertex / grid.columns) / static_cast<float>(grid.rows - 1));
  };
  for (const sim::Index pin : fall.frames.pins) {
    canvas.fill_rectangle(place(pin).x - 12.0F, place(pin).y - 12.0F, 24.0F, 24.0F, palette::ink);
  }
  const glm::vec2 followed = place(fall.vertex);
  canvas.circle(followed.x, followed.y, 20.0F, renderer::Colour{1.0F});
  canvas.circle(followed.x, followed.y, 16.0F, palette::blue);
  const renderer::TextStyle text =
      text_style(34.0F, palette::quiet_ink).with_alignment(renderer::HorizontalAlign::centre);
  const float centre_px = area.x_px + 0.5F * side_px;
  canvas.text(centre_px, area.y_px - 32.0F, "held corners: squares", text);
  canvas.text(centre_px, area.y_px + side_px + 62.0F, "followed point", text);
}

std::string rest_text(const StepRecording& fall) {
  const auto steps = static_cast<double>(fall.moved_m.size());
  return fmt::format("steps of 1/{:.0f} s; {} after {:.0f} of them, or {:.1f} s", 1.0 / fall.time_step_s,
                     fall.came_to_rest
                         ? fmt::format("at rest (within {:g} mm for {:g} s)", 1e3 * fall_rest_m, fall_rest_s)
                         : "not yet at rest",
                     steps, steps * fall.time_step_s);
}

constexpr double frame_at_60_hz_ms = 1000.0 / 60.0;

std::string describe_settings(int substeps, int sweeps) {
  return fmt::format("{} step{} a frame, {} sweep{} each", substeps, substeps == 1 ? "" : "s", sweeps,
                     sweeps == 1 ? "" : "s");
}

Curve measured_curve(const std::vector<FrameTimes>& times, int substeps, const Stroke& stroke, Marker marker) {
  Curve curve;
  curve.stroke = stroke;
  curve.stroke.thickness_px = 0.0F;
  curve.marker = marker;
  for (const FrameTimes& time : times) {
    if (time.substeps == substeps) {
      curve.points.push_back({static_cast<double>(time.triangles), time.median_ms()});
      curve.bars.push_back({time.min_ms(), time.max_ms()});
    }
  }
  return curve;
}

Curve fitted_curve(const PowerLaw& law, const Axis& x, const Stroke& stroke) {
  Curve curve;
  curve.stroke = stroke;
  for (const double triangles : {x.minimum, x.maximum}) {
    curve.points.push_back({triangles, law.factor * std::pow(triangles, law.exponent)});
  }
  return curve;
}

Plot frame_time_plot(const std::vector<FrameTimes>& times) {
  Plot plot;
  plot.x = {"triangles of the model", 700.0, 15000.0, true, "", {1028.0, 5280.0, 10600.0}};
  std::vector<double> all_ms = {frame_at_60_hz_ms};
  for (const FrameTimes& time : times) all_ms.insert(all_ms.end(), time.frame_ms.begin(), time.frame_ms.end());
  plot.y = decades_around("time for one frame in ms", all_ms);
  const std::array strokes = {Stroke{palette::blue, 4.0F, {}}, Stroke{palette::vermilion, 4.0F, {4.0F, 2.5F}}};
  const std::array markers = {Marker::disc, Marker::square};
  std::vector<int> done;
  for (const FrameTimes& time : times) {
    if (std::ranges::find(done, time.substeps) != done.end()) continue;
    const std::size_t look = std::min<std::size_t>(done.size(), strokes.size() - 1);
    const PowerLaw law = fit_power_law(times, time.substeps);
    plot.curves.push_back(fitted_curve(law, plot.x, strokes[look]));
    plot.curves.push_back(measured_curve(times, time.substeps, strokes[look], markers[look]));
    plot.curves[plot.curves.size() - 2].name = fmt::format("{}: grows as triangles to the power {:.2f}",
                                                           describe_settings(time.substeps, time.sweeps), law.exponent);
    done.push_back(time.substeps);
  }
  plot.levels = {{frame_at_60_hz_ms, "60 frames a second: 16.7 ms"}};
  plot.legend = LegendCorner::lower_right;
  return plot;
}

std::string describe_medians(const std::vector<FrameTimes>& times) {
  return join(collect<std::string>(times,
                                   [](const FrameTimes& time) {
                                     return fmt::format("{:.{}f}", time.median_ms(), time.median_ms() < 10.0 ? 1 : 0);
                                   })) +
         " ms";
}

// Returns the stroke of one of compared_methods.
Stroke solver_stroke(sim::SolverKind kind) {
  const std::array<Stroke, 3> strokes = {
      {{palette::orange, 4.0F, {1.2F, 1.8F}}, {palette::vermilion, 4.0F, {5.0F, 2.0F}}, {palette::blue, 4.5F, {}}}};
  return strokes.at(static_cast<std::size_t>(kind));
}

std::string legend_name(const MethodRun& run) {
  constexpr std::array names = {"ideal springs", "threshold of 5 %", "strong constraint"};
  std::string name = names[static_cast<std::size_t>(run.kind)];
  if (run.diverged_at_s) name += fmt::format(" (diverge after {:.2f} s)", *run.diverged_at_s);
  return name;
}

Curve make_curve(const MethodRun& run, const std::vector<double>& values, double factor) {
  Curve curve;
  curve.name = legend_name(run);
  curve.stroke = solver_stroke(run.kind);
  // Single values of a vibration cannot be distinguished, so the line shows the largest value of every 1/64 s.
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
  Plot plot{.x = {"time in s", 0.0, 10.0},
            .y = {"largest stretch", 0.0, 20.0, false, " %"},
            .curves = {},
            .levels = {{5.0, ""}}};
  for (const MethodRun& run : runs) plot.curves.push_back(make_curve(run, run.max_stretch, 100.0));
  return plot;
}

Plot unrest_plot(const std::vector<MethodRun>& runs) {
  Plot plot{.x = {"time in s", 0.0, 10.0},
            .y = {"RMS of |p(t) − p(t − Δt)|  in metres", 1e-18, 1.0, true},
            .curves = {},
            .legend = LegendCorner::none};
  for (const MethodRun& run : runs) plot.curves.push_back(make_curve(run, run.moved_rms_m, 1.0));
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

}  // namespace

std::string figure3_csv(const Results& results) {
  const StepRecording& fall = *results.fall;
  CsvTable table(figure3_columns);
  for (std::size_t i = 0; i < fall.moved_m.size(); ++i) {
    table.add(i + 1, static_cast<double>(i + 1) * fall.time_step_s, fall.moved_m[i]);
  }
  return table.text();
}

// Figure 3: iterative convergence of a single mass point of the cloth of figure 2.
Drawing draw_figure3(const Results& results, LazyOffscreenRenderer&) {
  const StepRecording fall = *results.fall;
  const CaptionStyle style;
  const Plot plot = convergence_plot(fall);
  const Plot inset = linear_inset(plot, fall);
  Drawing drawing{2400, 1240 + static_cast<int>(style.height_px()), {}};
  drawing.draw = [=](renderer::Canvas& canvas) {
    draw_plot(canvas, plot, {20.0F, 10.0F, 1640.0F, 1230.0F});
    draw_plot(canvas, inset, {1740.0F, 10.0F, 640.0F, 620.0F}, {.line_px = 2.0F});
    draw_followed_point(canvas, fall, {1920.0F, 760.0F, 340.0F, 340.0F});
    draw_caption(canvas, {'\0', "convergence of one mass point of the cloth of figure 2", rest_text(fall)}, 1200.0F,
                 1240.0F, style);
  };
  return drawing;
}

std::string figure6_csv(const Results& results) {
  CsvTable table(figure6_columns);
  for (const FrameTimes& time : results.frame_times) {
    for (std::size_t repeat = 0; repeat < time.frame_ms.size(); ++repeat) {
      table.add(time.triangles, time.substeps, time.sweeps, repeat + 1, time.frame_ms[repeat]);
    }
  }
  return table.text();
}

// Figure 6 (section IV): time per frame for models of different precision.
Drawing draw_figure6(const Results& results, LazyOffscreenRenderer&) {
  const std::vector<FrameTimes> times = results.frame_times;
  const Plot plot = frame_time_plot(times);
  const CaptionStyle style;
  Drawing drawing{2400, 1300 + static_cast<int>(style.height_px()), {}};
  drawing.draw = [=](renderer::Canvas& canvas) {
    draw_plot(canvas, plot, {40.0F, 20.0F, 2300.0F, 1270.0F}, {.text_px = 38.0F, .marker_px = 15.0F});
    draw_caption(
        canvas,
        {'\0',
         fmt::format("one frame of 1/60 s with the strong constraint, one thread: medians of {}, bars from "
                     "shortest to longest",
                     times.front().frame_ms.size()),
         "gravity alone, no contact; lines are fitted to the shortest times; medians " + describe_medians(times)},
        1200.0F, 1300.0F, style);
  };
  return drawing;
}

std::string figure7_csv(const Results& results) {
  CsvTable table(figure7_columns);
  for (const MethodRun& run : results.methods) {
    for (std::size_t i = 0; i < run.max_stretch.size(); ++i) {
      table.add(to_name(run.kind), run.time_step_s, static_cast<double>(i + 1) * run.time_step_s, run.max_stretch[i],
                run.moved_rms_m[i]);
    }
  }
  return table.text();
}

// Figure 7 (section III): vibration of springs that are pulled back to a threshold, compared with the strong
// constraint.
Drawing draw_figure7(const Results& results, LazyOffscreenRenderer&) {
  std::vector<PlotPanel> stretch, unrest;
  for (std::size_t rate = 0; rate < method_rates_hz.size(); ++rate) {
    const std::vector<MethodRun> runs = runs_with(results, rate);
    const std::string step = fmt::format("steps of 1/{:.0f} s", method_rates_hz[rate]);
    const char letter = rate == 0 ? 'a' : 'b';
    stretch.push_back({stretch_plot(runs), {letter, "stretch, " + step, ""}});
    unrest.push_back(
        {unrest_plot(runs), {static_cast<char>(letter + 2), "movement in a step, " + step, unrest_text(runs)}});
  }
  stretch.insert(stretch.end(), unrest.begin(), unrest.end());
  return draw_plot_sheet(std::move(stretch), {});
}

}  // namespace taut::app
