#pragma once

#include "app/sweeps/sweep.hpp"
#include "renderer/page/image.hpp"

namespace taut::app {

/// Returns the result of a run: the JSON object of its file. Empty if there is none, or one of another scene
/// or program than planned.
std::optional<Json> result_of(const Sweep& sweep, std::size_t run);

/// Whether a run came to an end that another attempt would come to as well: "done" or "broken".
bool is_final(const Json& result);

/// How the runs of a sweep stand.
struct SweepStatus {
  std::size_t done = 0;
  std::size_t broken = 0;            ///< a promise was not kept, which is a result
  std::size_t failed = 0;            ///< could not be run, such as for want of memory
  std::size_t working = 0;           ///< have a lock
  std::size_t stopped = 0;           ///< have a checkpoint to go on from, and no lock
  std::vector<std::size_t> missing;  ///< all without a result that is final, ascending
  std::string first_failure;         ///< empty: none
};
SweepStatus status_of(const Sweep& sweep);

/// Ascending numbers as ranges: "3,7-12".
std::string ranges_text(std::span<const std::size_t> numbers);

/// The results of a sweep as a table (CSV): a row for each run, those without a result too, and a column for
/// each axis and each measure.
std::string sweep_table(const Sweep& sweep);

/// The most pictures on a contact sheet.
inline constexpr std::size_t most_on_sheet = 120;

/// The pictures of the runs, small, under the values that differ; of many, some at equal distances. One
/// column for each value of the last axis that has several. Returns an image of no size if there are none.
renderer::Image sweep_sheet(const Sweep& sweep);

}  // namespace taut::app
