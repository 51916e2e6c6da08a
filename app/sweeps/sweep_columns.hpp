#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "app/sweeps/sweep.hpp"
#include "app/sweeps/sweep_table.hpp"

namespace taut::app {

/// A measurement and its place: of one column of plots, one curve, one x.
struct Place {
  std::size_t column;
  std::size_t curve;
  std::size_t x;
  auto operator<=>(const Place&) const = default;
};

/// The values there, of several runs where other axes have no columns.
struct Found {
  std::vector<double> values;
  bool is_broken = false;
};

/// The columns of plots.
struct Columns {
  std::vector<std::string> titles;
  std::map<std::vector<std::size_t>, std::size_t> of_choice;  ///< of the other axes
};

/// Which axes are across and which curves, by number.
struct AxesOfPlot {
  std::size_t x;
  std::size_t curves;  ///< as many as there are axes: one curve
};

using Table = std::map<Place, Found>;

/// A column for each combination of the axes that are neither across nor curves, or one for all of them.
Columns columns_of(const Sweep& sweep, const AxesOfPlot& axes);

/// One measure of all results.
Table gather(const Sweep& sweep, const AxesOfPlot& axes, const Columns& columns, const SweepMeasure& measure);

}  // namespace taut::app
