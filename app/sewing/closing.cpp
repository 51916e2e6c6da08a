#include "app/sewing/closing.hpp"

#include "app/base/errors.hpp"
#include "app/bodies/wearing.hpp"
#include "app/fitting/following.hpp"
#include "app/output/frame_record.hpp"
#include "app/verify/stretch.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

using sim::Index;
using sim::Vec2;
using sim::Vec3;

// Threads.
constexpr double pull_m_per_s2 = 15.0;     ///< of all threads of a panel, over its mass
constexpr double inwards_m_per_s2 = 10.0;  ///< of layers that are sewn, to the body
constexpr double inwards_from_m = 0.05;    ///< nearer to it they are pulled less
constexpr double slack_m = 0.001;          ///< nearer than this they pull less
constexpr double stronger = 1.4;           ///< times as strong, as often as hardly anything could be joined
constexpr double weaker = 0.5;             ///< times as strong, after a frame that cannot be made
constexpr int most_blocked = 8;            ///< such frames
constexpr double quick_enough = 0.05;      ///< of what is open
constexpr double most_strength = 30.0;
constexpr double drag_per_s = 10.0;   ///< of the air meanwhile
constexpr double thickest_m = 3e-4;   ///< cloth counts as no thicker until it is sewn, so that borders meet
constexpr double softest_n_m = 2e-6;  ///< cloth resists no more to being bent meanwhile
constexpr double near_enough = 0.1;   ///< of the length of edges: vertices that are nearer become one
constexpr double further = 1.3;       ///< times as near, as often as the strongest pull joins nothing
constexpr double furthest = 0.35;
constexpr int frames_between_joins = 4;
constexpr double in_the_way_m = 0.03;          ///< the body, of a gap that stays
constexpr int most_frames_between_joins = 16;  ///< after some that failed
constexpr int first_join = 12;
constexpr int most_frames_for_first = 60;
/// Time steps that may be made for a layer, on average. To begin a simulation anew takes as long as a few.
constexpr int most_steps = 4000;
constexpr int steps_to_begin = 20;
/// Nothing closes any more if for so many frames nothing was joined and the widest gap shrank by less than a
/// share.
constexpr int patience = 120;
constexpr double progress = 0.9;
constexpr double lifted = 0.7;  ///< of the distance of what has met
constexpr int frames_to_part = 5;
constexpr std::size_t most_trials = 6;  ///< of joining, each without what crossed in the one before

std::vector<Index> sets_of(sim::Groups groups, std::size_t count) {
  std::vector<Index> sets(count);
  for (Index v = 0; v < count; ++v) sets[v] = groups.find(v);
  return sets;
}

/// Per corner of the triangles that are left: u to the right and v up as the pieces are cut, in m.
std::vector<glm::vec2> upright(const std::vector<std::array<Vec2, 3>>& cut_m) {
  std::vector<glm::vec2> corners;
  for (const auto& triangle : cut_m) corners.insert(corners.end(), triangle.begin(), triangle.end());
  return corners;
}

/// A place of a vertex that is near only to those which it is near to in its own panel: panels lie in
/// different levels, each a bowl, so that what joins two of its borders leaves it at an angle.
Vec3 place_apart_m(const CutPieces& pieces, Index v) {
  constexpr double between_levels_m = 3.0, curvature_per_m = 2.0;
  const Vec2 flat_m = pieces.flat_m[v];
  const Vec2 from_m = flat_m - pieces.flat_m[pieces.triangles[pieces.panel_triangles[pieces.panel_of[v]]][0]];
  return {flat_m.x, flat_m.y, between_levels_m * pieces.panel_of[v] + 0.5 * curvature_per_m * glm::dot(from_m, from_m)};
}

/// The pieces of which those vertices are one that are in one set, with these positions per vertex of the
/// pieces.
SewnPieces join_pieces(const CutPieces& pieces, const std::vector<Index>& set_of, const std::vector<Vec3>& positions_m,
                       const Scene& scene) {
  SewnPieces sewn;
  std::vector<Index> number(set_of.size(), sim::no_vertex);
  sewn.vertex_of.resize(set_of.size());
  std::vector<double> counts;
  sim::Mesh mesh;
  std::vector<Vec3> apart_m;
  for (Index v = 0; v < set_of.size(); ++v) {
    Index& n = number[set_of[v]];
    if (n == sim::no_vertex) {
      n = static_cast<Index>(counts.size());
      counts.push_back(0.0);
      mesh.positions.emplace_back(0.0);
      apart_m.push_back(place_apart_m(pieces, v));
    }
    sewn.vertex_of[v] = n;
    counts[n] += 1.0;
    mesh.positions[n] += positions_m[v];
  }
  for (std::size_t n = 0; n < counts.size(); ++n) mesh.positions[n] /= counts[n];
  for (const auto& [a, b, c] : pieces.triangles) {
    mesh.triangles.push_back({sewn.vertex_of[a], sewn.vertex_of[b], sewn.vertex_of[c]});
    mesh.cut_m.push_back({pieces.flat_m[a], pieces.flat_m[b], pieces.flat_m[c]});
  }
  sewn.garment = sim::make_garment(std::move(mesh), scene.mapping, scene.material);
  // How near parts of the cloth may come does not go by how near they are now.
  sewn.garment.parted_m = std::move(apart_m);
  sewn.garment.warps = sim::warps_of(sewn.garment.mesh, upright(sewn.garment.mesh.cut_m));
  return sewn;
}

bool accept_all(const SurfacePoint&) { return true; }

class Closing {
 public:
  Closing(const CutPieces& pieces, const Scene& scene, const sim::Body& dressed, double time_s)
      : pieces_(pieces),
        scene_(scene),
        time_s_(time_s),
        body_tree_(mesh_positions_m(dressed, time_s), std::get<sim::BodyMesh>(dressed.shape).data->triangles),
        joined_(pieces.flat_m.size()) {
    scene_.material.thickness_m = std::min(scene_.material.thickness_m, thickest_m);
    // Laws of threads matter when cloth carries something.
    scene_.material.tensile_warp_n_per_m = scene_.material.tensile_weft_n_per_m = scene_.material.shear_n_per_m = 0.0;
    scene_.material.friction = 0.0;
    // Ease is pushed together.
    scene_.material.compression_stiffness_n_per_m = 0.0;
    scene_.material.bending_rigidity_n_m = std::min(scene_.material.bending_rigidity_n_m, softest_n_m);
    sim::ExternalForces& forces = scene_.surroundings.forces;
    forces.gravity_m_per_s2 = Vec3(0.0);
    forces.gravity_path.clear();
    forces.wind = {};
    forces.wind.speed_m_per_s = 0.0;
    forces.air_drag_per_s = drag_per_s;
    for (sim::Body& body : scene_.surroundings.bodies) body.friction = 0.0;
    begin(join_pieces(pieces, sets_of(joined_, pieces.flat_m.size()), pieces.placed_m, scene_));
    panel_masses_kg_.assign(pieces.panel_count(), 0.0);
    for (std::size_t v = 0; v < pieces.flat_m.size(); ++v) {
      panel_masses_kg_[pieces.panel_of[v]] += sewn_.garment.masses_kg[sewn_.vertex_of[v]];
    }
  }

  SewnPieces run(const SewingReport& report) {
    double widest_m = std::numeric_limits<double>::infinity();
    int since = 0, blocked = 0;
    const int budget = most_steps * static_cast<int>(pieces_.layer_of.back() + 1);
    if (report) report(share_joined(), sewn_.garment, now_m());
    int next_join = first_join, between_joins = frames_between_joins;
    for (int frame = 1; steps_ <= budget && since < patience && !is_closed(); ++frame, ++since) {
      throw_if_interrupted();
      const std::vector<std::size_t> seams = pulled_seams(frame);
      pull(seams);
      if (!advance()) {
        // From rest, and pulled less, it may go on.
        if (++blocked > most_blocked) break;
        strength_ *= weaker;
        keep_shape();
        begin(std::move(sewn_));
        continue;
      }
      if (frame >= next_join) {
        const double before = share_joined();
        const bool any_joined = join_what_met(seams);
        since = any_joined ? 0 : since;
        between_joins = any_joined ? frames_between_joins : std::min(2 * between_joins, most_frames_between_joins);
        next_join = frame + between_joins;
        if (share_joined() - before < quick_enough * (1.0 - before)) {
          // Cloth that a strong pull has crumpled comes loose in a weak one.
          const bool is_strongest = strength_ * stronger > most_strength;
          strength_ = is_strongest ? 1.0 : stronger * strength_;
          reach_m_ = std::min(furthest * pieces_.edge_m, (is_strongest ? further : 1.0) * reach_m_);
        }
      }
      const double gap_m = find_gap();
      if (gap_m < progress * widest_m) {
        widest_m = gap_m;
        since = 0;
      }
      if (report) report(share_joined(), sewn_.garment, now_m());
    }
    if (find_gap() > 0.0 && sewn_.reason.empty()) {
      const auto nearest = body_tree_.nearest(sewn_.gap_place_m, in_the_way_m, accept_all);
      const double off_m = nearest ? glm::distance(nearest->place_m, sewn_.gap_place_m) : 0.0;
      if (nearest) sewn_.reason = fmt::format("the body is in the way, {:.1f} cm from there", 100.0 * off_m);
    }
    keep_shape();
    return std::move(sewn_);
  }

 private:
  const std::vector<Vec3>& now_m() const { return simulation_->state().current; }
  const Vec3& at(Index v) const { return now_m()[sewn_.vertex_of[v]]; }

  void begin(SewnPieces sewn) {
    sewn_ = std::move(sewn);
    const std::vector<Vec3> start_m = sewn_.garment.mesh.positions;
    sim::Surroundings surroundings = scene_.surroundings;
    surroundings.moving_pins.clear();
    simulation_.emplace(sim::share(sewn_.garment), std::vector<Index>{}, simulation_settings(scene_.simulation),
                        std::move(surroundings), start_m);
    simulation_->set_time(time_s_);
    steps_ += steps_to_begin;
  }

  void keep_shape() { sewn_.garment.mesh.positions = now_m(); }

  /// Makes a frame. Returns whether it can be made.
  bool advance() {
    try {
      simulation_->advance_frame(throw_if_interrupted);
      steps_ += simulation_->last_report().substeps;
      sewn_.reason.clear();
    } catch (const sim::ContactBlocked& error) {
      sewn_.reason = error.what();
      return false;
    }
    return true;
  }

  bool is_joined(const std::pair<Index, Index>& pair) { return joined_.find(pair.first) == joined_.find(pair.second); }
  bool is_closed(const Seam& seam) {
    return std::ranges::all_of(seam, [&](const auto& pair) { return is_joined(pair); });
  }
  bool is_closed() {
    return std::ranges::all_of(pieces_.seams, [&](const Seam& seam) { return is_closed(seam); });
  }

  double share_joined() {
    std::size_t all = 0, joined = 0;
    for (const Seam& seam : pieces_.seams) {
      all += seam.size();
      for (const auto& pair : seam) joined += is_joined(pair) ? 1 : 0;
    }
    return static_cast<double>(joined) / static_cast<double>(std::max<std::size_t>(all, 1));
  }

  double find_gap() {
    sewn_.gap_m = 0.0;
    for (std::size_t s = 0; s < pieces_.seams.size(); ++s) {
      for (const auto& [a, b] : pieces_.seams[s]) {
        const double gap_m = joined_.find(a) == joined_.find(b) ? 0.0 : glm::distance(at(a), at(b));
        if (gap_m > sewn_.gap_m) {
          sewn_.gap_m = gap_m;
          sewn_.open_stitch = s;
          sewn_.gap_place_m = 0.5 * (at(a) + at(b));
        }
      }
    }
    return sewn_.gap_m;
  }

  std::size_t layer_of(std::size_t seam) const {
    return pieces_.layer_of[pieces_.panel_of[pieces_.seams[seam][0].first]];
  }

  /// Returns whether all of these seams are closed that belong to the layer that is sewn.
  bool is_layer_closed(const std::vector<std::size_t>& seams) {
    return std::ranges::all_of(seams,
                               [&](std::size_t s) { return layer_of(s) != layer_ || is_closed(pieces_.seams[s]); });
  }

  /// The seams that are pulled: those of the innermost layer that is open, at first those that carry it.
  std::vector<std::size_t> pulled_seams(int frame) {
    std::vector<std::size_t> all(pieces_.seams.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    while (layer_ < pieces_.layer_of.back() && is_layer_closed(all)) {
      ++layer_;
      layer_began_ = frame;
      strength_ = 1.0;
    }
    is_carried_ = frame - layer_began_ >= most_frames_for_first || is_layer_closed(pieces_.first_seams);
    std::vector<std::size_t> seams = is_carried_ ? all : pieces_.first_seams;
    std::erase_if(seams, [&](std::size_t s) { return layer_of(s) != layer_; });
    return seams;
  }

  /// Pulls what is sewn to each other to its middle. The threads of a panel pull with the same force.
  void pull(const std::vector<std::size_t>& seams) {
    sim::Groups together(now_m().size());
    for (const std::size_t s : seams) {
      for (const auto& [a, b] : pieces_.seams[s]) {
        const Index v = sewn_.vertex_of[a], w = sewn_.vertex_of[b];
        together.join(v, w);
      }
    }
    std::vector<Vec3> sums(now_m().size(), Vec3(0.0));
    std::vector<double> counts(now_m().size(), 0.0), threads(pieces_.panel_count(), 0.0);
    for (Index v = 0; v < now_m().size(); ++v) {
      const Index group = together.find(v);
      sums[group] += now_m()[v];
      counts[group] += 1.0;
    }
    if (!is_carried_) {
      // Panels tilt as their shoulders are drawn together, which brings these down: beside the body, not over it.
      std::vector<double> highest_m(now_m().size(), -std::numeric_limits<double>::infinity());
      for (std::size_t v = 0; v < pieces_.flat_m.size(); ++v) {
        double& height_m = highest_m[together.find(sewn_.vertex_of[v])];
        height_m = std::max(height_m, pieces_.placed_m[v].y);
      }
      for (std::size_t g = 0; g < sums.size(); ++g) sums[g].y = counts[g] > 1.0 ? counts[g] * highest_m[g] : sums[g].y;
    }
    const auto is_pulled = [&](Index v) { return counts[together.find(v)] > 1.0; };
    for (std::size_t v = 0; v < pieces_.flat_m.size(); ++v) {
      threads[pieces_.panel_of[v]] += is_pulled(sewn_.vertex_of[v]) ? 1.0 : 0.0;
    }
    // Forces within a group add up to nothing, so that threads move nothing as a whole.
    std::vector<double> pulls_n(now_m().size(), 0.0), reaches_m(now_m().size(), slack_m);
    for (std::size_t v = 0; v < pieces_.flat_m.size(); ++v) {
      const Index p = pieces_.panel_of[v], group = together.find(sewn_.vertex_of[v]);
      pulls_n[group] +=
          counts[group] > 1.0 ? strength_ * pull_m_per_s2 * panel_masses_kg_[p] / threads[p] / counts[group] : 0.0;
    }
    for (Index v = 0; v < now_m().size(); ++v) {
      const Index group = together.find(v);
      reaches_m[group] = std::max(reaches_m[group], glm::distance(now_m()[v], sums[group] / counts[group]));
    }
    sim::Surroundings surroundings = simulation_->surroundings();
    surroundings.forces.held_vertices.clear();
    for (Index v = 0; v < now_m().size(); ++v) {
      if (is_pulled(v)) {
        const Index group = together.find(v);
        surroundings.forces.held_vertices.push_back(
            {v, sums[group] / counts[group], pulls_n[group] / reaches_m[group], 2.0 * pulls_n[group]});
      }
    }
    draw_in_layers(surroundings.forces.held_vertices);
    simulation_->set_surroundings(surroundings);
  }

  /// Draws layers that are sewn to the body, where they are in the way of none that are sewn over them.
  void draw_in_layers(std::vector<sim::HeldVertex>& held) const {
    if (layer_ == 0) return;
    std::vector<char> is_done(now_m().size(), 0);
    for (Index v = 0; v < pieces_.flat_m.size(); ++v) {
      const Index n = sewn_.vertex_of[v];
      if (pieces_.layer_of[pieces_.panel_of[v]] < layer_ && std::exchange(is_done[n], 1) == 0) {
        const auto nearest = body_tree_.nearest(at(v), std::numeric_limits<double>::infinity(), accept_all);
        const double pull_n = inwards_m_per_s2 * sewn_.garment.masses_kg[n];
        held.push_back({n, nearest->place_m, pull_n / inwards_from_m, pull_n});
      }
    }
  }

  /// Per vertex of the pieces, where it is. Pairs that have met over an inner layer are also tried out of the cloth
  /// and beyond its border: the middle between both sides of a fold of that layer is within it.
  std::vector<std::vector<Vec3>> places_to_join_m(const std::vector<std::pair<Index, Index>>& met) const {
    std::vector<Vec3> positions_m, out(pieces_.flat_m.size(), Vec3(0.0)), beyond = out;
    for (Index v = 0; v < pieces_.flat_m.size(); ++v) positions_m.push_back(at(v));
    for (const sim::Triangle& t : pieces_.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 first = at(t[(k + 1) % 3]) - at(t[k]), second = at(t[(k + 2) % 3]) - at(t[k]);
        out[t[k]] += glm::cross(first, second);
        beyond[t[k]] -= first + second;
      }
    }
    std::vector<std::vector<Vec3>> places_m = {positions_m};
    for (const auto& ways : {out, beyond}) {
      std::vector<Vec3> moved_m = positions_m;
      for (const auto& [a, b] : met) {
        const auto unit = [&](const Vec3& d) { return glm::length(d) > 0.0 ? glm::normalize(d) : d; };
        const Vec3 lift = lifted * glm::distance(at(a), at(b)) * unit(unit(ways[a]) + unit(ways[b]));
        moved_m[a] = at(a) + lift;
        moved_m[b] = at(b) + lift;
      }
      if (layer_ > 0) places_m.push_back(std::move(moved_m));
    }
    return places_m;
  }

  /// Makes one vertex of those that have come together. Returns whether any have.
  bool join_what_met(const std::vector<std::size_t>& seams) {
    std::vector<std::pair<Index, Index>> met;
    for (const std::size_t s : seams) {
      for (const auto& [a, b] : pieces_.seams[s]) {
        if (joined_.find(a) != joined_.find(b) && glm::distance(at(a), at(b)) < reach_m_) met.emplace_back(a, b);
      }
    }
    const std::vector<std::vector<Vec3>> places_m = places_to_join_m(met);
    const std::vector<Vec3> before_m = now_m();
    const SewnPieces before = sewn_;
    for (std::size_t trial = 0; trial < most_trials * places_m.size() && !met.empty(); ++trial) {
      sim::Groups joined = joined_;
      for (const auto& [a, b] : met) joined.join(a, b);
      begin(join_pieces(pieces_, sets_of(joined, pieces_.flat_m.size()), places_m[trial % places_m.size()], scene_));
      std::vector<char> is_crossed = crossed_after_frames(seams);
      const auto touches = [&](const auto& pair) { return is_crossed[sewn_.vertex_of[pair.first]] != 0; };
      if (std::ranges::find(is_crossed, 1) == is_crossed.end() && is_within_bound()) {
        joined_ = joined;
        return true;
      }
      if (trial % places_m.size() + 1 < places_m.size()) continue;
      if (std::ranges::all_of(met, touches) || std::erase_if(met, touches) == 0) leave_out_nearest(is_crossed, met);
    }
    sewn_ = before;
    sewn_.garment.mesh.positions = before_m;
    begin(sewn_);
    return false;
  }

  /// Makes frames until nothing is too near for the solver to tell it apart, or something crosses. Returns
  /// crossed().
  std::vector<char> crossed_after_frames(const std::vector<std::size_t>& seams) {
    std::vector<char> is_crossed(now_m().size(), 1);
    for (int frame = 0; frame < frames_to_part; ++frame) {
      pull(seams);
      if (!advance()) break;
      is_crossed = crossed();
      if (simulation_->last_report().left_out.empty()) break;
    }
    return is_crossed;
  }

  /// Leaves out that half of the pairs which is nearest to what crosses.
  void leave_out_nearest(const std::vector<char>& is_crossed, std::vector<std::pair<Index, Index>>& met) const {
    std::vector<std::pair<double, std::pair<Index, Index>>> by_distance;
    for (const auto& pair : met) {
      double nearest_m = std::numeric_limits<double>::infinity();
      for (std::size_t v = 0; v < is_crossed.size(); ++v) {
        nearest_m = is_crossed[v] != 0 ? std::min(nearest_m, glm::distance(now_m()[v], at(pair.first))) : nearest_m;
      }
      by_distance.emplace_back(-nearest_m, pair);
    }
    std::ranges::sort(by_distance);
    met.clear();
    for (std::size_t k = 0; k < by_distance.size() / 2; ++k) met.push_back(by_distance[k].second);
  }

  bool is_within_bound() const {
    return largest_stretch(sewn_.garment.mesh, now_m()).surface <=
           scene_.simulation.solver.bounded.max_stretch + bound_rounding;
  }

  /// Per vertex, whether it is near triangles that cross something.
  std::vector<char> crossed() const {
    const Surface cloth = {now_m(), sewn_.garment.mesh.triangles};
    std::vector<char> is_crossed(now_m().size(), 0);
    const auto mark = [&](Index t) {
      for (const Index v : cloth.triangles[t]) is_crossed[v] = 1;
    };
    bool any = false;
    for (const SceneCrossings& crossings : scene_crossings(cloth, scene_.surroundings.bodies, time_s_)) {
      for (const CrossingPair& pair : crossings.pairs) {
        mark(pair.first);
        if (!crossings.body) mark(pair.second);
        any = true;
      }
    }
    // Triangles that are too near for the solver to tell them apart.
    for (const sim::LeftOutTriangle& t : simulation_->last_report().left_out) {
      if (!t.body) {
        mark(t.triangle);
        any = true;
      }
    }
    for (int ring = 0; ring < 2 && any; ++ring) {
      const std::vector<char> before = is_crossed;
      for (Index t = 0; t < cloth.triangles.size(); ++t) {
        if (std::ranges::any_of(cloth.triangles[t], [&](Index v) { return before[v] != 0; })) mark(t);
      }
    }
    return is_crossed;
  }

  const CutPieces& pieces_;
  Scene scene_;
  double time_s_;
  SurfaceTree body_tree_;
  sim::Groups joined_;  ///< vertices of the pieces that are one
  std::vector<double> panel_masses_kg_;
  double strength_ = 1.0;                          ///< of all threads
  double reach_m_ = near_enough * pieces_.edge_m;  ///< vertices that are nearer become one
  int steps_ = 0;                                  ///< that were made
  std::size_t layer_ = 0;                          ///< that is sewn
  bool is_carried_ = false;                        ///< by the seams that do so: all are pulled
  int layer_began_ = 0;                            ///< in this frame
  SewnPieces sewn_;
  std::optional<sim::Simulation> simulation_;
};

}  // namespace

SewnPieces close_seams(const CutPieces& pieces, const Scene& scene, double time_s, const SewingReport& report) {
  const sim::Body& dressed = scene.surroundings.bodies[dressed_body(scene).body];
  return Closing(pieces, scene, dressed, time_s).run(report);
}

}  // namespace taut::app
