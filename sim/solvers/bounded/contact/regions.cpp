#include "sim/solvers/bounded/contact/regions.hpp"

#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

}  // namespace

// The normal is known at a plane, a sphere or a capsule. It is the only kind of pair that is placed by itself; kernels
// place all others.
void Regions::place_plane(const RowMoves& rows, RegionPair& pair) const {
  const NearPair& near = pair.contact.near;
  std::array<glm::vec3, 4> p{};
  PairExtent extent = {0.0F, 0.0F, 0.0F, rows.displaced_m};
  float squared_across = 0.0F;
  for (Index k = 0; k < 4; ++k) {
    const Float4& row = extents_[near.rows[k]];
    p[k] = vec(rows.positions[near.rows[k]]);
    extent.from_origin = std::max(extent.from_origin, row.x);
    extent.moved = std::max(extent.moved, row.y);
    const glm::vec3 across = p[k] - p[0];
    squared_across = std::max(squared_across, glm::dot(across, across));
    pair.heights[k] = glm::dot(*pair.contact.normal, across);
  }
  extent.across = std::sqrt(squared_across);
  pair.normal = *pair.contact.normal;
  pair.weights = closest_weights(near, p);
  pair.distance = height_span(near, pair.heights).apart();
  pair.error = distance_error_m(extent);
}

void Regions::take_planes(const PairBatches::Batch& batch, std::span<const ContactPair> pairs) {
  const PairBlock& block = batch.block;
  for (std::size_t i = 0; i < batch.count; ++i) {
    RegionPair& pair = pairs_[batch.index[i]];
    pair.contact = pairs[batch.index[i]];
    pair.normal = {block.normal[0][i], block.normal[1][i], block.normal[2][i]};
    for (std::size_t k = 0; k < 4; ++k) {
      pair.heights[k] = block.heights[k][i];
      pair.weights[k] = block.weights[k][i];
    }
    pair.distance = block.distance[i];
    pair.error = block.error[i];
    set_distances(pair);
  }
}

// A vertex that starts within a body with a known normal is let out. Primitives at the smallest distance would get even
// nearer and block others, so they are separated slightly.
void Regions::set_distances(RegionPair& pair) {
  const ContactPair& contact = pair.contact;
  pair.is_resolved = contact.normal || pair.distance > pair.error;  // false for a NaN distance of touching primitives
  const float gap_m = planned_gap_m(contact.thickness_m, pair.error);
  const float more = pair.distance > 0.0F ? std::clamp(2.0F * gap_m - pair.distance, 0.0F, gap_m) : 0.0F;
  pair.min_distance = std::min(pair.distance, gap_m);
  pair.target_distance = std::max(pair.min_distance, std::min(pair.distance + more, contact.thickness_m));
  assert(!pair.is_resolved || contact.normal || pair.min_distance > pair.error);
}

// Unchanged pairs are found again in the same order.
void Regions::find_same(std::span<const ContactPair> pairs, std::size_t rows) {
  unchanged_pairs_.assign(pairs.size(), nullptr);
  if (rows == 0) return;
  const auto is_kept = [&](const ContactPair& contact) {
    return std::all_of(contact.near.rows.begin(), contact.near.rows.end(),
                       [&](Index row) { return row < rows && extents_[row].y == earlier_extents_[row].y; });
  };
  auto earlier = earlier_.begin();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    earlier = std::find_if(earlier, earlier_.end(), [&](const RegionPair& pair) { return is_kept(pair.contact); });
    if (earlier != earlier_.end() && earlier->contact.near == pairs[i].near) unchanged_pairs_[i] = &*earlier++;
  }
}

void Regions::make_pairs(std::span<const ContactPair> pairs, const RowMoves& rows, std::size_t begin, std::size_t end,
                         const ContactKernels& kernels) {
  const PairRows pair_rows = {rows.positions.data(), rows.moves.data(), rows.normals.data(), extents_.data(),
                              rows.displaced_m};
  const auto take = [&](PairBatches::Batch& batch) {
    const auto place = batch.first_count == 1 ? kernels.place_triangle_planes : kernels.place_edge_planes;
    place(pair_rows, batch.block);
    take_planes(batch, pairs);
  };
  PairBatches batches;
  for (std::size_t i = begin; i < end; ++i) {
    if (unchanged_pairs_[i] != nullptr) {
      pairs_[i] = *unchanged_pairs_[i];
    } else if (pairs[i].normal) {
      pairs_[i].contact = pairs[i];
      place_plane(rows, pairs_[i]);
      set_distances(pairs_[i]);
    } else {
      batches.add(pairs[i].near, i, pairs[i].thickness_m, take);
    }
  }
  batches.end(take);
}

void Regions::make_pairs(std::span<const ContactPair> pairs, const RowMoves& rows, bool is_again,
                         ParallelKernels& kernels) {
  blocked_.reset();
  earlier_.swap(pairs_);
  earlier_extents_.swap(extents_);
  extents_.resize(rows.radii.size());
  for (std::size_t row = 0; row < extents_.size(); ++row) {
    extents_[row].x = glm::length(vec(rows.positions[row]));
    extents_[row].y = glm::length(vec(rows.moves[row])) + rows.radii[row];
  }
  find_same(pairs, is_again ? std::min(rows.cloth_count, earlier_extents_.size()) : 0);
  pairs_.resize(pairs.size());
  kernels.split(0, pairs.size(), ParallelKernels::min_pairs,
                [&](std::size_t begin, std::size_t end) { make_pairs(pairs, rows, begin, end, kernels.contact()); });
  std::erase_if(pairs_, [&](const RegionPair& pair) {
    if (!pair.is_resolved) note_blocked(pair.contact.near, 0.0F);
    return !pair.is_resolved;
  });
  note_kinematic_gap(rows.inverse_masses_per_kg);
}

// A vertex that starts within a body has no gap to lose.
void Regions::note_kinematic_gap(std::span<const float> inverse_masses) {
  kinematic_gap_m_ = infinity;
  for (const RegionPair& pair : pairs_) {
    const auto& r = pair.contact.near.rows;
    const auto is_kinematic = [&](Index row) { return !(inverse_masses[row] > 0.0F); };
    if (pair.distance > pair.error && std::any_of(r.begin(), r.end(), is_kinematic)) {
      kinematic_gap_m_ = std::min(kinematic_gap_m_, pair.min_distance - pair.error);
    }
  }
}

void Regions::note_blocked(const NearPair& near, float distance) {
  if (!blocked_) blocked_ = {near, distance};
}

Regions::HeightSpan Regions::height_span(const NearPair& near, const std::array<float, 4>& heights) {
  HeightSpan span = {infinity, -infinity};
  for (Index k = 0; k < 4; ++k) {
    if (k < near.first_count) {
      span.low = std::min(span.low, heights[k]);
    } else {
      span.high = std::max(span.high, heights[k]);
    }
  }
  return span;
}

Regions::HeightSpan Regions::span_at_end(const RegionPair& pair) const {
  std::array<float, 4> heights = pair.heights;
  for (Index k = 0; k < 4; ++k) heights[k] += glm::dot(pair.normal, vec(planned_motions_[pair.contact.near.rows[k]]));
  return height_span(pair.contact.near, heights);
}

// Projects motions onto those that keep a distance, corner by corner. Weights by mass keep momentum and gain no energy:
// a collision without rebound. Urgent pairs ignore mass, as heavy layers would take hundreds of passes.
void Regions::resolve(const RegionPair& pair, float left, bool is_urgent, std::span<const float> inverse_masses) {
  const NearPair& near = pair.contact.near;
  const auto mobility_of = [&](Index row) {
    const float mobility_per_kg = inverse_masses[row];
    return is_urgent && mobility_per_kg > 0.0F ? 1.0F : mobility_per_kg;
  };
  const float relaxation = is_urgent ? tuning::over_projection_factor : 1.0F;
  for (Index k = 0; k < near.first_count; ++k) {
    for (Index l = near.first_count; l < 4; ++l) {
      Float4& first = planned_motions_[near.rows[k]];
      Float4& second = planned_motions_[near.rows[l]];
      const float w_first = mobility_of(near.rows[k]);
      const float w_second = mobility_of(near.rows[l]);
      const float apart = pair.heights[k] - pair.heights[l] + glm::dot(pair.normal, vec(first) - vec(second));
      if (apart < left && w_first + w_second > 0.0F) {
        const glm::vec3 lacking = pair.normal * (relaxation * (left - apart) / (w_first + w_second));
        add(first, w_first * lacking);
        add(second, -w_second * lacking);
      }
    }
  }
}

// A pass transmits a push by about one layer. Vertices held in a pile would stop whatever closes in on it, so passes
// continue while any would be held. Those passes keep only the smallest distances, which leaves slack for squeezed
// layers, and are over-relaxed, which transmits pushes sooner.
void Regions::resolve_moves(std::span<const float> inverse_masses) {
  bool is_done = false;
  bool would_hold = true;
  for (int pass = 0; !is_done && (pass < tuning::passes_by_mass || (would_hold && pass < tuning::max_passes)); ++pass) {
    is_done = true;
    would_hold = false;
    const bool is_urgent = pass >= tuning::passes_by_mass;
    for (const RegionPair& pair : pairs_) {
      const float enough = tuning::motion_tolerance_fraction * pair.contact.thickness_m;
      const float left = is_urgent ? std::min(pair.min_distance + enough, pair.target_distance) : pair.target_distance;
      const float apart = span_at_end(pair).apart();
      if (apart < left - enough) {
        would_hold = would_hold || apart < pair.min_distance;
        resolve(pair, left, is_urgent, inverse_masses);
        is_done = false;
      }
    }
  }
}

// Nothing crosses if all vertices move alike or not at all. Each round restricts vertices for good, so the rounds end.
void Regions::hold_where_needed(const RowMoves& rows) {
  held_.assign(rows.radii.size(), HoldKind::no);
  bool has_changed = true;
  while (has_changed) {
    has_changed = false;
    for (const RegionPair& pair : pairs_) {
      if (span_at_end(pair).apart() >= pair.min_distance) continue;
      if (hold(pair.contact.near, HoldKind::carried, rows) || hold(pair.contact.near, HoldKind::still, rows)) {
        has_changed = true;
      } else {
        note_blocked(pair.contact.near, pair.distance);
      }
    }
  }
}

// Returns whether any vertex changed.
bool Regions::hold(const NearPair& near, HoldKind how, const RowMoves& rows) {
  bool has_changed = false;
  for (const Index row : near.rows) {
    if (rows.inverse_masses_per_kg[row] > 0.0F && held_[row] < how) {
      held_[row] = how;
      planned_motions_[row] = how == HoldKind::carried ? rows.kinematic_motion : Float4{};
      has_changed = true;
    }
  }
  return has_changed;
}

// Vertices that contact moves out of their trust regions are clamped by them if that keeps all pairs apart.
bool Regions::fit_radii(RowMoves& rows) {
  deviations_.resize(rows.radii.size());
  is_clamped_.assign(rows.radii.size(), 0);
  bool are_all_within = true;
  for (std::size_t row = 0; row < rows.radii.size(); ++row) {
    const glm::vec3 deviation = vec(planned_motions_[row]) - vec(rows.moves[row]);
    const float length = deviations_[row] = glm::length(deviation);
    const float max_deviation = tuning::ball_fill_fraction * rows.radii[row];
    if (rows.inverse_masses_per_kg[row] > 0.0F && !(length <= max_deviation)) {
      planned_motions_[row] = rows.moves[row];
      add(planned_motions_[row], max_deviation / length * deviation);
      is_clamped_[row] = 1;
      are_all_within = false;
    }
  }
  return are_all_within || !needs_larger_balls(rows);
}

bool Regions::needs_larger_balls(RowMoves& rows) const {
  bool needs = false;
  for (const RegionPair& pair : pairs_) {
    const auto& r = pair.contact.near.rows;
    const auto is_within = [&](Index row) { return is_clamped_[row] == 0; };
    if (std::all_of(r.begin(), r.end(), is_within) || span_at_end(pair).apart() >= pair.min_distance) continue;
    for (const Index row : r) {
      if (!is_within(row)) {
        rows.radii[row] = std::max(rows.radii[row], tuning::ball_growth_factor * deviations_[row]);
        needs = true;
      }
    }
  }
  return needs;
}

void Regions::place_half_spaces() {
  half_space_begin_.assign(radii_.size() + 1, 0);
  for (const RegionPair& pair : pairs_) {
    for (const Index row : pair.contact.near.rows) ++half_space_begin_[row + 1];
  }
  std::partial_sum(half_space_begin_.begin(), half_space_begin_.end(), half_space_begin_.begin());
  half_spaces_.resize(half_space_begin_.back());
  std::vector<Index> next(half_space_begin_.begin(), half_space_begin_.end() - 1);
  for (RegionPair& pair : pairs_) {
    for (Index k = 0; k < 4; ++k) pair.half_spaces[k] = next[pair.contact.near.rows[k]]++;
  }
}

void Regions::set_half_spaces(const RegionPair& pair, std::span<const float> inverse_masses) {
  const NearPair& near = pair.contact.near;
  bool is_first_fixed = false;
  bool is_second_fixed = false;
  for (Index k = 0; k < 4; ++k) {
    (k < near.first_count ? is_first_fixed : is_second_fixed) |= !(inverse_masses[near.rows[k]] > 0.0F);
  }
  // Fraction of the gap that the first primitive gets.
  const float share = is_first_fixed == is_second_fixed ? 0.5F : (is_first_fixed ? 0.0F : 1.0F);
  // Returns the position of the plane of the first or second primitive; both leave the needed distance.
  const auto plane = [&](const HeightSpan& span, bool is_first) {
    const float room = std::max(span.apart() - pair.min_distance, 0.0F);
    return is_first ? span.low - share * room : span.high + (1.0F - share) * room;
  };
  const HeightSpan begin = height_span(near, pair.heights);
  const HeightSpan end = span_at_end(pair);
  for (Index k = 0; k < 4; ++k) {
    const bool is_first = k < near.first_count;
    const float sign = is_first ? 1.0F : -1.0F;
    const float at_begin = sign * (plane(begin, is_first) - pair.heights[k]);
    const float at_end = sign * (plane(end, is_first) - pair.heights[k]);
    const float moved_up = sign * glm::dot(pair.normal, vec(planned_motions_[near.rows[k]]));
    half_spaces_[pair.half_spaces[k]] = {sign * pair.normal, at_begin, at_end - at_begin,
                                         std::min(-at_begin, moved_up - at_end),
                                         is_first ? is_second_fixed : is_first_fixed};
  }
}

float Regions::region_slack_m(Index row) const {
  float room = radii_[row] - std::min(deviations_[row], tuning::ball_fill_fraction * radii_[row]);
  for (const HalfSpace& half_space : half_spaces_at(row)) room = std::min(room, half_space.room);
  return room;
}

void Regions::make_half_spaces(std::span<const float> inverse_masses, ParallelKernels& kernels) {
  place_half_spaces();
  kernels.split(0, pairs_.size(), ParallelKernels::min_pairs, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) set_half_spaces(pairs_[i], inverse_masses);
  });
  kernels.for_rows(0, radii_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      planned_motions_[row].fourth = inverse_masses[row] > 0.0F ? region_slack_m(static_cast<Index>(row)) : infinity;
    }
  });
}

void Regions::stand_still(const RowMoves& rows) {
  planned_motions_ = rows.moves;
  for (std::size_t row = 0; row < planned_motions_.size(); ++row) {
    if (rows.inverse_masses_per_kg[row] > 0.0F) {
      planned_motions_[row] = Float4{};
    } else {
      planned_motions_[row].fourth = infinity;
    }
  }
  expected_ = planned_motions_;
  radii_.assign(planned_motions_.size(), 0.0F);
  half_space_begin_.assign(planned_motions_.size() + 1, 0);
  half_spaces_.clear();
  touches_.clear();
}

bool Regions::make(std::span<const ContactPair> pairs, RowMoves& rows, ParallelKernels& kernels, bool is_again) {
  planned_motions_ = rows.moves;
  rows.normals.resize(rows.positions.size());
  make_pairs(pairs, rows, is_again, kernels);
  resolve_moves(rows.inverse_masses_per_kg);
  hold_where_needed(rows);
  if (!fit_radii(rows)) {
    stand_still(rows);
    return false;
  }
  expected_ = rows.moves;
  radii_ = rows.radii;
  make_half_spaces(rows.inverse_masses_per_kg, kernels);
  make_touches(rows);
  return true;
}

}  // namespace taut::sim::bounded
