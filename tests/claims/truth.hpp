#pragma once

#include <cmath>

#include "app/drawing/plots/plot.hpp"
#include "app/figures/figures.hpp"

namespace taut::app {

/// One measured number beside the one that theory or a publication gives.
struct TruthPoint {
  std::string experiment;  ///< the name of a TruthExperiment
  std::string curve;       ///< what is compared with one line: a load case, a fabric, a coefficient
  std::string mesh;        ///< "9 x 33": vertices across and along
  double x = 0.0;
  double measured = 0.0;
  double published = 0.0;     ///< NaN where nothing is
  double published_to = NAN;  ///< where a range is published, its upper end
};

/// How a deviation counts: as a part of what is published, in units of y, or only where it is above.
enum class Measure { part, difference, excess };

/// An experiment that others published, or that has a closed form.
struct TruthExperiment {
  std::string name;
  std::string title;   ///< of its panel
  std::string source;  ///< author and year, or equation
  std::string x_label, y_label;
  bool is_x_logarithmic = false, is_y_logarithmic = false;
  LegendCorner legend = LegendCorner::none;
  Measure measure = Measure::part;
  double tolerance = 0.0;  ///< the largest deviation that passes
  double known = 0.0;      ///< where it does not pass, the worst deviation with its sign: a flaw that is to be mended
  /// Runs it with the program's law, friction, force or gravity `physics` times what is compared with.
  std::vector<TruthPoint> (*run)(const TruthExperiment& experiment, double physics, const ProgressCallback& report);
  /// Where ranges are published that are wider than a tenth of the physics moves it, the mean of all that is measured.
  double mean = 0.0;
};

/// All of them, in the order of the panels.
std::vector<TruthExperiment> truth_experiments();

/// The largest and the root mean square deviation of the points of an experiment.
struct Deviation {
  std::size_t points = 0;
  double worst = 0.0;  ///< the largest, with its sign
  double rms = 0.0;

  double largest() const { return std::abs(worst); }
};
Deviation deviation_of(const TruthExperiment& experiment, std::span<const TruthPoint> points);

/// How far a clamped strip droops by its own weight: drop over reach of its end, for weight * length^3 / rigidity. The
/// heavy elastica, B a'' = -w (L - s) cos a, clamped level at s = 0 and free at s = L (Bickley 1934).
double droop_of_elastica(double weight_over_rigidity);

/// The weight times length^3 over rigidity at which a strip that is clamped upright on its edge gives way sideways, for
/// its width over its length: 12.85 sqrt(bending x torsion) where it is narrow (Timoshenko and Gere 1961), and more
/// where it is not. A plate with a lateral contraction of 1/3, as bending springs in all directions make it, by the
/// method of Ritz.
double weight_that_buckles(double width);

/// The least friction that holds the lower end of a weightless strip whose clamp has come down by this part of its
/// length: horizontal over vertical force of a clamped and hinged elastica (Sano, Yamaguchi and Wada 2017).
double friction_that_sticks(double strain);

/// Jobs that fill `points`, as experiments() has those of the figures.
std::vector<Job> truth_jobs(std::vector<TruthPoint>& points);
/// The figure "truth": a panel for each experiment.
Figure truth_figure(std::vector<TruthPoint>& points);
/// Reads the points from truth.csv in the folder. Throws InputError that names the file and the line.
void read_truth(std::vector<TruthPoint>& points, const std::filesystem::path& folder);

/// The table of deviations for the report, as HTML.
std::string truth_html(std::span<const TruthPoint> points);

}  // namespace taut::app
