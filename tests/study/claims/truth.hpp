#pragma once

#include "app/drawing/plots/plot.hpp"
#include "app/figures/figures.hpp"

namespace taut::app {

/// Returns the callback for one of equal parts of some work: the part with this number, counted from 0.
inline ProgressCallback report_part(const ProgressCallback& report, std::size_t part, std::size_t count) {
  return [=](double fraction) { report((static_cast<double>(part) + fraction) / static_cast<double>(count)); };
}

/// A measured number beside the number of theory or a publication.
struct TruthPoint {
  std::string curve;  ///< points of one line: a load case, a fabric, a coefficient
  double x = 0.0;
  double measured = 0.0;
  double published = 0.0;       ///< NaN: nothing is published
  double published_to = NAN;    ///< upper end of a published range
  std::string mesh = {};        ///< "9 x 33": vertices across and along
  std::string experiment = {};  ///< name of a TruthExperiment
};

/// Measure of a deviation: fraction of the published number, difference in units of y, or only the excess above it.
enum class Measure { part, difference, excess };

/// An experiment that others published, or that has a closed form.
struct TruthExperiment {
  std::string name;
  std::string title;   ///< title of its panel
  std::string source;  ///< author and year, or equation
  std::string x_label, y_label;
  bool is_x_logarithmic = false, is_y_logarithmic = false;
  LegendCorner legend = LegendCorner::none;
  Measure measure = Measure::part;
  double tolerance = 0.0;  ///< largest deviation that passes
  double known = 0.0;      ///< worst deviation with its sign if the experiment does not pass: a flaw to mend; 0: it
                           ///< passes
  /// Runs the experiment with `physics` times the right law, friction, force or gravity in the program.
  std::vector<TruthPoint> (*run)(double physics, const ProgressCallback& report);
  /// Mean of all measured numbers, for published ranges that are wider than the effect of a tenth of the physics; 0:
  /// not used.
  double mean = 0.0;
  /// Factor of wrong physics with which the experiment must not pass; nor with its inverse.
  double wrong = 1.1;
};

/// Return experiments in the order of the panels: those without wind, those in wind (figure 9), and all.
std::vector<TruthExperiment> calm_experiments();
std::vector<TruthExperiment> wind_experiments();
std::vector<TruthExperiment> truth_experiments();

/// Runs an experiment, and names it in its points.
std::vector<TruthPoint> run_experiment(const TruthExperiment& experiment, double physics,
                                       const ProgressCallback& report);

/// Largest and root mean square deviation of an experiment's points.
struct Deviation {
  std::size_t points = 0;
  double worst = 0.0;  ///< the largest, with its sign
  double rms = 0.0;

  double largest() const { return std::abs(worst); }
};
Deviation compute_deviation(const TruthExperiment& experiment, std::span<const TruthPoint> points);

/// Returns drop over reach of the end of a clamped strip that droops by its own weight, for weight * length^3 /
/// rigidity: the heavy elastica, B a'' = -w (L - s) cos a, clamped level at s = 0 and free at s = L (Bickley 1934).
double droop_of_elastica(double weight_over_rigidity);

/// Returns weight times length^3 over rigidity at which a strip that is clamped upright on its edge buckles sideways,
/// for its ratio of width to length. A narrow strip has 12.85 sqrt(bending x torsion) (Timoshenko and Gere 1961), a
/// wider one more. Computed by the method of Ritz for a plate with a lateral contraction of 1/3, which bending springs
/// in all directions give.
double weight_that_buckles(double width);

/// Returns the smallest friction that holds the lower end of a weightless strip, whose clamp has come down by this
/// fraction of its length: horizontal over vertical force of a clamped and hinged elastica (Sano, Yamaguchi and Wada
/// 2017).
double friction_that_sticks(double strain);

/// Onset of the flutter of a sheet in a wind along it, by linear theory with p = 1/2 rho U^2 c (w' + w_t / U): panel
/// flutter by piston theory (Hedgepeth 1957; Dowell 1975).
struct FlutterOnset {
  double load;       ///< 1/2 rho U^2 c length^3 / rigidity
  double frequency;  ///< times length^2 sqrt(density / rigidity)
};
/// The sheet is hinged at its edge to windward, and at the other unless that is free. `air_ratio` is 1/2 rho c length /
/// density.
FlutterOnset flutter_onset(double air_ratio, bool is_free);

/// Returns jobs that fill `points`, in the form of experiments().
std::vector<Job> truth_jobs(std::vector<TruthPoint>& points);
/// Return the figure "truth" of the calm experiments and figure 9 of those in wind, with a panel for each.
Figure truth_figure(std::vector<TruthPoint>& points);
Figure make_figure9(std::vector<TruthPoint>& points);
/// Adds the points of a table. Throws InputError that names the file and the line.
void read_truth(std::vector<TruthPoint>& points, const std::filesystem::path& file);

/// Returns the report's table of deviations as HTML.
std::string truth_html(std::span<const TruthExperiment> experiments, std::span<const TruthPoint> points);

}  // namespace taut::app
