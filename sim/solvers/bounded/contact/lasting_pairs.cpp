#include "sim/solvers/bounded/contact/lasting_pairs.hpp"

#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {
namespace {

enum Mark : std::uint8_t { as_expected, renewed, unexpected };

float length_between(const Float4& a, const Float4& b) { return vector_length(scaled_sum(a, b, -1.0F)); }

}  // namespace

bool LastingPairs::is_list_for(const ExpectedRows& rows) const {
  constexpr double rounding_s = 1e-9;
  return begin_.size() == rows.radii.size() && rows.time.from_s >= time_.from_s &&
         rows.time.to_s <= time_.to_s + rounding_s;
}

// Returns the time as a fraction of the list's time; `at_once` if that has no duration.
float LastingPairs::list_time_fraction(double time_s, float at_once) const {
  const double lasts_s = time_.to_s - time_.from_s;
  return lasts_s > 0.0 ? static_cast<float>((time_s - time_.from_s) / lasts_s) : at_once;
}

void LastingPairs::sort_by_kind(std::span<const NearPair> pairs) {
  for (List& list : lists_) {
    for (Lanes<std::uint32_t>& at : list) at.clear();
  }
  for (const NearPair& pair : pairs) {
    for (std::size_t k = 0; k < 4; ++k) lists_[pair.first_count - 1][k].push_back(4 * pair.rows[k]);
  }
}

void LastingPairs::make_list(const ExpectedRows& rows, double until_s, float edge_m, ParallelKernels& kernels) {
  const double lasts_s = rows.time.to_s - rows.time.from_s;
  const auto longer = static_cast<float>(lasts_s > 0.0 ? (until_s - rows.time.from_s) / lasts_s : 0.0);
  const float slow_m = tuning::slow_motion_per_edge * edge_m;
  const auto is_fast = [&](const Float4& move) { return !(longer * vector_length(move) < slow_m); };
  begin_ = rows.positions;
  motions_ = rows.moves;
  reaches_.assign(rows.radii.begin(), rows.radii.end());
  marks_.assign(rows.radii.size(), as_expected);
  time_ = rows.time;
  const auto fast = static_cast<double>(std::count_if(rows.moves.begin(), rows.moves.end(), is_fast));
  is_lasting_ = longer > 1.0F && fast < tuning::max_fast_fraction * static_cast<double>(rows.moves.size());
  if (is_lasting_) {
    time_.to_s = until_s;
    for (std::size_t row = 0; row < reaches_.size(); ++row) {
      motions_[row] = multiply(motions_[row], longer);
      reaches_[row] += tuning::list_slack_per_edge * edge_m + tuning::slack_per_motion * vector_length(motions_[row]);
    }
  }
  ++searches_.all;
  list_pairs_ = near_.find(begin_, motions_, reaches_, kernels);
}

// The positions at the start and at the end of the time, and so at any time between, have to be within the list's
// range.
LastingPairs::Marked LastingPairs::mark_unexpected(const ExpectedRows& rows) {
  const float from = list_time_fraction(rows.time.from_s, 0.0F);
  const float to = list_time_fraction(rows.time.to_s, 1.0F);
  Marked marked = {0, 0};
  for (std::size_t row = 0; row < reaches_.size(); ++row) {
    const float room = reaches_[row] - rows.radii[row];
    const Float4 off = scaled_sum(rows.positions[row], begin_[row], -1.0F);
    const float before = length_between(off, multiply(motions_[row], from));
    const float after = length_between(scaled_sum(off, rows.moves[row], 1.0F), multiply(motions_[row], to));
    // This form also marks a value that is not a number.
    if (!(before <= room && after <= room)) {
      marks_[row] = unexpected;
      ++marked.unexpected;
    }
    marked.all += marks_[row] != as_expected ? 1 : 0;
  }
  return marked;
}

// Vertices continue from their current positions. At a moment that ends the list's time, their predicted motion stays.
void LastingPairs::renew_marked(const ExpectedRows& rows, float edge_m, ParallelKernels& kernels) {
  const double lasts_s = rows.time.to_s - rows.time.from_s;
  const double list_lasts_s = time_.to_s - time_.from_s;
  const bool is_end = !(lasts_s > 0.0) && list_lasts_s > 0.0;
  const auto longer = static_cast<float>(lasts_s > 0.0 ? list_lasts_s / lasts_s : 1.0);
  const float from = list_time_fraction(rows.time.from_s, 0.0F);
  for (std::size_t row = 0; row < reaches_.size(); ++row) {
    if (marks_[row] != unexpected) continue;
    marks_[row] = renewed;
    const Float4 expected = scaled_sum(begin_[row], motions_[row], from);
    const float off = std::min(length_between(rows.positions[row], expected), tuning::max_slack_per_edge * edge_m);
    if (!is_end) motions_[row] = multiply(rows.moves[row], longer);
    begin_[row] = scaled_sum(rows.positions[row], motions_[row], -from);
    reaches_[row] = rows.radii[row] + (is_end ? vector_length(rows.moves[row]) : 0.0F);
    if (is_lasting_) {
      reaches_[row] +=
          off + tuning::list_slack_per_edge * edge_m + tuning::slack_per_motion * vector_length(motions_[row]);
    }
  }
  ++searches_.marked;
  list_pairs_ = near_.find_anew(marks_, begin_, motions_, reaches_, kernels);
}

void LastingPairs::keep_near(const MovingRows& rows, Index first_count, const ContactKernels& kernels) {
  const List& list = lists_[first_count - 1];
  PairLists at{};
  for (std::size_t k = 0; k < 4; ++k) {
    kept_list_[k] = list[k];
    kept_list_[k].resize(list[k].size() + list_padding);
    at[k] = kept_list_[k].data();
  }
  append_near(rows, first_count, list[0].size(), at, kernels, pairs_);
}

std::span<const NearPair> LastingPairs::find(const ExpectedRows& rows, double until_s, float edge_m,
                                             ParallelKernels& kernels) {
  bool is_new = true;
  if (!is_list_for(rows)) {
    make_list(rows, until_s, edge_m, kernels);
  } else if (const Marked marked = mark_unexpected(rows);
             static_cast<double>(marked.all) > tuning::max_renewed_fraction * static_cast<double>(reaches_.size())) {
    make_list(rows, until_s, edge_m, kernels);
  } else if (marked.unexpected > 0) {
    renew_marked(rows, edge_m, kernels);
  } else {
    is_new = false;
  }
  if (!is_lasting_) return list_pairs_;
  if (is_new) sort_by_kind(list_pairs_);
  moving_ = rows.moves;
  for (std::size_t row = 0; row < rows.radii.size(); ++row) moving_[row].fourth = rows.radii[row];
  const MovingRows moving = {rows.positions.data(), moving_.data()};
  pairs_.clear();
  keep_near(moving, 1, kernels.contact());
  keep_near(moving, 2, kernels.contact());
  return pairs_;
}

}  // namespace taut::sim::bounded
