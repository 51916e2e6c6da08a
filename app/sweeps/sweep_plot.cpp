#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/base/errors.hpp"
#include "app/base/suggest.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/drawing/plots/plot.hpp"
#include "app/scene/scene_format.hpp"
#include "app/sweeps/sweep_columns.hpp"
#include "app/sweeps/sweep_table.hpp"

namespace taut::app {
namespace {

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

/// The axis across: values, or names at equal distances, where curves stand side by side.
struct Across {
  Axis axis;
  std::vector<double> xs;
  double apart = 0.0;     ///< curves
  double first_at = 0.0;  ///< the first curve

  double x_of(std::size_t curve, std::size_t x) const {
    return xs[x] + first_at + apart * static_cast<double>(curve);
  }
};

Across across_of(const SweepAxis& axis, std::size_t curves) {
  Across across;
  const auto is_number = [](const Json& value) { return value.is_number(); };
  if (std::all_of(axis.values.begin(), axis.values.end(), is_number)) {
    across.xs.assign(axis.values.begin(), axis.values.end());
    across.axis = axis_around(label_of(axis.key), across.xs, 100.0);
    across.axis.chosen = across.xs.size() <= 6 ? across.xs : std::vector<double>{};
    return across;
  }
  std::vector<std::string> names;
  for (const Json& value : axis.values) {
    names.push_back(value_label(value));
  }
  across.axis = axis_of_names(label_of(axis.key), std::move(names));
  across.xs = across.axis.chosen;
  across.apart = 0.7 / static_cast<double>(curves);
  across.first_at = -0.5 * across.apart * static_cast<double>(curves - 1);
  return across;
}

Curve curve_of(const Table& table, std::size_t column, std::size_t k, const Across& across) {
  constexpr std::array markers = {Marker::disc, Marker::square};
  const std::array colours = {palette::blue, palette::vermilion, palette::ink, palette::orange, palette::sky};
  Curve curve;
  curve.stroke = {colours[k % colours.size()], 4.0F, {}};
  if (k >= colours.size()) {
    curve.stroke.dashes = {4.0F, 2.5F};
  }
  curve.marker = markers[k % markers.size()];
  if (!across.axis.names.empty()) {
    curve.stroke.thickness_px = 0.0F;  // nothing is between names
  }
  for (std::size_t x = 0; x < across.xs.size(); ++x) {
    const auto found = table.find({column, k, x});
    if (found != table.end()) {
      const std::vector<double>& values = found->second.values;
      double sum = 0.0;
      for (const double value : values) {
        sum += value;
      }
      const auto [least, most] = std::minmax_element(values.begin(), values.end());
      curve.points.push_back({across.x_of(k, x), sum / static_cast<double>(values.size())});
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

Curve rings_of(const Table& table, std::size_t column, const Across& across) {
  Curve rings{"a promise was broken", {}, {palette::ink, 0.0F, {}}, Marker::ring};
  for (const auto& [place, found] : table) {
    if (place.column == column && found.is_broken) {
      rings.points.push_back({across.x_of(place.curve, place.x), found.values.front()});
    }
  }
  return rings;
}

/// The plots of one measure, one for each column, with the same axes.
std::vector<Plot> plots_of(const Sweep& sweep, const AxesOfPlot& axes, const Columns& columns,
                           const SweepMeasure& measure) {
  const Table table = gather(sweep, axes, columns, measure);
  const std::size_t count = axes.curves < sweep.axes.size() ? sweep.axes[axes.curves].values.size() : 1;
  const Across across = across_of(sweep.axes[axes.x], count);
  std::vector<double> ys;
  for (const auto& [place, found] : table) {
    ys.insert(ys.end(), found.values.begin(), found.values.end());
  }
  Plot plot;
  plot.legend = LegendCorner::none;
  plot.x = across.axis;
  plot.y = axis_around(measure.label, ys, 30.0);
  plot.y.suffix = measure.suffix;
  if (const double least = ys.empty() ? 0.0 : *std::min_element(ys.begin(), ys.end());
      !plot.y.logarithmic && least >= 0.0) {
    plot.y.minimum = least < 0.5 * plot.y.maximum ? 0.0 : plot.y.minimum;
  }
  std::vector<Plot> plots(columns.titles.size(), plot);
  for (std::size_t column = 0; column < plots.size(); ++column) {
    for (std::size_t k = 0; k < count; ++k) {
      Curve curve = curve_of(table, column, k, across);
      curve.name = count > 1 ? value_label(sweep.axes[axes.curves].values[k]) : "";
      plots[column].curves.push_back(std::move(curve));
    }
    Curve rings = rings_of(table, column, across);
    if (!rings.points.empty()) {
      plots[column].curves.push_back(std::move(rings));
    }
  }
  return plots;
}

/// The legend of all plots' curves: rings once, wherever they are.
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
  float title = 0.0F;  ///< height of the titles
};

void draw_titles(renderer::Canvas& canvas, const std::vector<std::string>& titles, const PlotSheet& sheet) {
  renderer::TextStyle style = text_style(1.1F * sheet.style.text_px, palette::ink, true);
  style.horizontal = renderer::HorizontalAlign::centre;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const float left = sheet.gap + (sheet.panel_width + sheet.gap) * static_cast<float>(i);
    canvas.text(left + 0.5F * sheet.panel_width, 0.75F * sheet.title, titles[i], style);
  }
}

/// The share of a plot's height that lines of names below the first one take.
float lines_of_names(const Plot& plot, const PlotSheet& sheet) {
  const renderer::Canvas ruler(1, 1);
  Plot with_numbers = plot;
  with_numbers.x.names.clear();
  const auto height = [&](const Plot& any) {
    return data_area_of(ruler, any, {0.0F, 0.0F, sheet.panel_width, sheet.panel_height}, sheet.style)
        .height_px;
  };
  return height(with_numbers) - height(plot);
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
  PlotSheet sheet;
  const auto width = static_cast<float>(columns.titles.size()) * (sheet.panel_width + sheet.gap) + sheet.gap;
  // Not below smallest_text_pt on a page of that width.
  sheet.style.text_px = std::max(34.0F, 1.02F * smallest_text_pt * width / (72.0F * page_width_inches));
  sheet.panel_height += lines_of_names(rows.front().front(), sheet);
  sheet.title = columns.titles.front().empty() ? 0.3F * sheet.gap : 2.0F * sheet.style.text_px;
  const LegendRows legend(wanted.curves.empty() ? "" : label_of(wanted.curves), legend_of(rows),
                          width - 2.0F * sheet.gap, sheet.style);
  const float top = sheet.title + legend.height_px();
  Drawing drawing;
  drawing.width_px = static_cast<int>(width);
  drawing.height_px =
      static_cast<int>(top + (sheet.panel_height + sheet.gap) * static_cast<float>(rows.size()));
  drawing.draw = [=](renderer::Canvas& canvas) {
    draw_titles(canvas, columns.titles, sheet);
    legend.draw(canvas, sheet.title);
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
