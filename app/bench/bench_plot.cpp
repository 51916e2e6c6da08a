#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/bench/bench_output.hpp"
#include "app/drawing/plots/plot_sheet.hpp"

namespace taut::app {
namespace {

// The size of garment that the plot of time against stretch shows, if it was measured.
constexpr double usual_triangles = 10600.0;

struct Look {
  Stroke stroke;
  Marker marker;
};

Look look_of(const std::string& engine) {
  if (engine == "bounded") {
    return {{palette::blue, 4.5F, {}}, Marker::disc};
  }
  if (engine == "bullet") {
    return {{palette::vermilion, 4.0F, {4.0F, 2.5F}}, Marker::square};
  }
  return {{palette::quiet_ink, 3.5F, {1.5F, 2.5F}}, Marker::disc};
}

// Of the runs that reached their end: median ms against stretch in percent, in the worst of all frames.
std::vector<DataPoint> points_of(const Heat& heat, const std::string& engine, StretchMeasure measure) {
  std::vector<DataPoint> points;
  for (const Run& run : heat.runs) {
    if (run.entrant.engine == engine && run.end == RunEnd::finished && !run.frames.empty()) {
      const RunFacts facts = facts_of(run);
      points.push_back({facts.median_ms, 100.0 * stretch_by(measure, facts)});
    }
  }
  return points;
}

// The 99th percentile thinner, its markers hollow.
Curve front_curve(const std::string& engine, const std::vector<DataPoint>& points, StretchMeasure measure) {
  Look look = look_of(engine);
  if (measure == StretchMeasure::p99) {
    look.stroke.thickness_px *= 0.5F;
    look.marker = Marker::ring;
  }
  Curve curve{fmt::format("{}, {}", title_of_engine(engine), name_of(measure)), {}, look.stroke, look.marker};
  for (const std::size_t i : pareto_front(points)) {
    curve.points.push_back(points[i]);
  }
  return curve;
}

Plot stretch_plot(const BenchResults& results, const Heat& heat) {
  Plot plot;
  std::vector<double> times_ms, stretches;
  for (const std::string& engine : engines_in(results)) {
    for (const StretchMeasure measure : stretch_measures) {
      const std::vector<DataPoint> points = points_of(heat, engine, measure);
      for (const auto& [ms, stretch] : points) {
        times_ms.push_back(ms);
        stretches.push_back(stretch);
      }
      if (!points.empty()) {
        plot.curves.push_back(front_curve(engine, points, measure));
      }
    }
  }
  for (const double bound : results.bounds) {
    stretches.push_back(100.0 * bound);
    plot.levels.push_back({100.0 * bound, percent(bound)});
  }
  plot.x = decades_around("processor time for one frame in ms", times_ms);
  const double least = *std::min_element(stretches.begin(), stretches.end());
  // Room for the legend above everything.
  stretches.push_back(200.0 * *std::max_element(stretches.begin(), stretches.end()));
  plot.y = decades_around("stretch in the worst of all frames", stretches);
  plot.y.suffix = " %";
  // Markers at a bound stand free of the frame.
  plot.y.minimum = 0.5 * least;
  return plot;
}

Curve growth_curve(const BenchResults& results, const std::string& scene, const std::string& engine,
                   double bound) {
  const Look look = look_of(engine);
  Curve curve{fmt::format("{}, {}", title_of_engine(engine), percent(bound)), {}, look.stroke, look.marker};
  for (const Heat& heat : results.heats) {
    const Run* best = heat.scene.name == scene ? best_run(heat, engine, bound) : nullptr;
    if (best != nullptr) {
      curve.points.push_back({static_cast<double>(heat.size.triangles), facts_of(*best).median_ms});
    }
  }
  if (const auto growth = growth_of(results, scene, engine, bound)) {
    curve.name += fmt::format(": triangles to the power {:.2f}", growth->exponent);
  }
  return curve;
}

// At the loosest bound, the only one that every engine may keep.
Plot growth_plot(const BenchResults& results, const std::string& scene) {
  Plot plot;
  std::vector<double> times_ms;
  for (const std::string& engine : engines_in(results)) {
    Curve curve = growth_curve(results, scene, engine, results.bounds.front());
    for (const auto& [triangles, ms] : curve.points) {
      times_ms.push_back(ms);
    }
    if (!curve.points.empty()) {
      plot.curves.push_back(std::move(curve));
    }
  }
  std::vector<double> sizes;
  for (const Heat& heat : results.heats) {
    if (heat.scene.name == scene) {
      sizes.push_back(heat.size.triangles);
    }
  }
  const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
  plot.x = {"triangles", *least / 1.4, *most * 1.4, true, "", sizes};
  if (!times_ms.empty()) {
    // Room for the legend above the slowest.
    times_ms.push_back(8.0 * *std::max_element(times_ms.begin(), times_ms.end()));
  }
  plot.y = decades_around("processor time for one frame in ms", times_ms);
  plot.legend = LegendCorner::upper_left;
  return plot;
}

const Heat* heat_at_usual_size(const BenchResults& results, const std::string& scene) {
  const Heat* nearest = nullptr;
  const auto distance = [](const Heat& heat) { return std::abs(heat.size.triangles - usual_triangles); };
  for (const Heat& heat : results.heats) {
    if (heat.scene.name == scene && (nearest == nullptr || distance(heat) < distance(*nearest))) {
      nearest = &heat;
    }
  }
  return nearest;
}

std::vector<PlotPanel> panels_of(const BenchResults& results) {
  std::vector<PlotPanel> panels;
  for (const std::string& scene : bench_scene_names()) {
    if (const Heat* heat = heat_at_usual_size(results, scene)) {
      panels.push_back({stretch_plot(results, *heat),
                        {'a', fmt::format("{}, {} triangles", scene, heat->size.triangles),
                         "marked: settings that no other of the engine beats in both"}});
    }
  }
  if (results.heats.empty()) {
    return panels;
  }
  const std::string scene = results.heats.front().scene.name;
  const auto same_scene = [&](const Heat& heat) { return heat.scene.name == scene; };
  if (std::count_if(results.heats.begin(), results.heats.end(), same_scene) > 1) {
    panels.push_back(
        {growth_plot(results, scene),
         {'a',
          fmt::format("{}: the fastest whose worst edge keeps {}", scene, percent(results.bounds.front())),
          "at every size the best setting of each engine"}});
  }
  for (std::size_t i = 0; i < panels.size(); ++i) {
    panels[i].caption.letter = panels.size() == 1 ? '\0' : static_cast<char>('a' + i);
  }
  return panels;
}

}  // namespace

std::vector<Plot> bench_plots(const BenchResults& results) {
  std::vector<Plot> plots;
  for (const PlotPanel& panel : panels_of(results)) {
    plots.push_back(panel.plot);
  }
  return plots;
}

Drawing draw_bench(const BenchResults& results) {
  std::vector<PlotPanel> panels = panels_of(results);
  PlotSheet sheet;
  sheet.columns = std::clamp<std::size_t>(panels.size(), 1, 2);
  sheet.left_px = sheet.right_px = sheet.gap_px = sheet.row_gap_px = 60.0F;
  sheet.top_px = 30.0F;
  sheet.width_px = 1300.0F;
  sheet.height_px = 1000.0F;
  sheet.caption = {};
  sheet.plot.marker_px = 12.0F;
  return draw_plot_sheet(std::move(panels), sheet);
}

}  // namespace taut::app
