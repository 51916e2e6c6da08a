#include "sim/solvers/bounded/contacts.hpp"

#include <ctime>

namespace taut::sim::bounded {
namespace {

/// One search of what is near, as it is after it.
struct Searched {
  const Layout& layout;
  const BodyContacts& bodies;
  const RowMoves& rows;
  std::span<const ContactPair> pairs;
  Vec3 origin_m;  ///< of the rows' positions
};

using Side = std::span<const Index>;

std::array<Side, 2> sides_of(const NearPair& near) {
  const Side rows(near.rows);
  return {rows.first(near.first_count), rows.subspan(near.first_count)};
}

ContactSide named(const Searched& searched, Side rows) {
  ContactSide side;
  for (const Index row : rows) {
    if (searched.bodies.has(row)) {
      side.body = searched.bodies.body_of(row);
    } else {
      side.vertices.push_back(searched.layout.vertex_of_row[row]);
    }
  }
  std::sort(side.vertices.begin(), side.vertices.end());
  side.vertices.erase(std::unique(side.vertices.begin(), side.vertices.end()), side.vertices.end());
  return side;
}

bool is_led(const Searched& searched, Side rows) {
  return std::all_of(rows.begin(), rows.end(),
                     [&](Index row) { return !(searched.rows.inverse_masses_per_kg[row] > 0.0F); });
}

bool share_free_row(const Searched& searched, Side one, Side other) {
  return std::any_of(one.begin(), one.end(), [&](Index row) {
    return searched.rows.inverse_masses_per_kg[row] > 0.0F && std::find(other.begin(), other.end(), row) != other.end();
  });
}

/// Returns the pins or the body on the other side of the cloth that is closed in on.
std::optional<ContactSide> behind(const Searched& searched, const NearPair& blocked,
                                  const std::array<ContactSide, 2>& known) {
  for (const ContactPair& pair : searched.pairs) {
    const std::array<Side, 2> sides = sides_of(pair.near);
    for (std::size_t k = 0; k < 2; ++k) {
      if (is_led(searched, sides[k]) && share_free_row(searched, blocked.rows, sides[1 - k])) {
        ContactSide side = named(searched, sides[k]);
        if (std::find(known.begin(), known.end(), side) == known.end()) return side;
      }
    }
  }
  return std::nullopt;
}

Vec3 place_between(const Searched& searched, const NearPair& near) {
  std::array<glm::vec3, 4> p{};
  for (std::size_t k = 0; k < 4; ++k) p[k] = vec(searched.rows.positions[near.rows[k]]);
  const ClosestWeights weights = closest_weights(near, p);
  glm::vec3 place(0.0F);
  for (std::size_t k = 0; k < 4; ++k) place += 0.5F * weights[k] * p[k];
  return searched.origin_m + Vec3(place);
}

BlockedContact of_pair(const Searched& searched, const BlockedPair& pair) {
  BlockedContact blocked;
  const std::array<Side, 2> sides = sides_of(pair.near);
  blocked.sides = {named(searched, sides[0]), named(searched, sides[1])};
  if (is_led(searched, sides[0]) != is_led(searched, sides[1])) {
    blocked.behind = behind(searched, pair.near, blocked.sides);
  }
  blocked.place_m = place_between(searched, pair.near);
  blocked.distance_m = pair.distance;
  return blocked;
}

/// Returns what is blocked of a row of the cloth that is further away than can be searched.
BlockedContact blocked_contact(const Searched& searched, std::size_t row) {
  const auto index = static_cast<Index>(row);
  BlockedContact blocked;
  blocked.sides[0] = named(searched, std::span(&index, 1));
  blocked.place_m = searched.origin_m + Vec3(vec(searched.rows.positions[row]));
  return blocked;
}

/// Returns what is blocked in the regions that were made of the search, by vertices and bodies instead of
/// rows: a pair, or else the row of the cloth that contact moved furthest from where it was expected.
BlockedContact blocked_contact(const Searched& searched, const Regions& regions) {
  if (regions.blocked()) return of_pair(searched, *regions.blocked());
  std::size_t furthest = searched.layout.pin_count;
  for (std::size_t row = furthest; row < searched.layout.vertex_count(); ++row) {
    if (regions.deviation(row) > regions.deviation(furthest)) furthest = row;
  }
  return blocked_contact(searched, furthest);
}

/// Neighbours in the cloth may come as near as this part of their distance at rest: contact's law.
constexpr float rest_part = 0.5F;

/// Beside its triangles a sweep costs as much as so many of them: measured, 0.5 us at 1.7 ns for a triangle.
constexpr double sweep_overhead = 300.0;

struct FurthestRow {
  std::size_t row = 0;
  float from_origin_m = 0.0F;  ///< with all of its way; infinite where that is not a number
};

FurthestRow furthest_row(const RowMoves& rows) {
  FurthestRow furthest;
  for (std::size_t row = 0; row < rows.radii.size(); ++row) {
    const float far_m = length_of(rows.positions[row]) + length_of(rows.moves[row]) + rows.radii[row];
    if (!(far_m <= furthest.from_origin_m)) {
      furthest = {row, std::isnan(far_m) ? std::numeric_limits<float>::infinity() : far_m};
    }
  }
  return furthest;
}

}  // namespace

void Contacts::begin_attempt(const Frame& frame, const Layout& layout, const Motion& motion,
                             const ContactMemory& memory, const TimeSpan& time, int earlier_attempts,
                             double most_work) {
  const std::vector<Body>& bodies = frame.surroundings.bodies;
  is_on_ = within_cloth_ || !bodies.empty();
  blocked_.reset();
  report_ = {};
  search_ms_ = pairs_made_ = 0.0;
  most_work_ = most_work;
  lets_cross_ = false;
  // Regions that are wrong stretch the cloth, and more time steps do not help.
  caution_ = 1.0 + earlier_attempts;
  from_s_ = until_s_ = time.from_s;
  frame_ends_s_ = time.to_s;
  since_.clear();
  if (!is_on_) return;
  const bool is_known = near_ && bodies_.are(bodies);
  if (!is_known) lay_out(frame.garment, layout, bodies);
  largest_gravity_m_per_s2_ = static_cast<float>(largest_gravity_m_per_s2(frame.surroundings.forces));
  memory_ = memory.rows;
  memory_.resize(layout.row_count());
  near_->forget();
  rows_.normals.assign(layout.row_count(), Float4{});
  add_normals(triangles_, motion.start.high, rows_.normals);
  bodies_of_frame_ = bodies;
  leave_out(memory, layout, motion, time.from_s);
}

// Crossings are looked for when the cloth begins, when bodies come, and after a crossing was accepted.
void Contacts::leave_out(const ContactMemory& memory, const Layout& layout, const Motion& motion, double time_s) {
  const bool goes_on = memory.bodies == bodies_of_frame_;
  std::vector<Index> group_of(triangle_of_.size(), 0);
  for (const LeftOutTriangle& t : goes_on ? memory.left_out : std::vector<LeftOutTriangle>{}) {
    const auto found = std::lower_bound(triangle_of_.begin(), triangle_of_.end(), LeftOutTriangle{t.body, t.triangle});
    if (found != triangle_of_.end() && found->body == t.body && found->triangle == t.triangle) {
      group_of[static_cast<std::size_t>(found - triangle_of_.begin())] = t.group;
    }
  }
  left_out_.set_groups(std::move(group_of));
  const bool looks = !goes_on || memory.may_have_crossed;
  if (!looks && left_out_.empty()) return;
  std::vector<Vec3> positions_m = motion.start_m;
  positions_m.resize(layout.row_count());
  const std::vector<Vec3> bodies_m = bodies_.mesh_positions_m(time_s);
  positions_m.insert(positions_m.end(), bodies_m.begin(), bodies_m.end());
  if (looks) left_out_.add(positions_m);
  left_out_.free(positions_m);
}

std::vector<LeftOutTriangle> Contacts::left_out() const {
  std::vector<LeftOutTriangle> all;
  for (std::size_t t = 0; t < triangle_of_.size(); ++t) {
    if (left_out_.groups()[t] > 0) {
      all.push_back(triangle_of_[t]);
      all.back().group = left_out_.groups()[t];
    }
  }
  return all;
}

double Contacts::left_out_share() const {
  const std::vector<bool>& touch_at_rest = left_out_.touch_at_rest();
  if (left_out_.empty() && touch_at_rest.empty()) return 0.0;
  double all = 0.0, left_out = 0.0;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    all += areas_[t];
    left_out += left_out_.groups()[t] > 0 || (!touch_at_rest.empty() && touch_at_rest[t]) ? areas_[t] : 0.0;
  }
  return all > 0.0 ? left_out / all : 0.0;
}

// A triangle without a surface has nothing to cross, and faces any way.
void Contacts::lay_out(const Garment& garment, const Layout& layout, const std::vector<Body>& bodies) {
  const std::vector<Vec3>& at_rest_m = garment.parted_m.empty() ? garment.mesh.positions : garment.parted_m;
  std::vector<Vec3> positions_m(layout.row_count(), Vec3(0.0));
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    positions_m[row] = at_rest_m[layout.vertex_of_row[row]];
  }
  triangles_.clear();
  triangle_of_.clear();
  areas_.clear();
  for (std::size_t t = 0; t < garment.mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = garment.mesh.triangles[t];
    if (!within_cloth_ || garment.triangles_at_rest[t].has_surface()) {
      triangles_.push_back({layout.row_of_vertex[a], layout.row_of_vertex[b], layout.row_of_vertex[c]});
      triangle_of_.push_back({{}, static_cast<Index>(t)});
      areas_.push_back(0.5 * glm::length(doubled_area_vector(garment.mesh.positions, garment.mesh.triangles[t])));
    }
  }
  add_loose_vertices(layout);
  measure_edges(garment.mesh, layout);
  rest_.resize(layout.row_count());
  std::transform(positions_m.begin(), positions_m.end(), rest_.begin(), float4_of);
  bodies_ = BodyContacts(bodies, garment.material.friction, static_cast<Index>(layout.row_count()));
  left_out_ = Crossings(triangles_, bodies_.mesh_triangles(), within_cloth_, positions_m);
  // As they were modelled, wherever they are: the order in which pairs are found hangs on it, and the last
  // bits.
  for (const Body& body : bodies) {
    if (const auto* mesh = std::get_if<BodyMesh>(&body.shape)) {
      positions_m.insert(positions_m.end(), mesh->data->positions_m.begin(), mesh->data->positions_m.end());
      for (Index t = 0; t < mesh->data->triangles.size(); ++t) {
        triangle_of_.push_back({static_cast<std::size_t>(&body - bodies.data()), t});
      }
    }
  }
  near_.emplace(make_contact_mesh(triangles_, bodies_.mesh_triangles()), within_cloth_, positions_m);
}

// Bodies are also in the way of vertices without triangles.
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
  longest_edge_m_ = 0.0F;
  std::vector<float> sums_m(layout.row_count(), 0.0F);
  std::vector<float> counts(layout.row_count(), 0.0F);
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double length_m = glm::distance(mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]]);
      sum_m += length_m / 3.0;
      longest_edge_m_ = std::max(longest_edge_m_, static_cast<float>(length_m));
      for (const Index v : {t[k], t[(k + 1) % 3]}) {
        sums_m[layout.row_of_vertex[v]] += static_cast<float>(length_m);
        ++counts[layout.row_of_vertex[v]];
      }
    }
  }
  mean_edge_m_ = sum_m / static_cast<double>(std::max<std::size_t>(mesh.triangles.size(), 1));
  edges_m_.resize(layout.row_count());
  for (std::size_t row = 0; row < edges_m_.size(); ++row) {
    edges_m_[row] = counts[row] > 0.0F ? sums_m[row] / counts[row] : static_cast<float>(mean_edge_m_);
  }
}

float Contacts::room_of(std::size_t row) const {
  return std::min(tuning::room_per_edge * static_cast<float>(mean_edge_m_), tuning::room_per_edge_here * edges_m_[row]);
}

ContactMemory Contacts::memory() const {
  return is_on_ ? ContactMemory{memory_, blocked_.has_value(), bodies_of_frame_, left_out()} : ContactMemory{};
}

double Contacts::work() const {
  if (!is_on_) return 0.0;
  const LastingPairs::Searches& searches = near_->searches();
  const double of_mesh = pairs_made_ / (static_cast<double>(triangles_.size()) + sweep_overhead);
  return tuning::work_of_search * (searches.all + 0.5 * searches.marked + of_mesh);
}

ContactReport Contacts::report() {
  if (is_on_) {
    const LastingPairs::Searches searches = near_->take_searches();
    report_.detections = searches.all;
    report_.partial_detections = searches.marked;
    report_.left_out_share = left_out_share();
  }
  return report_;
}

void Contacts::observe(const Layout& layout, const Motion& motion, double time_s) {
  if (!since_.empty()) {
    memory_.observe(layout.vertex_count(), since_, motion.current, time_s - from_s_, largest_gravity_m_per_s2_);
  }
}

double Contacts::suitable_end_s(double time_s, double time_step_s, double frame_end_s) const {
  double longest_s = std::min(frame_end_s - time_s, tuning::turned_part_of_edge / caution_ * mean_edge_m_ /
                                                        std::max(memory_.relative_speed_m_per_s(triangles_), 1e-9));
  if (memory_.is_touching) longest_s = std::min(longest_s, 1.0 / tuning::touching_regions_per_s);
  const double steps_left = std::max(std::round((frame_end_s - time_s) / time_step_s), 1.0);
  const double times_left = std::ceil((frame_end_s - time_s) / std::max(longest_s, time_step_s) - 1e-3);
  const double steps = std::ceil(steps_left / std::max(times_left, 1.0) - 1e-3);
  return time_s + steps * time_step_s;
}

// From where the rows are now; nothing is expected of them yet.
void Contacts::begin_rows(const Layout& layout, const Motion& motion, const Float4Array& displacements) {
  since_ = displacements;
  const std::size_t count = layout.row_count();
  rows_.positions.resize(count);
  rows_.moves.assign(count, Float4{});
  rows_.carried = {};
  rows_.cloth_count = count;
  rows_.radii.assign(count, 0.0F);
  rows_.inverse_masses_per_kg = layout.inverse_masses_per_kg;
  float squared_m = 0.0F;
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    rows_.positions[row] = scaled_sum(motion.start.high[row], since_[row], 1.0F);
    squared_m = std::max(squared_m, dot(since_[row], since_[row]));
  }
  rows_.displaced_m = std::sqrt(squared_m);
}

// Vertices go where triangles let them: those that are pulled along do not go on as they did.
void Contacts::expect_within_bound(const Layout& layout, ParallelKernels& kernels) {
  expected_ends_.resize(since_.size());
  for (std::size_t row = 0; row < since_.size(); ++row) {
    expected_ends_[row] = scaled_sum(since_[row], rows_.moves[row], 1.0F);
  }
  shorten_roughly(layout, max_stretch_, kernels, expected_ends_);
  for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
    rows_.moves[row] = scaled_sum(expected_ends_[row], since_[row], -1.0F);
  }
}

bool Contacts::make_regions(const Frame& frame, const Layout& layout, const Motion& motion, const Float4* accelerations,
                            std::span<const Vec3> pins_moved_m, double off_chord_m, const TimeSpan& time,
                            bool may_be_shorter, ParallelKernels& kernels) {
  begin_rows(layout, motion, motion.current);
  const auto lasts_s = static_cast<float>(time.to_s - time.from_s);
  const auto before_s = static_cast<float>(std::min(memory_.elapsed_s, time.to_s - time.from_s));
  for (std::size_t row = 0; row < layout.pin_count; ++row) {
    rows_.moves[row] = scaled_sum(float4_of(pins_moved_m[row]), since_[row], -1.0F);
    add_scaled(rows_.carried, rows_.moves[row], 1.0F / static_cast<float>(layout.pin_count));
  }
  for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
    Float4& move = rows_.moves[row] = times(memory_.velocities[row], lasts_s);
    // The velocity is that of the middle of the last time.
    add_scaled(move, memory_.accelerations[row], 0.5F * lasts_s * (lasts_s + before_s));
    // Forces press layers together; the cloth itself undoes most of that.
    const Float4 pressed = times(accelerations[row], 0.5F * lasts_s * lasts_s);
    move = scaled_sum(move, no_longer_than(room_of(row), pressed), 1.0F);
  }
  expect_within_bound(layout, kernels);
  for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
    rows_.radii[row] = std::min(room_of(row) + tuning::room_per_move * length_of(rows_.moves[row]), most_room_m());
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
    rows_.radii[row] = correction_room_of(row) + tuning::room_per_move * length_of(expected[row]);
  }
  find_regions(frame, layout, motion, {time_s, time_s}, false, kernels);
}

// Cloth whose parts are nearer at rest than it is thick is not torn apart for that.
float Contacts::thickness_of(const NearPair& near, float thickness_m) const {
  std::array<glm::vec3, 4> p{};
  for (std::size_t k = 0; k < 4; ++k) p[k] = vec(rest_[near.rows[k]]);
  if (glm::distance(p[0], p[3]) > 2.0F * (longest_edge_m_ + thickness_m)) return thickness_m;
  return std::min(thickness_m, rest_part * distance_between(near, p));
}

std::span<const NearPair> Contacts::find_near(const TimeSpan& time, float thickness_m, float error_m,
                                              ParallelKernels& kernels) {
  reaches_.resize(rows_.radii.size());
  std::transform(rows_.radii.begin(), rows_.radii.end(), reaches_.begin(),
                 [&](float radius_m) { return Regions::reach_m(radius_m, thickness_m, error_m); });
  const std::clock_t began = std::clock();
  const std::span<const NearPair> found = near_->find({rows_.positions, rows_.moves, reaches_, time}, frame_ends_s_,
                                                      static_cast<float>(mean_edge_m_), kernels);
  search_ms_ += 1e3 * static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  return found;
}

// Of pairs that are not kept apart the thickness is 0.
ContactPair Contacts::contact_of(const NearPair& near, const Material& material, float thickness_m) const {
  if (left_out_.has(near)) return {near};
  const Index first = near.rows.front();
  const Index second = near.rows.back();
  if (bodies_.has(first) || bodies_.has(second)) {
    return {near, thickness_m, bodies_.friction_of(bodies_.has(first) ? first : second)};
  }
  const float kept_m = thickness_of(near, thickness_m);
  // Parts that touch at rest, as along seams that are not sewn, are not kept apart.
  return {near, kept_m < 0.5F * static_cast<float>(least_at_rest_m) ? 0.0F : kept_m,
          static_cast<float>(material.friction)};
}

void Contacts::collect_pairs(const Material& material, float thickness_m, std::span<const NearPair> found,
                             const TimeSpan& time, const Vec3& origin_m, ParallelKernels& kernels) {
  pairs_.resize(found.size());
  kernels.split(0, found.size(), ParallelKernels::least_pairs, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) pairs_[i] = contact_of(found[i], material, thickness_m);
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
    rows_.radii[row] = std::max(rows_.radii[row], memory_.deviations[row] / tuning::filled_part_of_ball);
  }
  // Further away, as in a frame that flies apart, nothing can be found.
  constexpr float furthest_findable_m = 1e9F;
  const FurthestRow furthest = furthest_row(rows_);
  if (!(furthest.from_origin_m < furthest_findable_m)) {
    confine_nothing(kernels);
    blocked_ = blocked_.value_or(blocked_contact({layout, bodies_, rows_, {}, origin_m}, furthest.row));
    return true;
  }
  const float error_m = distance_error_m({furthest.from_origin_m, 0.0F, furthest.from_origin_m, rows_.displaced_m});
  assert(frame.garment.material.thickness_m >= least_thickness_m);
  const auto thickness_m = static_cast<float>(frame.garment.material.thickness_m);
  const int most_searches = may_be_shorter ? tuning::most_rounds / 4 : tuning::most_rounds;
  bool fits = false;
  for (int search = 0; search < most_searches && !fits; ++search) {
    frame.ask();
    rows_.positions.resize(lasting_rows);
    rows_.moves.resize(lasting_rows);
    rows_.radii.resize(lasting_rows);
    rows_.inverse_masses_per_kg.resize(lasting_rows);
    collect_pairs(frame.garment.material, thickness_m, find_near(time, thickness_m, error_m, kernels), time, origin_m,
                  kernels);
    fits = regions_.make(pairs_, rows_, kernels, search > 0);
    pairs_made_ += static_cast<double>(pairs_.size());
    if (!fits && may_be_shorter && (search + 1 == most_searches || are_many_large())) return false;
  }
  memory_.is_touching = regions_.pair_count() > 0;
  report_.most_pairs = std::max(report_.most_pairs, static_cast<int>(regions_.pair_count()));
  note_blocked(layout, origin_m, fits);
  for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
    memory_.deviations[row] = regions_.deviation(row);
  }
  return true;
}

// Balls much larger than those that they begin with find pairs by the hundred thousand.
bool Contacts::are_many_large() const {
  const auto count =
      std::count_if(rows_.radii.begin(), rows_.radii.end(), [&](float radius_m) { return radius_m > most_room_m(); });
  return static_cast<double>(count) > tuning::few / 3.0 * static_cast<double>(rows_.cloth_count);
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
  const double lasts_s = until_s_ - from_s_;
  const auto time = static_cast<float>((time_s - from_s_) / lasts_s);
  const auto step = static_cast<float>(time_step_s / lasts_s);
  kept_at_ = time;
  regions_.collide(time, step, since_, motion.previous, motion.current);
  const std::span<const HeldBack> held_back =
      regions_.bring_back(time, since_, motion.previous, motion.current, kernels);
  const double most_held_back = tuning::few / (caution_ * caution_);
  if (static_cast<double>(held_back.size()) > most_held_back * static_cast<double>(layout.vertex_count())) {
    let_go(held_back, motion);
    // Before their end planes are where chords are, and not where kinematic things are.
    until_s_ = 2.0 * off_chord_m_ <= regions_.kinematic_gap_m() ? time_s : until_s_;
  }
}

// If there are few, it is their trembling that balls hold back. Where there are many, something else was to be
// expected, and a ball is nothing to bump into: they are late, and as fast as they were.
void Contacts::let_go(std::span<const HeldBack> held_back, Motion& motion) {
  for (const HeldBack& held : held_back) add(motion.previous[held.row], -held.out);
}

bool Contacts::allow(Index row, const Vec3& displacement_m) const {
  return !is_on_ || regions_.contains(row, kept_at_, displacement_m - vector_of(since_[row]));
}

// Here a single row that is held back keeps the bound from being reached.
bool Contacts::keep_apart(ParallelKernels& kernels, Float4Array& displacements) {
  kept_at_ = 1.0F;
  return regions_.bring_back(since_, displacements, kernels) > 0;
}

}  // namespace taut::sim::bounded
