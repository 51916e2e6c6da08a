#include "sim/solvers/bounded/contacts.hpp"

#include <ctime>

#include "sim/mesh/preconditions.hpp"
#include "sim/solvers/bounded/blocked_pairs.hpp"

namespace taut::sim::bounded {
namespace {

/// Smallest distance of neighbours in the cloth, as a fraction of their rest distance.
constexpr float rest_distance_fraction = 0.5F;

/// Fixed cost of a sweep, in triangles: measured 0.5 us, at 1.7 ns for a triangle.
constexpr double sweep_overhead = 300.0;

struct OutermostRow {
  std::size_t row = 0;
  float from_origin_m = 0.0F;  ///< including its motion; infinite if not a number
};

OutermostRow find_outermost_row(const RowMoves& rows) {
  OutermostRow outermost;
  for (std::size_t row = 0; row < rows.radii.size(); ++row) {
    const float far_m = vector_length(rows.positions[row]) + vector_length(rows.moves[row]) + rows.radii[row];
    if (!(far_m <= outermost.from_origin_m)) {
      outermost = {row, std::isnan(far_m) ? std::numeric_limits<float>::infinity() : far_m};
    }
  }
  return outermost;
}

}  // namespace

void Contacts::begin_attempt(const Frame& frame, const Layout& layout, const Motion& motion,
                             const ContactMemory& memory, const TimeSpan& time, int earlier_attempts, double max_work) {
  assert(time.from_s < time.to_s);
  assert(earlier_attempts >= 0);
  assert(!std::isnan(max_work));
  const std::vector<Body>& bodies = frame.surroundings.bodies;
  is_on_ = within_cloth_ || !bodies.empty();
  blocked_.reset();
  report_ = {};
  search_ms_ = pairs_made_ = 0.0;
  max_work_ = max_work;
  lets_cross_ = false;
  // Wrong regions stretch the cloth, and more time steps do not help.
  retry_level_ = 1.0 + earlier_attempts;
  from_s_ = until_s_ = time.from_s;
  frame_ends_s_ = time.to_s;
  start_displacements_.clear();
  prepare(frame.garment, layout, bodies);
  if (!is_on_) return;
  max_gravity_m_per_s2_ = static_cast<float>(max_gravity_m_per_s2(frame.surroundings.forces));
  memory_ = memory.rows;
  memory_.resize(layout.row_count());
  near_->forget();
  rows_.normals.assign(layout.row_count(), Float4{});
  add_normals(triangles_, motion.start.high, rows_.normals);
  bodies_of_frame_ = bodies;
  leave_out(memory, layout, motion, time.from_s);
}

// Crossings are searched for at the start, with new bodies and after an accepted crossing.
void Contacts::leave_out(const ContactMemory& memory, const Layout& layout, const Motion& motion, double time_s) {
  const bool goes_on = memory.bodies == bodies_of_frame_;
  std::vector<Index> find_group(contact_triangles_.size(), 0);
  for (const ExcludedTriangle& t : goes_on ? memory.excluded_triangles : std::vector<ExcludedTriangle>{}) {
    const auto near_pairs =
        std::lower_bound(contact_triangles_.begin(), contact_triangles_.end(), ExcludedTriangle{t.body, t.triangle});
    if (near_pairs != contact_triangles_.end() && near_pairs->body == t.body && near_pairs->triangle == t.triangle) {
      find_group[static_cast<std::size_t>(near_pairs - contact_triangles_.begin())] = t.group;
    }
  }
  excluded_.set_groups(std::move(find_group));
  const bool looks = !goes_on || memory.may_have_crossed;
  if (!looks && excluded_.empty()) return;
  std::vector<Vec3> positions_m = motion.start_m;
  positions_m.resize(layout.row_count());
  const std::vector<Vec3> bodies_m = bodies_.mesh_positions_m(time_s);
  positions_m.insert(positions_m.end(), bodies_m.begin(), bodies_m.end());
  if (looks) excluded_.add(positions_m);
  excluded_.free(positions_m);
}

std::vector<ExcludedTriangle> Contacts::left_out() const {
  std::vector<ExcludedTriangle> all;
  for (std::size_t t = 0; t < contact_triangles_.size(); ++t) {
    if (excluded_.groups()[t] > 0) {
      all.push_back(contact_triangles_[t]);
      all.back().group = excluded_.groups()[t];
    }
  }
  return all;
}

double Contacts::excluded_area_fraction() const {
  const std::vector<bool>& touch_at_rest = excluded_.touch_at_rest();
  if (excluded_.empty() && touch_at_rest.empty()) return 0.0;
  double all = 0.0, left_out = 0.0;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    all += areas_[t];
    left_out += excluded_.groups()[t] > 0 || (!touch_at_rest.empty() && touch_at_rest[t]) ? areas_[t] : 0.0;
  }
  return all > 0.0 ? left_out / all : 0.0;
}

void Contacts::prepare(const Garment& garment, const Layout& layout, const std::vector<Body>& bodies) {
  const bool is_needed = within_cloth_ || !bodies.empty();
  const bool is_known = near_ && bodies_.has_same_bodies(bodies);
  if (is_needed && !is_known) lay_out(garment, layout, bodies);
}

// A triangle without a surface cannot be crossed and has no normal.
void Contacts::lay_out(const Garment& garment, const Layout& layout, const std::vector<Body>& bodies) {
  const std::vector<Vec3>& at_rest_m = garment.untangled_m.empty() ? garment.mesh.positions : garment.untangled_m;
  std::vector<Vec3> positions_m(layout.row_count(), Vec3(0.0));
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    positions_m[row] = at_rest_m[layout.vertex_indices[row]];
  }
  triangles_.clear();
  contact_triangles_.clear();
  areas_.clear();
  for (std::size_t t = 0; t < garment.mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = garment.mesh.triangles[t];
    if (!within_cloth_ || garment.triangles_at_rest[t].has_surface()) {
      triangles_.push_back({layout.solver_indices[a], layout.solver_indices[b], layout.solver_indices[c]});
      contact_triangles_.push_back({{}, static_cast<Index>(t)});
      areas_.push_back(0.5 * glm::length(doubled_area_vector(garment.mesh.positions, garment.mesh.triangles[t])));
    }
  }
  add_loose_vertices(layout);
  measure_edges(garment.mesh, layout);
  rest_.resize(layout.row_count());
  std::transform(positions_m.begin(), positions_m.end(), rest_.begin(), to_float4);
  bodies_ = BodyContacts(bodies, garment.material.friction, static_cast<Index>(layout.row_count()));
  excluded_ = Crossings(triangles_, bodies_.mesh_triangles(), within_cloth_, positions_m);
  // Bodies enter as modelled, wherever they are: the order of pairs, and so the last bits, depends on it.
  for (const Body& body : bodies) {
    if (const auto* mesh = std::get_if<BodyMesh>(&body.shape)) {
      positions_m.insert(positions_m.end(), mesh->data->positions_m.begin(), mesh->data->positions_m.end());
      for (Index t = 0; t < mesh->data->triangles.size(); ++t) {
        contact_triangles_.push_back({static_cast<std::size_t>(&body - bodies.data()), t});
      }
    }
  }
  near_.emplace(make_contact_mesh(triangles_, bodies_.mesh_triangles()), within_cloth_, positions_m);
}

// Bodies also stop vertices without triangles.
void Contacts::add_loose_vertices(const Layout& layout) {
  std::vector<bool> is_corner(layout.vertex_count(), false);
  for (const Triangle& t : triangles_) {
    for (const Index row : t) is_corner[row] = true;
  }
  solid_ = triangles_;
  for (Index row = 0; row < layout.vertex_count(); ++row) {
    if (!is_corner[row]) solid_.push_back({row, row, row});
  }
}

void Contacts::measure_edges(const Mesh& mesh, const Layout& layout) {
  double sum_m = 0.0;
  std::vector<float> sums_m(layout.row_count(), 0.0F);
  std::vector<float> counts(layout.row_count(), 0.0F);
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double length_m = glm::distance(mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]]);
      sum_m += length_m / 3.0;
      for (const Index v : {t[k], t[(k + 1) % 3]}) {
        sums_m[layout.solver_indices[v]] += static_cast<float>(length_m);
        ++counts[layout.solver_indices[v]];
      }
    }
  }
  mean_edge_m_ = sum_m / static_cast<double>(std::max<std::size_t>(mesh.triangles.size(), 1));
  edges_m_.resize(layout.row_count());
  for (std::size_t row = 0; row < edges_m_.size(); ++row) {
    edges_m_[row] = counts[row] > 0.0F ? sums_m[row] / counts[row] : static_cast<float>(mean_edge_m_);
  }
}

float Contacts::slack_m(std::size_t row) const {
  return std::min(tuning::slack_per_mean_edge * static_cast<float>(mean_edge_m_),
                  tuning::slack_per_local_edge * edges_m_[row]);
}

ContactMemory Contacts::memory() const {
  return is_on_ ? ContactMemory{memory_, blocked_.has_value(), bodies_of_frame_, left_out()} : ContactMemory{};
}

double Contacts::work() const {
  if (!is_on_) return 0.0;
  const LastingPairs::Searches& searches = near_->searches();
  const double of_mesh = pairs_made_ / (static_cast<double>(triangles_.size()) + sweep_overhead);
  return tuning::search_work_sweeps * (searches.all + 0.5 * searches.marked + of_mesh);
}

ContactReport Contacts::report() {
  if (is_on_) {
    const LastingPairs::Searches searches = near_->take_searches();
    report_.detections = searches.all;
    report_.partial_detections = searches.marked;
    report_.excluded_area_fraction = excluded_area_fraction();
  }
  return report_;
}

void Contacts::observe(const Layout& layout, const Motion& motion, double time_s) {
  if (!start_displacements_.empty()) {
    memory_.observe(layout.vertex_count(), start_displacements_, motion.current, time_s - from_s_,
                    max_gravity_m_per_s2_);
  }
}

double Contacts::suitable_end_s(double time_s, double time_step_s, double frame_end_s) const {
  assert(time_step_s > 0.0);
  assert(time_s <= frame_end_s);
  double max_interval_s =
      std::min(frame_end_s - time_s, tuning::region_travel_per_edge / retry_level_ * mean_edge_m_ /
                                         std::max(memory_.relative_speed_m_per_s(triangles_), 1e-9));
  if (memory_.is_touching) max_interval_s = std::min(max_interval_s, 1.0 / tuning::touching_regions_per_s);
  const double steps_left = std::max(std::round((frame_end_s - time_s) / time_step_s), 1.0);
  const double times_left = std::ceil((frame_end_s - time_s) / std::max(max_interval_s, time_step_s) - 1e-3);
  const double steps = std::ceil(steps_left / std::max(times_left, 1.0) - 1e-3);
  return time_s + steps * time_step_s;
}

// Starts from the current positions, without predicted motion.
void Contacts::begin_rows(const Layout& layout, const Motion& motion, const Float4Array& displacements) {
  start_displacements_ = displacements;
  const std::size_t count = layout.row_count();
  rows_.positions.resize(count);
  rows_.moves.assign(count, Float4{});
  rows_.kinematic_motion = {};
  rows_.cloth_count = count;
  rows_.radii.assign(count, 0.0F);
  rows_.inverse_masses_per_kg = layout.inverse_masses_per_kg;
  float squared_m = 0.0F;
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    rows_.positions[row] = scaled_sum(motion.start.high[row], start_displacements_[row], 1.0F);
    squared_m = std::max(squared_m, dot(start_displacements_[row], start_displacements_[row]));
  }
  rows_.displaced_m = std::sqrt(squared_m);
}

// Moves predictions towards the bound: vertices that are pulled along do not continue their old motion.
void Contacts::expect_within_bound(const Layout& layout, ParallelKernels& kernels) {
  expected_ends_.resize(start_displacements_.size());
  for (std::size_t row = 0; row < start_displacements_.size(); ++row) {
    expected_ends_[row] = scaled_sum(start_displacements_[row], rows_.moves[row], 1.0F);
  }
  shorten_roughly(layout, max_stretch_, kernels, expected_ends_);
  for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
    rows_.moves[row] = scaled_sum(expected_ends_[row], start_displacements_[row], -1.0F);
  }
}

bool Contacts::make_regions(const Frame& frame, const Layout& layout, const Motion& motion, const Float4* accelerations,
                            std::span<const Vec3> pins_moved_m, double off_chord_m, const TimeSpan& time,
                            bool may_be_shorter, ParallelKernels& kernels) {
  assert(off_chord_m >= 0.0);
  assert(time.from_s < time.to_s);
  begin_rows(layout, motion, motion.current);
  const auto lasts_s = static_cast<float>(time.to_s - time.from_s);
  const auto before_s = static_cast<float>(std::min(memory_.elapsed_s, time.to_s - time.from_s));
  for (std::size_t row = 0; row < layout.pin_count; ++row) {
    rows_.moves[row] = scaled_sum(to_float4(pins_moved_m[row]), start_displacements_[row], -1.0F);
    add_scaled(rows_.kinematic_motion, rows_.moves[row], 1.0F / static_cast<float>(layout.pin_count));
  }
  for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
    Float4& move = rows_.moves[row] = multiply(memory_.velocities[row], lasts_s);
    // The velocity is that at the middle of the last observation.
    add_scaled(move, memory_.accelerations[row], 0.5F * lasts_s * (lasts_s + before_s));
    // Forces press layers together, but the cloth undoes most of that motion.
    const Float4 pressed = multiply(accelerations[row], 0.5F * lasts_s * lasts_s);
    move = scaled_sum(move, limit_length(slack_m(row), pressed), 1.0F);
  }
  expect_within_bound(layout, kernels);
  for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
    rows_.radii[row] =
        std::min(slack_m(row) + tuning::slack_per_motion * vector_length(rows_.moves[row]), max_slack_m());
  }
  from_s_ = time.from_s;
  until_s_ = time.to_s;
  off_chord_m_ = off_chord_m;
  return find_regions(frame, layout, motion, time, may_be_shorter, kernels);
}

void Contacts::make_regions(const Frame& frame, const Layout& layout, const Motion& motion,
                            const Float4Array& displacements, const Float4Array& expected, double time_s,
                            ParallelKernels& kernels) {
  begin_rows(layout, motion, displacements);
  for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
    rows_.moves[row] = expected[row];
    rows_.radii[row] = correction_slack_m(row) + tuning::slack_per_motion * vector_length(expected[row]);
  }
  find_regions(frame, layout, motion, {time_s, time_s}, false, kernels);
}

std::span<const NearPair> Contacts::find_near(const TimeSpan& time, float thickness_m, float error_m,
                                              ParallelKernels& kernels) {
  reaches_.resize(rows_.radii.size());
  std::transform(rows_.radii.begin(), rows_.radii.end(), reaches_.begin(),
                 [&](float radius_m) { return Regions::reach_m(radius_m, thickness_m, error_m); });
  const std::clock_t began = std::clock();
  const std::span<const NearPair> near_pairs = near_->find({rows_.positions, rows_.moves, reaches_, time},
                                                           frame_ends_s_, static_cast<float>(mean_edge_m_), kernels);
  search_ms_ += 1e3 * static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  return near_pairs;
}

// The thickness is 0 for pairs that are not kept apart. Neighbours nearer at rest than the thickness are not pushed
// apart for that, and parts that touch at rest, as along unsewn seams, are not kept apart.
void Contacts::make_contact_pairs(std::span<const NearPair> near_pairs, const Material& material, float thickness_m,
                                  std::size_t begin, std::size_t end, const ContactKernels& kernels) {
  const auto take = [&](PairBatches::Batch& batch) {
    const auto measure = batch.first_count == 1 ? kernels.measure_triangle_distances : kernels.measure_edge_distances;
    measure(rest_.data(), batch.block);
    for (std::size_t i = 0; i < batch.count; ++i) {
      const float kept_m = std::min(thickness_m, rest_distance_fraction * batch.block.distance[i]);
      const float min_m = 0.5F * static_cast<float>(min_rest_distance_m);
      pairs_[batch.index[i]].thickness_m = kept_m < min_m ? 0.0F : kept_m;
    }
  };
  PairBatches batches;
  for (std::size_t i = begin; i < end; ++i) {
    const NearPair& near = near_pairs[i];
    const Index first = near.rows.front();
    const Index second = near.rows.back();
    if (excluded_.has(near)) {
      pairs_[i] = {near};
    } else if (bodies_.has(first) || bodies_.has(second)) {
      pairs_[i] = {near, thickness_m, bodies_.friction_at_row(bodies_.has(first) ? first : second)};
    } else {
      pairs_[i] = {near, thickness_m, static_cast<float>(material.friction)};
      batches.add(near, i, thickness_m, take);
    }
  }
  batches.end(take);
}

void Contacts::collect_pairs(const Material& material, float thickness_m, std::span<const NearPair> near_pairs,
                             const TimeSpan& time, const Vec3& origin_m, ParallelKernels& kernels) {
  pairs_.resize(near_pairs.size());
  kernels.split(0, near_pairs.size(), ParallelKernels::min_pairs, [&](std::size_t begin, std::size_t end) {
    make_contact_pairs(near_pairs, material, thickness_m, begin, end, kernels.contact());
  });
  std::erase_if(pairs_, [](const ContactPair& pair) { return pair.thickness_m == 0.0F; });
  bodies_.add_near(solid_, thickness_m, time, origin_m, rows_, pairs_);
}

bool Contacts::find_regions(const Frame& frame, const Layout& layout, const Motion& motion, const TimeSpan& time,
                            bool may_be_shorter, ParallelKernels& kernels) {
  if (lets_cross_) {
    confine_nothing(kernels);
    return true;
  }
  const Vec3 origin_m = motion.start_m.front();
  bodies_.add_mesh_rows(time, origin_m, rows_);
  const std::size_t lasting_rows = rows_.radii.size();
  for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
    rows_.radii[row] = std::max(rows_.radii[row], memory_.deviations[row] / tuning::ball_fill_fraction);
  }
  // Largest distance at which pairs can be found; a diverging frame may exceed it.
  constexpr float max_findable_m = 1e9F;
  const OutermostRow outermost = find_outermost_row(rows_);
  if (!(outermost.from_origin_m < max_findable_m)) {
    confine_nothing(kernels);
    blocked_ = blocked_.value_or(blocked_contact({layout, bodies_, rows_, {}, origin_m}, outermost.row));
    return true;
  }
  const float error_m = distance_error_m({outermost.from_origin_m, 0.0F, outermost.from_origin_m, rows_.displaced_m});
  assert(frame.garment.material.thickness_m >= min_thickness_m);
  const auto thickness_m = static_cast<float>(frame.garment.material.thickness_m);
  const int max_searches = may_be_shorter ? tuning::max_searches_before_halving : tuning::max_searches;
  bool fits = false;
  for (int search = 0; search < max_searches && !fits; ++search) {
    frame.ask();
    rows_.positions.resize(lasting_rows);
    rows_.moves.resize(lasting_rows);
    rows_.radii.resize(lasting_rows);
    rows_.inverse_masses_per_kg.resize(lasting_rows);
    collect_pairs(frame.garment.material, thickness_m, find_near(time, thickness_m, error_m, kernels), time, origin_m,
                  kernels);
    fits = regions_.make(pairs_, rows_, kernels, search > 0);
    pairs_made_ += static_cast<double>(pairs_.size());
    if (!fits && may_be_shorter && (search + 1 == max_searches || are_many_large())) return false;
  }
  memory_.is_touching = regions_.pair_count() > 0;
  report_.max_pairs = std::max(report_.max_pairs, static_cast<int>(regions_.pair_count()));
  note_blocked(layout, origin_m, fits);
  for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
    memory_.deviations[row] = regions_.deviation(row);
  }
  return true;
}

// Trust regions much larger than at first find pairs by the hundred thousand.
bool Contacts::are_many_large() const {
  const auto count =
      std::count_if(rows_.radii.begin(), rows_.radii.end(), [&](float radius_m) { return radius_m > max_slack_m(); });
  return static_cast<double>(count) > tuning::max_large_ball_fraction * static_cast<double>(rows_.cloth_count);
}

void Contacts::confine_nothing(ParallelKernels& kernels) {
  std::fill(rows_.radii.begin(), rows_.radii.end(), std::numeric_limits<float>::infinity());
  regions_.make({}, rows_, kernels);
}

void Contacts::let_cross(const Layout& layout, const Motion& motion, ParallelKernels& kernels) {
  give_up(layout, motion);
  lets_cross_ = true;
  until_s_ = frame_ends_s_;
  confine_nothing(kernels);
}

void Contacts::give_up(const Layout& layout, const Motion& motion) {
  note_blocked(layout, motion.start_m.front(), false);
}

void Contacts::note_blocked(const Layout& layout, const Vec3& origin_m, bool fits) {
  if (!blocked_ && (!fits || regions_.blocked())) {
    blocked_ = blocked_contact({layout, bodies_, rows_, pairs_, origin_m}, regions_);
  }
}

void Contacts::keep_apart(const Layout& layout, double time_s, double time_step_s, ParallelKernels& kernels,
                          Motion& motion) {
  assert(time_step_s > 0.0);
  const double lasts_s = until_s_ - from_s_;
  const auto time = static_cast<float>((time_s - from_s_) / lasts_s);
  const auto step = static_cast<float>(time_step_s / lasts_s);
  const float stopped_m =
      tuning::max_stopped_gravities * max_gravity_m_per_s2_ * static_cast<float>(time_step_s * time_step_s);
  kept_time_ = time;
  regions_.collide(time, step, start_displacements_, motion.previous, motion.current);
  const std::span<const ClampedRow> held_back = regions_.project_into_region(
      time, {step, stopped_m}, start_displacements_, motion.previous, motion.current, kernels);
  const double max_fraction = tuning::max_clamped_fraction / (retry_level_ * retry_level_);
  if (static_cast<double>(held_back.size()) > max_fraction * static_cast<double>(layout.vertex_count())) {
    release_clamped(held_back, motion);
    // Planes follow chords, not the true paths of kinematic primitives, before their end time.
    until_s_ = 2.0 * off_chord_m_ <= regions_.kinematic_gap_m() ? time_s : until_s_;
  }
}

// A few clamped vertices only tremble. If many are clamped, the prediction was wrong; a trust region is no obstacle, so
// they keep their velocity.
void Contacts::release_clamped(std::span<const ClampedRow> held_back, Motion& motion) {
  for (const ClampedRow& held : held_back) add(motion.previous[held.row], -held.out);
}

bool Contacts::allow(Index row, const Vec3& displacement_m) const {
  return !is_on_ || regions_.contains(row, kept_time_, displacement_m - to_vec3(start_displacements_[row]));
}

// A single clamped vertex can prevent the bound here.
bool Contacts::keep_apart(ParallelKernels& kernels, Float4Array& displacements) {
  kept_time_ = 1.0F;
  return regions_.project_into_region(start_displacements_, displacements, kernels) > 0;
}

}  // namespace taut::sim::bounded
