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

/// All runs of one scene at one size; their frames were computed in turns.
struct Heat {
  BenchScene scene;
  BenchSize size;
  std::size_t structural_springs = 0;
  std::size_t flexural_springs = 0;
  std::vector<Run> runs;
  std::vector<SweepSpeed> sweeps;  ///< over this garment; the last is of the unit that frames take
};

struct BenchResults {
  std::vector<double> bounds;  ///< as fractions, the loosest first
  int frames = 0;
  double frame_rate_hz = 60.0;
  bool is_ablation = false;
  std::vector<Heat> heats;
};

/// A run in a few numbers. All zero where there is no frame.
struct RunFacts {
  double median_ms = 0.0;
  double mean_ms = 0.0;
  double p99_ms = 0.0;
  double raw_stretch = 0.0;  ///< the worst of all frames, as the next three
  double stretch = 0.0;
  double p99_stretch = 0.0;
  int median_substeps = 0;
  int most_substeps = 0;
  int not_certified = 0;  ///< frames
  double springs_per_s = 0.0;
};

RunFacts facts_of(const Run& run);

/// What of a frame is held against a bound: its worst edge, or the stretch that a hundredth of its edges
/// exceed.
enum class StretchMeasure { worst_edge, p99 };
inline constexpr std::array stretch_measures = {StretchMeasure::worst_edge, StretchMeasure::p99};

/// "worst edge", "99th percentile".
const char* name_of(StretchMeasure measure);

double stretch_by(StretchMeasure measure, const RunFacts& facts);

/// Frames that are stretched by more than the bound allows. No tolerance: a frame either keeps the bound or
/// does not.
int frames_over(const Run& run, double bound, StretchMeasure measure = StretchMeasure::worst_edge);

/// Whether the run reached its end and kept the bound in every frame.
bool keeps(const Run& run, double bound, StretchMeasure measure = StretchMeasure::worst_edge);

/// The engine's fastest run by median that keeps the bound; of an engine that takes a bound, the one that was
/// asked for it. Null where there is none.
const Run* best_run(const Heat& heat, const std::string& engine, double bound,
                    StretchMeasure measure = StretchMeasure::worst_edge);

/// What comes closest where no run keeps the bound: of those that reached their end (or, without any, of all)
/// the one that stretched least; of an engine that takes a bound, the one that was asked for it. Null where
/// the engine did not run.
const Run* closest_run(const Heat& heat, const std::string& engine, double bound);

/// Which points no other point beats in both coordinates, smaller being better, in the order of x.
std::vector<std::size_t> pareto_front(std::span<const DataPoint> points);

/// How an engine's time for a bound grows with the triangles, over the sizes at which it keeps it. None with
/// fewer than two.
struct Growth {
  double exponent = 0.0;
  int sizes = 0;
};
std::optional<Growth> growth_of(const BenchResults& results, const std::string& scene,
                                const std::string& engine, double bound);

/// The engines that ran, in the order they were entered.
std::vector<std::string> engines_in(const BenchResults& results);

/// How many times faster `bounded` keeps `bound` than the peer, at its best setting, keeps `peer_bound`; by
/// medians of frames computed in turns.
struct SpeedRatio {
  double bounded_ms = 0.0;
  double peer_ms = 0.0;
  std::string peer_settings;

  double ratio() const { return peer_ms / bounded_ms; }
};
std::optional<SpeedRatio> speed_ratio(const Heat& heat, double bound, const std::string& peer,
                                      double peer_bound, StretchMeasure measure = StretchMeasure::worst_edge);

}  // namespace taut::app
