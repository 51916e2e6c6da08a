#include <ranges>

#include "app/drawing/plots/plot.hpp"
#include "tests/study/claims/csv_file.hpp"
#include "tests/study/claims/truth.hpp"

namespace taut::app {
namespace {

constexpr const char* truth_columns = "experiment,curve,mesh,x,measured,published,published_to";

std::vector<TruthPoint> select_points(const TruthExperiment& experiment, std::span<const TruthPoint> points) {
  std::vector<TruthPoint> some;
  std::ranges::copy_if(points, std::back_inserter(some),
                       [&](const TruthPoint& point) { return point.experiment == experiment.name; });
  return some;
}

/// Returns the names in order, without repeats.
template <class Member> std::vector<std::string> names_in(std::span<const TruthPoint> points, Member member) {
  std::vector<std::string> names;
  for (const TruthPoint& point : points) {
    if (std::ranges::find(names, point.*member) == names.end()) names.push_back(point.*member);
  }
  return names;
}

const renderer::Colour& curve_colour(std::size_t curve) {
  static const std::array colours = {palette::blue,   palette::vermilion, palette::green,
                                     palette::purple, palette::orange,    palette::sky};
  return colours[curve % colours.size()];
}

/// One marker for each of the three meshes, the coarsest first.
constexpr std::array markers = {Marker::ring, Marker::square, Marker::disc};

/// Returns the published numbers of a curve as a line, or as the outline of its ranges.
Curve make_line(const std::string& name, std::size_t number, std::span<const TruthPoint> points) {
  Curve curve = {name, {}, {curve_colour(number), 3.5F, {}}};
  std::map<double, std::array<double, 2>> ranges;
  bool is_range = false;
  for (const TruthPoint& point : points) {
    if (point.curve != name || !std::isfinite(point.published)) continue;
    const double upper = std::isfinite(point.published_to) ? point.published_to : point.published;
    auto& [lowest, highest] = ranges.try_emplace(point.x, std::array{point.published, upper}).first->second;
    lowest = std::min(lowest, point.published);
    highest = std::max(highest, upper);
    is_range = is_range || upper > point.published;
  }
  for (const auto& [x, range] : ranges) curve.points.push_back({x, range[0]});
  if (!is_range) return curve;
  for (const auto& [x, range] : ranges | std::views::reverse) curve.points.push_back({x, range[1]});
  curve.points.push_back(curve.points.front());
  return curve;
}

Axis axis_around(const std::string& label, bool is_logarithmic, const std::vector<double>& values,
                 bool is_legend_below = false) {
  const auto [lowest, highest] = std::ranges::minmax(values);
  if (is_logarithmic) return {label, (is_legend_below ? 0.15 : 0.7) * lowest, 1.5 * highest, true};
  const double room = 0.06 * std::max(highest - lowest, 1e-9);
  return {label, lowest < 0.0 ? lowest - room : 0.0, highest + room};
}

std::string number_text(const TruthExperiment& experiment, double deviation) {
  return experiment.measure == Measure::part
             ? fmt::format("{:.1f} %", 100.0 * deviation)
             : fmt::format("{:.2g}{}", deviation, experiment.y_label.ends_with(" in %") ? " points of %" : "");
}

PlotPanel make_panel(const TruthExperiment& experiment, char letter, std::span<const TruthPoint> all) {
  const std::vector<TruthPoint> points = select_points(experiment, all);
  Plot plot;
  std::vector<double> xs, ys;
  const std::vector<std::string> curves = names_in(points, &TruthPoint::curve);
  const std::vector<std::string> meshes = names_in(points, &TruthPoint::mesh);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    plot.curves.push_back(make_line(curves[c], c, points));
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      Curve measured = {"", {}, {curve_colour(c), 0.0F, {}}, markers[m % markers.size()]};
      for (const TruthPoint& point : points) {
        if (point.curve != curves[c] || point.mesh != meshes[m]) continue;
        measured.points.push_back({point.x, point.measured});
        xs.push_back(point.x);
        ys.push_back(point.measured);
        for (const double published : {point.published, point.published_to}) {
          if (std::isfinite(published)) ys.push_back(published);
        }
      }
      plot.curves.push_back(std::move(measured));
    }
  }
  plot.x = axis_around(experiment.x_label, experiment.is_x_logarithmic, xs);
  plot.y =
      axis_around(experiment.y_label, experiment.is_y_logarithmic, ys, experiment.legend == LegendCorner::lower_right);
  plot.legend = experiment.legend;
  const Deviation deviation = compute_deviation(experiment, points);
  return {std::move(plot),
          {letter, experiment.title,
           fmt::format("{}; off by at most {}", experiment.source, number_text(experiment, deviation.largest()))}};
}

Drawing draw_experiments(std::span<const TruthExperiment> experiments, const std::vector<TruthPoint>& points) {
  PlotSheet sheet;
  sheet.plot = {.text_px = 34.0F, .marker_px = 9.0F};
  sheet.row_gap_px = 30.0F;
  sheet.caption.measured_px = 30.0F;
  std::vector<PlotPanel> panels;
  for (const TruthExperiment& experiment : experiments) {
    panels.push_back(make_panel(experiment, static_cast<char>('a' + panels.size()), points));
  }
  return draw_plot_sheet(std::move(panels), sheet);
}

std::string experiments_csv(std::span<const TruthExperiment> experiments, std::span<const TruthPoint> points) {
  CsvTable table(truth_columns);
  for (const TruthExperiment& experiment : experiments) {
    for (const TruthPoint& p : select_points(experiment, points)) {
      table.add(p.experiment, p.curve, p.mesh, p.x, p.measured, p.published, p.published_to);
    }
  }
  return table.text();
}

Job make_job(std::string name, double seconds, std::vector<TruthExperiment> experiments,
             std::vector<TruthPoint>& points) {
  const auto run = [experiments = std::move(experiments), &points](const ProgressCallback& report) {
    for (std::size_t i = 0; i < experiments.size(); ++i) {
      const ProgressCallback part = report_part(report, i, experiments.size());
      std::ranges::move(run_experiment(experiments[i], 1.0, part), std::back_inserter(points));
    }
  };
  return {std::move(name), seconds, run};
}

Figure make_figure(std::string name, std::string title, std::string job, std::vector<TruthExperiment> experiments,
                   std::vector<TruthPoint>& points) {
  return {std::move(name),
          std::move(title),
          {std::move(job)},
          [experiments, &points](LazyOffscreenRenderer&) { return draw_experiments(experiments, points); },
          [experiments, &points] { return experiments_csv(experiments, points); }};
}

}  // namespace

void read_truth(std::vector<TruthPoint>& points, const std::filesystem::path& file) {
  const CsvFile table(file, truth_columns);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto published = [&](std::size_t column) {
      return table.text(row, column).empty() ? NAN : table.number(row, column);
    };
    points.push_back({table.text(row, 1), table.number(row, 3), table.number(row, 4), published(5), published(6),
                      table.text(row, 2), table.text(row, 0)});
  }
}

std::vector<TruthPoint> run_experiment(const TruthExperiment& experiment, double physics,
                                       const ProgressCallback& report) {
  std::vector<TruthPoint> points = experiment.run(physics, report);
  for (TruthPoint& point : points) point.experiment = experiment.name;
  return points;
}

Deviation compute_deviation(const TruthExperiment& experiment, std::span<const TruthPoint> points) {
  Deviation deviation;
  double squares = 0.0;
  for (const TruthPoint& point : points) {
    if (point.experiment != experiment.name || !std::isfinite(point.published)) continue;
    double off = point.measured - point.published;
    if (std::isfinite(point.published_to)) off -= std::clamp(off, 0.0, point.published_to - point.published);
    if (experiment.measure == Measure::part) off /= point.published;
    if (experiment.measure == Measure::excess) off = std::max(off, 0.0);
    if (!std::isfinite(off)) off = INFINITY;
    if (std::abs(off) > deviation.largest()) deviation.worst = off;
    squares += off * off;
    ++deviation.points;
  }
  deviation.rms = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(deviation.points, 1)));
  return deviation;
}

std::vector<Job> truth_jobs(std::vector<TruthPoint>& points) {
  return {make_job("truth", 25.0, calm_experiments(), points), make_job("wind", 110.0, wind_experiments(), points)};
}

Figure truth_figure(std::vector<TruthPoint>& points) {
  return make_figure("truth", "Experiments that others published, and closed forms, each on three meshes", "truth",
                     calm_experiments(), points);
}

Figure make_figure9(std::vector<TruthPoint>& points) {
  return make_figure("fig9", "Cloth in wind, published and simulated, each experiment on three meshes", "wind",
                     wind_experiments(), points);
}

std::string truth_html(std::span<const TruthExperiment> experiments, std::span<const TruthPoint> points) {
  std::string html =
      "<table>\n<tr><th>experiment</th><th>published</th><th>numbers</th><th>largest deviation</th><th>root mean "
      "square</th><th>passes up to</th><th></th></tr>\n";
  for (const TruthExperiment& experiment : experiments) {
    const Deviation deviation = compute_deviation(experiment, points);
    const bool passes = deviation.largest() <= experiment.tolerance;
    html += fmt::format(
        "<tr class=\"{}\"><td>{}</td><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td "
        "class=\"number\">{}</td><td class=\"number\">{}</td><td>{}</td></tr>\n",
        passes ? "holds" : "fails", experiment.title, experiment.source, deviation.points,
        number_text(experiment, deviation.largest()), number_text(experiment, deviation.rms),
        number_text(experiment, experiment.tolerance),
        passes                    ? "<b>passes</b>"
        : experiment.known != 0.0 ? "<b>does not pass</b>, a known flaw"
                                  : "<b>does not pass</b>");
  }
  return html + "</table>\n";
}

}  // namespace taut::app
