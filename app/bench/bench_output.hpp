#pragma once

#include <string>

#include "app/bench/findings.hpp"
#include "app/drawing/drawing.hpp"
#include "app/report/machine.hpp"

namespace taut::app {

/// The benchmark for people: what each engine needs for each bound, how that grows, how it compares.
std::string bench_table(const BenchResults& results);

/// Every run and every finding for programs.
std::string bench_json(const BenchResults& results, const Machine& machine);

/// Time against stretch for every scene at one size, on logarithmic axes with every engine's Pareto front;
/// and, with several sizes, time against triangles.
Drawing draw_bench(const BenchResults& results);

/// What `draw_bench` draws, without captions.
std::vector<Plot> bench_plots(const BenchResults& results);

/// "5 %", "0.1 %".
std::string percent(double fraction);

/// How an engine is called in tables and legends.
std::string title_of_engine(const std::string& engine);

/// The springs that the literal sweep of `strong` corrects in a second, the most any of its runs achieved; 0
/// without it. The unit in which two machines can be compared.
double strong_springs_per_s(const Heat& heat);

}  // namespace taut::app
