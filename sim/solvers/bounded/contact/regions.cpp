#include "sim/solvers/bounded/contact/regions.hpp"

#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Where what the normal tells apart is less than this part of the smallest distance, it is uncertain.
constexpr float told_apart_part = 0.9F;

/// Returns the normal of the surfaces of both things of a pair, on the side of the first; nothing where these are not
/// known, or at right angles to the line between the two.
std::optional<glm::vec3> normal_of_surfaces(const NearPair& near, const std::array<glm::vec3, 4>& p,
                                            const glm::vec3& between, const RowMoves& rows) {
  std::array<glm::vec3, 2> sides = {glm::vec3(0.0F), glm::vec3(0.0F)};
  for (Index k = 0; k < 4; ++k) {
    if (near.rows[k] >= rows.normals.size()) return std::nullopt;
    sides[k < near.first_count ? 0 : 1] += vec(rows.normals[near.rows[k]]);
  }
  if (near.first_count == 1) sides[1] = glm::cross(p[2] - p[1], p[3] - p[1]);
  glm::vec3 sum(0.0F);
  for (const glm::vec3& side : sides) {
    const float towards_first = glm::dot(side, between) < 0.0F ? -1.0F : 1.0F;
    sum += towards_first / glm::length(side) * side;
  }
  const float length = glm::length(sum);
  return length > 0.0F ? std::optional(sum / length) : std::nullopt;  // nor where one is not a number
}

}  // namespace

// `p` are the corners of the pair.
PairExtent Regions::extent_of(const NearPair& near, const std::array<glm::vec3, 4>& p) const {
  PairExtent extent = {0.0F, 0.0F, 0.0F, displaced_m_};
  float squared_across = 0.0F;
  for (Index k = 0; k < 4; ++k) {
    const RowExtent& row = extents_[near.rows[k]];
    extent.from_origin = std::max(extent.from_origin, row.from_origin);
    extent.moved = std::max(extent.moved, row.moved);
    const glm::vec3 across = p[k] - p[0];
    squared_across = std::max(squared_across, glm::dot(across, across));
  }
  extent.across = std::sqrt(squared_across);
  return extent;
}

Regions::Pair Regions::pair_of(const ContactPair& contact, const RowMoves& rows) const {
  const NearPair& near = contact.near;
  std::array<glm::vec3, 4> p{};
  for (Index k = 0; k < 4; ++k) p[k] = vec(rows.positions[near.rows[k]]);
  Pair pair{};
  pair.contact = contact;
  pair.weights = closest_weights(near, p);
  const glm::vec3 between = between_closest(near, p, pair.weights);
  pair.normal = contact.normal.value_or(between / glm::length(between));
  set_heights(p, pair);
  // In things far longer than they are apart, rounding turns the line between their nearest points.
  if (!contact.normal && !(pair.distance > told_apart_part * glm::length(between))) {
    Pair across = pair;
    across.normal = normal_across(near, p, between);
    set_heights(p, across);
    pair = across.distance > pair.distance ? across : pair;
  }
  pair.error = distance_error_m(extent_of(near, p));
  if (!contact.normal) level(p, rows, pair);
  // Not so where the distance is not a number, as things touch. A thing that begins within a body that knows its way
  // out is let out.
  pair.is_told_apart = contact.normal || pair.distance > pair.error;
  // Things that touch as near as they may would be left a little nearer, and held fast in the way of what
  // comes at them: so they are to be parted somewhat.
  const float least = least_gap_m(contact.thickness_m, pair.error);
  const float more = pair.distance > 0.0F ? std::clamp(2.0F * least - pair.distance, 0.0F, least) : 0.0F;
  pair.needed = std::min(pair.distance, least);
  pair.wanted = std::max(pair.needed, std::min(pair.distance + more, contact.thickness_m));
  assert(!pair.is_told_apart || contact.normal || pair.needed > pair.error);
  return pair;
}

// Layers that slide pass the edges within each other. A plane at right angles to the shortest distance stands in the
// way of what comes to lie beside such an edge, as if it were a step.
void Regions::level(const std::array<glm::vec3, 4>& p, const RowMoves& rows, Pair& pair) const {
  const float apart_at_end = span_at_end(pair).apart();
  if (std::min(pair.distance, apart_at_end) > touched_m(pair.contact.thickness_m)) return;
  const glm::vec3 between = pair.normal;
  const std::optional<glm::vec3> normal = normal_of_surfaces(pair.contact.near, p, between, rows);
  if (!normal) return;
  Pair levelled = pair;
  levelled.normal = *normal;
  set_heights(p, levelled);
  const auto lacks = [&](const Pair& of) {
    return std::min(of.distance, of.contact.thickness_m) - span_at_end(of).apart();
  };
  const bool is_told_apart = levelled.distance > 2.0F * least_gap_m(pair.contact.thickness_m, pair.error);
  if (is_told_apart && lacks(levelled) < lacks(pair)) pair = levelled;
}

// Pairs of what has not changed are found again in their order.
void Regions::find_same(std::span<const ContactPair> pairs, std::size_t rows) {
  same_.assign(pairs.size(), nullptr);
  const auto is_kept = [&](const ContactPair& contact) {
    return std::all_of(contact.near.rows.begin(), contact.near.rows.end(),
                       [&](Index row) { return row < rows && extents_[row].moved == earlier_extents_[row].moved; });
  };
  auto earlier = earlier_.begin();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    earlier = std::find_if(earlier, earlier_.end(), [&](const Pair& pair) { return is_kept(pair.contact); });
    if (earlier != earlier_.end() && earlier->contact.near == pairs[i].near) same_[i] = &*earlier++;
  }
}

void Regions::make_pairs(std::span<const ContactPair> pairs, const RowMoves& rows, bool is_again,
                         ParallelKernels& kernels) {
  blocked_.reset();
  earlier_.swap(pairs_);
  earlier_extents_.swap(extents_);
  displaced_m_ = rows.displaced_m;
  extents_.resize(rows.radii.size());
  for (std::size_t row = 0; row < extents_.size(); ++row) {
    extents_[row] = {glm::length(vec(rows.positions[row])), glm::length(vec(rows.moves[row])) + rows.radii[row]};
  }
  find_same(is_again ? pairs : pairs.first(0), std::min(rows.cloth_count, earlier_extents_.size()));
  pairs_.resize(pairs.size());
  kernels.split(0, pairs.size(), ParallelKernels::least_pairs, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      pairs_[i] = is_again && same_[i] != nullptr ? *same_[i] : pair_of(pairs[i], rows);
    }
  });
  std::erase_if(pairs_, [&](const Pair& pair) {
    if (!pair.is_told_apart) note_blocked(pair.contact.near, 0.0F);
    return !pair.is_told_apart;
  });
  note_kinematic_gap(rows.inverse_masses_per_kg);
}

// A vertex that begins within a body has no gap to lose.
void Regions::note_kinematic_gap(std::span<const float> inverse_masses) {
  kinematic_gap_m_ = infinity;
  for (const Pair& pair : pairs_) {
    const auto& r = pair.contact.near.rows;
    const auto is_kinematic = [&](Index row) { return !(inverse_masses[row] > 0.0F); };
    if (pair.distance > pair.error && std::any_of(r.begin(), r.end(), is_kinematic)) {
      kinematic_gap_m_ = std::min(kinematic_gap_m_, pair.needed - pair.error);
    }
  }
}

void Regions::set_heights(const std::array<glm::vec3, 4>& p, Pair& pair) {
  for (Index k = 0; k < 4; ++k) pair.heights[k] = glm::dot(pair.normal, p[k] - p[0]);
  pair.distance = span_of(pair.contact.near, pair.heights).apart();
}

void Regions::note_blocked(const NearPair& near, float distance) {
  if (!blocked_) blocked_ = {near, distance};
}

Regions::Span Regions::span_of(const NearPair& near, const std::array<float, 4>& heights) {
  Span span = {infinity, -infinity};
  for (Index k = 0; k < 4; ++k) {
    if (k < near.first_count) {
      span.low = std::min(span.low, heights[k]);
    } else {
      span.high = std::max(span.high, heights[k]);
    }
  }
  return span;
}

Regions::Span Regions::span_at_end(const Pair& pair) const {
  std::array<float, 4> heights = pair.heights;
  for (Index k = 0; k < 4; ++k) heights[k] += glm::dot(pair.normal, vec(moves_[pair.contact.near.rows[k]]));
  return span_of(pair.contact.near, heights);
}

// Projects the moves onto those that leave a distance, corner by corner. As masses weigh them, momentum is kept and no
// energy is gained: a collision without rebound. Where it is urgent a heavy layer gives way as a light one does:
// it would take hundreds of passes by its mass.
void Regions::resolve(const Pair& pair, float left, bool is_urgent, std::span<const float> inverse_masses) {
  const NearPair& near = pair.contact.near;
  const auto mobility_of = [&](Index row) {
    const float mobility_per_kg = inverse_masses[row];
    return is_urgent && mobility_per_kg > 0.0F ? 1.0F : mobility_per_kg;
  };
  const float relaxation = is_urgent ? tuning::over_projected : 1.0F;
  for (Index k = 0; k < near.first_count; ++k) {
    for (Index l = near.first_count; l < 4; ++l) {
      Float4& first = moves_[near.rows[k]];
      Float4& second = moves_[near.rows[l]];
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

// A pass hands a push on by about one layer. Rows that are held in a pile stop what closes in on it, so that passes go
// on as long as any would be: for no more than what is needed, so that what is squeezed has room to give, and
// over-relaxed, which hands pushes on sooner.
void Regions::resolve_moves(std::span<const float> inverse_masses) {
  constexpr int most_passes = tuning::most_rounds * tuning::most_rounds;
  bool is_done = false;
  bool would_hold = true;
  for (int pass = 0; !is_done && (pass < tuning::most_rounds || (would_hold && pass < most_passes)); ++pass) {
    is_done = true;
    would_hold = false;
    const bool is_urgent = pass >= tuning::most_rounds;
    for (const Pair& pair : pairs_) {
      const float enough = tuning::enough_part * pair.contact.thickness_m;
      const float left = is_urgent ? std::min(pair.needed + enough, pair.wanted) : pair.wanted;
      const float apart = span_at_end(pair).apart();
      if (apart < left - enough) {
        would_hold = would_hold || apart < pair.needed;
        resolve(pair, left, is_urgent, inverse_masses);
        is_done = false;
      }
    }
  }
}

// Nothing crosses where all move alike, or nothing moves. Each round holds rows for good, so that the rounds
// end.
void Regions::hold_where_needed(const RowMoves& rows) {
  held_.assign(rows.radii.size(), Held::no);
  bool has_changed = true;
  while (has_changed) {
    has_changed = false;
    for (const Pair& pair : pairs_) {
      if (span_at_end(pair).apart() >= pair.needed) continue;
      if (hold(pair.contact.near, Held::carried, rows) || hold(pair.contact.near, Held::still, rows)) {
        has_changed = true;
      } else {
        note_blocked(pair.contact.near, pair.distance);
      }
    }
  }
}

// Returns whether any of them was free to be.
bool Regions::hold(const NearPair& near, Held how, const RowMoves& rows) {
  bool has_changed = false;
  for (const Index row : near.rows) {
    if (rows.inverse_masses_per_kg[row] > 0.0F && held_[row] < how) {
      held_[row] = how;
      moves_[row] = how == Held::carried ? rows.carried : Float4{};
      has_changed = true;
    }
  }
  return has_changed;
}

// Rows that contact moves out of their balls go as far as these let them, where that keeps all apart.
bool Regions::fit_radii(RowMoves& rows) {
  deviations_.resize(rows.radii.size());
  is_cut_short_.assign(rows.radii.size(), 0);
  bool are_all_within = true;
  for (std::size_t row = 0; row < rows.radii.size(); ++row) {
    const glm::vec3 deviation = vec(moves_[row]) - vec(rows.moves[row]);
    const float length = deviations_[row] = glm::length(deviation);
    const float most = tuning::filled_part_of_ball * rows.radii[row];
    if (rows.inverse_masses_per_kg[row] > 0.0F && !(length <= most)) {
      moves_[row] = rows.moves[row];
      add(moves_[row], most / length * deviation);
      is_cut_short_[row] = 1;
      are_all_within = false;
    }
  }
  return are_all_within || !needs_larger_balls(rows);
}

bool Regions::needs_larger_balls(RowMoves& rows) const {
  bool needs = false;
  for (const Pair& pair : pairs_) {
    const auto& r = pair.contact.near.rows;
    const auto is_within = [&](Index row) { return is_cut_short_[row] == 0; };
    if (std::all_of(r.begin(), r.end(), is_within) || span_at_end(pair).apart() >= pair.needed) continue;
    for (const Index row : r) {
      if (!is_within(row)) {
        rows.radii[row] = std::max(rows.radii[row], tuning::larger * deviations_[row]);
        needs = true;
      }
    }
  }
  return needs;
}

void Regions::place_half_spaces() {
  half_space_begin_.assign(radii_.size() + 1, 0);
  for (const Pair& pair : pairs_) {
    for (const Index row : pair.contact.near.rows) ++half_space_begin_[row + 1];
  }
  std::partial_sum(half_space_begin_.begin(), half_space_begin_.end(), half_space_begin_.begin());
  half_spaces_.resize(half_space_begin_.back());
  std::vector<Index> next(half_space_begin_.begin(), half_space_begin_.end() - 1);
  for (Pair& pair : pairs_) {
    for (Index k = 0; k < 4; ++k) pair.half_spaces[k] = next[pair.contact.near.rows[k]]++;
  }
}

void Regions::set_half_spaces(const Pair& pair, std::span<const float> inverse_masses) {
  const NearPair& near = pair.contact.near;
  std::array<float, 2> masses_kg = {0.0F, 0.0F};
  for (Index k = 0; k < 4; ++k) {
    const std::size_t side = k < near.first_count ? 0 : 1;
    masses_kg[side] += 1.0F / inverse_masses[near.rows[k]];  // infinite for what cannot be moved
  }
  const bool is_second_fixed = std::isinf(masses_kg[1]);
  const bool is_first_fixed = std::isinf(masses_kg[0]);
  // The first gets this share of the room between the two.
  const float share = is_first_fixed == is_second_fixed ? 0.5F : (is_first_fixed ? 0.0F : 1.0F);
  // Where the plane of the one or the other thing is, so that what is needed is left between the two.
  const auto plane = [&](const Span& span, bool is_first) {
    const float room = std::max(span.apart() - pair.needed, 0.0F);
    return is_first ? span.low - share * room : span.high + (1.0F - share) * room;
  };
  const Span begin = span_of(near, pair.heights);
  const Span end = span_at_end(pair);
  for (Index k = 0; k < 4; ++k) {
    const bool is_first = k < near.first_count;
    const float sign = is_first ? 1.0F : -1.0F;
    const float at_begin = sign * (plane(begin, is_first) - pair.heights[k]);
    const float at_end = sign * (plane(end, is_first) - pair.heights[k]);
    const float moved_up = sign * glm::dot(pair.normal, vec(moves_[near.rows[k]]));
    half_spaces_[pair.half_spaces[k]] = {sign * pair.normal, at_begin, at_end - at_begin,
                                         std::min(-at_begin, moved_up - at_end),
                                         is_first ? is_second_fixed : is_first_fixed};
  }
}

float Regions::room_of(Index row) const {
  float room = radii_[row] - std::min(deviations_[row], tuning::filled_part_of_ball * radii_[row]);
  for (const HalfSpace& half_space : half_spaces_of(row)) room = std::min(room, half_space.room);
  return room;
}

void Regions::make_half_spaces(std::span<const float> inverse_masses, ParallelKernels& kernels) {
  place_half_spaces();
  kernels.split(0, pairs_.size(), ParallelKernels::least_pairs, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) set_half_spaces(pairs_[i], inverse_masses);
  });
  kernels.for_rows(0, radii_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      moves_[row].fourth = inverse_masses[row] > 0.0F ? room_of(static_cast<Index>(row)) : infinity;
    }
  });
}

void Regions::stand_still(const RowMoves& rows) {
  moves_ = rows.moves;
  for (std::size_t row = 0; row < moves_.size(); ++row) {
    if (rows.inverse_masses_per_kg[row] > 0.0F) {
      moves_[row] = Float4{};
    } else {
      moves_[row].fourth = infinity;
    }
  }
  expected_ = moves_;
  radii_.assign(moves_.size(), 0.0F);
  half_space_begin_.assign(moves_.size() + 1, 0);
  half_spaces_.clear();
  touches_.clear();
}

bool Regions::make(std::span<const ContactPair> pairs, RowMoves& rows, ParallelKernels& kernels, bool is_again) {
  moves_ = rows.moves;
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
