#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/drawing/plots/plot.hpp"
#include "app/figures/csv.hpp"
#include "app/figures/figures.hpp"

namespace taut::app {
namespace {

const std::vector<std::string> columns = {"triangles", "substeps", "sweeps", "repeat", "frame_ms"};

constexpr double frame_at_60_hz_ms = 1000.0 / 60.0;

std::string settings_of(int substeps, int sweeps) {
  return fmt::format("{} step{} a frame, {} sweep{} each", substeps, substeps == 1 ? "" : "s", sweeps,
                     sweeps == 1 ? "" : "s");
}

Curve measured_curve(const std::vector<FrameTimes>& times, int substeps, const Stroke& stroke,
                     Marker marker) {
  Curve curve;
  curve.stroke = stroke;
  curve.stroke.thickness_px = 0.0F;
  curve.marker = marker;
  for (const FrameTimes& time : times) {
    if (time.substeps == substeps) {
      curve.points.push_back({static_cast<double>(time.triangles), time.median_ms()});
      curve.bars.push_back({time.shortest_ms(), time.longest_ms()});
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
  for (const FrameTimes& time : times) {
    all_ms.insert(all_ms.end(), time.frame_ms.begin(), time.frame_ms.end());
  }
  plot.y = decades_around("time for one frame in ms", all_ms);
  const std::array strokes = {Stroke{palette::blue, 4.0F, {}},
                              Stroke{palette::vermilion, 4.0F, {4.0F, 2.5F}}};
  const std::array markers = {Marker::disc, Marker::square};
  std::vector<int> done;
  for (const FrameTimes& time : times) {
    if (std::find(done.begin(), done.end(), time.substeps) != done.end()) {
      continue;
    }
    const std::size_t look = std::min<std::size_t>(done.size(), strokes.size() - 1);
    const PowerLaw law = fit_power_law(times, time.substeps);
    plot.curves.push_back(fitted_curve(law, plot.x, strokes[look]));
    plot.curves.push_back(measured_curve(times, time.substeps, strokes[look], markers[look]));
    plot.curves[plot.curves.size() - 2].name = fmt::format(
        "{}: grows as triangles to the power {:.2f}", settings_of(time.substeps, time.sweeps), law.exponent);
    done.push_back(time.substeps);
  }
  plot.levels = {{frame_at_60_hz_ms, "60 frames a second: 16.7 ms"}};
  plot.legend = LegendCorner::lower_right;
  return plot;
}

std::string medians_of(const std::vector<FrameTimes>& times) {
  std::string text;
  for (const FrameTimes& time : times) {
    text +=
        fmt::format("{}{:.{}f}", text.empty() ? "" : ", ", time.median_ms(), time.median_ms() < 10.0 ? 1 : 0);
  }
  return text + " ms";
}

}  // namespace

std::string figure6_csv(const Results& results) {
  CsvTable table(columns);
  for (const FrameTimes& time : results.frame_times) {
    for (std::size_t repeat = 0; repeat < time.frame_ms.size(); ++repeat) {
      table.add({std::to_string(time.triangles), std::to_string(time.substeps), std::to_string(time.sweeps),
                 std::to_string(repeat + 1), cell(time.frame_ms[repeat])});
    }
  }
  return table.text();
}

void read_figure6(const std::filesystem::path& folder, Results& results) {
  const CsvFile table(folder / "fig6.csv", columns);
  std::vector<FrameTimes>& times = results.frame_times;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const FrameTimes next{
        table.whole_number(row, 0), table.whole_number(row, 1), table.whole_number(row, 2), {}};
    if (times.empty() || times.back().triangles != next.triangles || times.back().substeps != next.substeps) {
      times.push_back(next);
    }
    const double frame_ms = table.number(row, 4);
    if (frame_ms <= 0.0 || next.triangles <= 0) {
      table.fail(row, "found a time or a number of triangles of 0 or less, expected more");
    }
    times.back().frame_ms.push_back(frame_ms);
  }
}

// Section IV: what a frame costs for models of different precision.
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
         "gravity alone, no contact; lines are fitted to the shortest times; medians " + medians_of(times)},
        1200.0F, 1300.0F, style);
  };
  return drawing;
}

}  // namespace taut::app
