#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/bench/cases.hpp"
#include "app/bench/race.hpp"
#include "app/bench/sweep_speed.hpp"
#include "app/drawing/plots/plot.hpp"

namespace taut::app {

/// All runs of one scene at one size. Their frames were computed in turns (race.hpp).
struct Heat {
  BenchScene scene;
  BenchSize size;
  std::size_t structural_springs = 0;
  std::size_t flexural_springs = 0;
  std::vector<Run> runs;
  std::vector<SweepSpeed> sweeps;  ///< on this garment; the last entry is the vector unit that frames use
};

/// Everything the benchmark measured.
struct BenchResults {
  std::vector<double> bounds;  ///< as fractions, the largest first
  int frames = 0;              ///< of each run
  double frame_rate_hz = 60.0;
  bool is_ablation = false;  ///< the entrants are ablation_entrants()
  std::vector<Heat> heats;
};

/// A summary of one run. All members are 0 if the run has no frame.
struct RunFacts {
  double median_ms = 0.0;  ///< of processor time per frame, as the next two
  double mean_ms = 0.0;
  double p99_ms = 0.0;
  double raw_stretch = 0.0;  ///< largest of all frames, as the next two; see FrameSample
  double stretch = 0.0;
  double p99_stretch = 0.0;
  double surface_stretch = 0.0;  ///< of the triangles, as the next; no run is judged or ranked by them
  double p99_surface_stretch = 0.0;
  int median_substeps = 0;
  int most_substeps = 0;           ///< the largest number in one frame
  int not_certified = 0;           ///< frames that the engine itself did not certify
  double projections_per_s = 0.0;  ///< corrections of springs or triangles per second of processor time
};

/// Computes the summary of a run.
RunFacts facts_of(const Run& run);

/// Which number of a frame is compared with a bound. It is the stretch of the worst edge, or the stretch that
/// 1 % of the edges exceed.
enum class StretchMeasure { worst_edge, p99 };
/// Both measures.
inline constexpr std::array stretch_measures = {StretchMeasure::worst_edge, StretchMeasure::p99};

/// "worst edge" or "99th percentile".
const char* name_of(StretchMeasure measure);

/// The member of `facts` that belongs to the measure.
double stretch_by(StretchMeasure measure, const RunFacts& facts);

/// Counts the frames whose stretch exceeds `bound`. There is no tolerance. A stretch that is not a number
/// counts as exceeded.
int frames_over(const Run& run, double bound, StretchMeasure measure = StretchMeasure::worst_edge);

/// Returns whether the run reached its last frame and every frame keeps the bound.
bool keeps(const Run& run, double bound, StretchMeasure measure = StretchMeasure::worst_edge);

/// Returns the engine's run with the smallest median time among those that keep the bound. For an engine with
/// a bound, only the run that was asked for this bound counts. Returns null if there is none.
const Run* best_run(const Heat& heat, const std::string& engine, double bound,
                    StretchMeasure measure = StretchMeasure::worst_edge);

/// Returns the engine's run with the smallest stretch, for use when best_run finds none. Runs that reached
/// their end come before all others. For an engine with a bound, only the run that was asked for this bound
/// counts. Returns null if the engine did not run.
const Run* closest_run(const Heat& heat, const std::string& engine, double bound);

/// Returns the indices of the points that no other point beats in both coordinates. Smaller is better. They
/// are sorted by x.
std::vector<std::size_t> pareto_front(std::span<const DataPoint> points);

/// How the time an engine needs for a bound grows with the triangles: time = factor * triangles^exponent.
struct Growth {
  double exponent = 0.0;
  int sizes = 0;  ///< how many sizes were fitted
};
/// Fits the growth over the sizes at which the engine keeps the bound. Empty for fewer than two sizes.
std::optional<Growth> growth_of(const BenchResults& results, const std::string& scene,
                                const std::string& engine, double bound);

/// The names of the engines that ran, in the order they were entered.
std::vector<std::string> engines_in(const BenchResults& results);

/// A comparison of `bounded` with another engine, by median time per frame.
struct SpeedRatio {
  double bounded_ms = 0.0;
  double peer_ms = 0.0;
  std::string peer_settings;  ///< settings of the other engine's best run

  /// How many times faster `bounded` is.
  double ratio() const { return peer_ms / bounded_ms; }
};
/// Compares `bounded` keeping `bound` with the best run of `peer` keeping `peer_bound`. Empty if either has
/// no such run.
std::optional<SpeedRatio> speed_ratio(const Heat& heat, double bound, const std::string& peer,
                                      double peer_bound, StretchMeasure measure = StretchMeasure::worst_edge);

}  // namespace taut::app
