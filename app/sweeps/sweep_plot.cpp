#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "app/base/errors.hpp"
#include "app/base/suggest.hpp"
#include "app/drawing/drawn_scene_file.hpp"
#include "app/drawing/plots/plot.hpp"
#include "app/scene/scene_format.hpp"
#include "app/sweeps/sweep_results.hpp"
#include "app/sweeps/sweep_table.hpp"

namespace taut::app {
namespace {

constexpr std::size_t most_columns = 4;

/// What was measured where: of one column of plots, one curve, one x.
struct Place {
  std::size_t column;
  std::size_t curve;
  std::size_t x;
  auto operator<=>(const Place&) const = default;
};

struct Found {
  std::vector<double> values;
  bool is_broken = false;
};

struct Columns {
  std::vector<std::string> titles;
  std::map<std::vector<std::size_t>, std::size_t> of_choice;  ///< of the other axes
};

struct AxesOfPlot {
  std::size_t x;
  std::size_t curves;  ///< as many as there are axes: one curve
};

std::size_t axis_named(const Sweep& sweep, const std::string& key) {
  std::vector<std::string> keys;
  for (const SweepAxis& axis : sweep.axes) {
    keys.push_back(axis.key);
  }
  const auto found = std::find(keys.begin(), keys.end(), key);
  if (found == keys.end()) {
    throw UsageError("--over: found '" + key + '\'' + did_you_mean(key, keys) +
                     ", expected axes of the sweep: " + joined(keys));
  }
  return static_cast<std::size_t>(found - keys.begin());
}

const SweepMeasure& measure_named(const std::string& name) {
  std::vector<std::string> names;
  for (const SweepMeasure& measure : sweep_measures()) {
    if (name == measure.name) {
      return measure;
    }
    names.emplace_back(measure.name);
  }
  throw UsageError("--plot: found '" + name + '\'' + did_you_mean(name, names) + ", expected some of " +
                   joined(names));
}

std::vector<std::size_t> others_of(const Sweep& sweep, const AxesOfPlot& axes, std::size_t run) {
  std::vector<std::size_t> choice = sweep.choice(run);
  choice[axes.x] = 0;
  if (axes.curves < choice.size()) {
    choice[axes.curves] = 0;
  }
  return choice;
}

/// A column for each combination of the axes that are neither across nor curves, or one for all of them.
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

using Table = std::map<Place, Found>;

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

/// The key with its unit.
std::string label_of(const std::string& key) {
  for (const Key<DrawnScene>& known : drawn_scene_format().keys) {
    if (known.name == key && !known.unit.empty()) {
      return key + " in " + known.unit;
    }
  }
  return key;
}

/// Logarithmic where all is above 0 and far apart, else linear, with some room.
Axis axis_around(const std::string& label, const std::vector<double>& values, double far_apart) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  if (values.empty()) {
    return {label};
  }
  if (*least > 0.0 && *most > far_apart * *least) {
    return {label, *least / 1.3, *most * 1.3, true};
  }
  const double room = *most > *least ? 0.06 * (*most - *least) : 0.5 * std::max(1e-9, std::abs(*most));
  return {label, *least - room, *most + room};
}

Curve curve_of(const Table& table, std::size_t column, std::size_t k, const std::vector<double>& xs) {
  constexpr std::array markers = {Marker::disc, Marker::square};
  const std::array colours = {palette::blue, palette::vermilion, palette::ink, palette::orange, palette::sky};
  Curve curve;
  curve.stroke = {colours[k % colours.size()], 4.0F, {}};
  if (k >= colours.size()) {
    curve.stroke.dashes = {4.0F, 2.5F};
  }
  curve.marker = markers[k % markers.size()];
  for (std::size_t x = 0; x < xs.size(); ++x) {
    const auto found = table.find({column, k, x});
    if (found != table.end()) {
      const std::vector<double>& values = found->second.values;
      double sum = 0.0;
      for (const double value : values) {
        sum += value;
      }
      const auto [least, most] = std::minmax_element(values.begin(), values.end());
      curve.points.push_back({xs[x], sum / static_cast<double>(values.size())});
      curve.bars.push_back({*least, *most});
    }
  }
  const bool has_bars =
      std::any_of(curve.bars.begin(), curve.bars.end(), [](const DataPoint& bar) { return bar[0] < bar[1]; });
  if (!has_bars) {
    curve.bars.clear();
  }
  return curve;
}

Curve rings_of(const Table& table, std::size_t column, const std::vector<double>& xs) {
  Curve rings{"a promise was broken", {}, {palette::ink, 0.0F, {}}, Marker::ring};
  for (const auto& [place, found] : table) {
    if (place.column == column && found.is_broken) {
      rings.points.push_back({xs[place.x], found.values.front()});
    }
  }
  return rings;
}

std::vector<double> numbers_of(const SweepAxis& axis) {
  std::vector<double> numbers;
  for (const Json& value : axis.values) {
    if (!value.is_number()) {
      throw UsageError("--over: found " + axis.key + ", which is not a number, expected one to go across");
    }
    numbers.push_back(value);
  }
  return numbers;
}

/// The plots of one measure, one for each column, with the same axes.
std::vector<Plot> plots_of(const Sweep& sweep, const AxesOfPlot& axes, const Columns& columns,
                           const SweepMeasure& measure) {
  const Table table = gather(sweep, axes, columns, measure);
  const std::vector<double> xs = numbers_of(sweep.axes[axes.x]);
  std::vector<double> ys;
  for (const auto& [place, found] : table) {
    ys.insert(ys.end(), found.values.begin(), found.values.end());
  }
  Plot plot;
  plot.legend = LegendCorner::none;
  plot.x = axis_around(label_of(sweep.axes[axes.x].key), xs, 100.0);
  plot.x.chosen = xs.size() <= 6 ? xs : std::vector<double>{};
  plot.y = axis_around(measure.label, ys, 30.0);
  plot.y.suffix = measure.suffix;
  if (const double least = ys.empty() ? 0.0 : *std::min_element(ys.begin(), ys.end());
      !plot.y.logarithmic && least >= 0.0) {
    plot.y.minimum = least < 0.5 * plot.y.maximum ? 0.0 : plot.y.minimum;
  }
  std::vector<Plot> plots(columns.titles.size(), plot);
  for (std::size_t column = 0; column < plots.size(); ++column) {
    const std::size_t count = axes.curves < sweep.axes.size() ? sweep.axes[axes.curves].values.size() : 1;
    for (std::size_t k = 0; k < count; ++k) {
      Curve curve = curve_of(table, column, k, xs);
      curve.name = count > 1 ? value_label(sweep.axes[axes.curves].values[k]) : "";
      plots[column].curves.push_back(std::move(curve));
    }
    Curve rings = rings_of(table, column, xs);
    if (!rings.points.empty()) {
      plots[column].curves.push_back(std::move(rings));
    }
  }
  return plots;
}

/// What the curves of all plots are called: rings once, wherever they are.
std::vector<Curve> legend_of(const std::vector<std::vector<Plot>>& rows) {
  std::vector<Curve> legend;
  std::set<std::string> names = {""};
  for (const std::vector<Plot>& row : rows) {
    for (const Plot& plot : row) {
      for (const Curve& curve : plot.curves) {
        if (names.insert(curve.name).second) {
          legend.push_back(curve);
        }
      }
    }
  }
  return legend;
}

/// Where all is, in pixels.
struct PlotSheet {
  float panel_width = 960.0F;
  float panel_height = 700.0F;
  float gap = 50.0F;
  PlotStyle style;
  float title = 0.0F;   ///< height of the titles
  float legend = 0.0F;  ///< height of the legend
};

void draw_titles(renderer::Canvas& canvas, const std::vector<std::string>& titles, const PlotSheet& sheet) {
  renderer::TextStyle style = text_style(1.1F * sheet.style.text_px, palette::ink, true);
  style.horizontal = renderer::HorizontalAlign::centre;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const float left = sheet.gap + (sheet.panel_width + sheet.gap) * static_cast<float>(i);
    canvas.text(left + 0.5F * sheet.panel_width, 0.75F * sheet.title, titles[i], style);
  }
}

/// One row, in the middle, that begins with what the curves differ in.
void draw_legend(renderer::Canvas& canvas, const std::string& heading, const std::vector<Curve>& legend,
                 const PlotSheet& sheet) {
  const float between = 1.5F * sheet.style.text_px;
  renderer::TextStyle style = text_style(sheet.style.text_px);
  style.vertical = renderer::VerticalAlign::middle;
  const float heading_width = canvas.measure(heading, style).width_px;
  float width = heading_width;
  for (const Curve& curve : legend) {
    width += between + 3.1F * sheet.style.text_px + canvas.measure(curve.name, style).width_px;
  }
  float left = 0.5F * (static_cast<float>(canvas.width_px()) - width);
  const float middle = sheet.title + 0.5F * sheet.legend;
  canvas.text(left, middle, heading, style);
  left += heading_width + between;
  for (const Curve& curve : legend) {
    left = draw_legend_entry(canvas, curve, left, middle, sheet.style) + between;
  }
}

}  // namespace

Drawing draw_sweep(const Sweep& sweep, const SweepPlot& wanted) {
  AxesOfPlot axes{axis_named(sweep, wanted.x), sweep.axes.size()};
  if (!wanted.curves.empty()) {
    axes.curves = axis_named(sweep, wanted.curves);
  }
  const Columns columns = columns_of(sweep, axes);
  std::vector<std::vector<Plot>> rows;
  for (const std::string& name : wanted.measures) {
    rows.push_back(plots_of(sweep, axes, columns, measure_named(name)));
  }
  const std::vector<Curve> legend = legend_of(rows);
  const std::string heading = wanted.curves.empty() ? "" : label_of(wanted.curves);
  PlotSheet sheet;
  const auto width = static_cast<float>(columns.titles.size()) * (sheet.panel_width + sheet.gap) + sheet.gap;
  // Not below smallest_text_pt on a page of that width.
  sheet.style.text_px = std::max(34.0F, 1.02F * smallest_text_pt * width / (72.0F * page_width_inches));
  sheet.title = columns.titles.front().empty() ? 0.3F * sheet.gap : 2.0F * sheet.style.text_px;
  sheet.legend = legend.empty() ? 0.0F : 2.0F * sheet.style.text_px;
  const float top = sheet.title + sheet.legend;
  Drawing drawing;
  drawing.width_px = static_cast<int>(width);
  drawing.height_px =
      static_cast<int>(top + (sheet.panel_height + sheet.gap) * static_cast<float>(rows.size()));
  drawing.draw = [=](renderer::Canvas& canvas) {
    draw_titles(canvas, columns.titles, sheet);
    if (!legend.empty()) {
      draw_legend(canvas, heading, legend, sheet);
    }
    for (std::size_t row = 0; row < rows.size(); ++row) {
      for (std::size_t column = 0; column < rows[row].size(); ++column) {
        const float left = sheet.gap + (sheet.panel_width + sheet.gap) * static_cast<float>(column);
        const float upper = top + (sheet.panel_height + sheet.gap) * static_cast<float>(row);
        draw_plot(canvas, rows[row][column], {left, upper, sheet.panel_width, sheet.panel_height},
                  sheet.style);
      }
    }
  };
  return drawing;
}

}  // namespace taut::app
