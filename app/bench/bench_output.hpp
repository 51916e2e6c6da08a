#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/bench/findings.hpp"
#include "app/drawing/drawing.hpp"
#include "app/report/machine.hpp"

namespace taut::app {

/// The results as text for people. It says what each engine needs for each bound, how that grows with the
/// triangles, and how the engines compare.
std::string bench_table(const BenchResults& results);

/// All runs and all findings as one JSON object.
std::string bench_json(const BenchResults& results, const Machine& machine);

/// The machine as a JSON object.
nlohmann::ordered_json machine_json(const Machine& machine);

/// Plots time per frame against stretch for every scene at one size, on logarithmic axes, with the Pareto
/// front of each engine. If there are several sizes, it also plots time against triangles.
Drawing draw_bench(const BenchResults& results);

/// The plots that draw_bench draws, without captions.
std::vector<Plot> bench_plots(const BenchResults& results);

/// A fraction as text: "5 %", "0.1 %".
std::string percent(double fraction);

/// The name of an engine in tables and legends.
std::string title_of_engine(const std::string& engine);

/// Corrections of springs per second by the sequential sweep of `strong`: the highest rate of all its runs,
/// or 0 if it did not run. It serves as a unit for comparing two machines.
double strong_projections_per_s(const Heat& heat);

}  // namespace taut::app
