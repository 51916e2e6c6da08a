#include "app/garments/sewing/closing.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/garments/dressing/wearing.hpp"
#include "app/garments/fitting/following.hpp"
#include "app/garments/sewing/tuning.hpp"
#include "app/runs/frame_record.hpp"
#include "app/runs/run_checkpoint.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

using sim::Index;
using sim::Vec2;
using sim::Vec3;
using namespace sewing;

/// Returns, per corner of the triangles, u to the right and v up as the pieces are cut, in m.
std::vector<glm::vec2> upright(const std::vector<std::array<Vec2, 3>>& cut_m) {
  std::vector<glm::vec2> corners;
  for (const auto& triangle : cut_m) corners.insert(corners.end(), triangle.begin(), triangle.end());
  return corners;
}

/// Returns a position of a vertex at which it is near its neighbours in its own panel alone. Panels lie in different
/// levels, each a bowl, so that an edge that joins two borders leaves the panel at an angle.
Vec3 place_apart_m(const CutPieces& pieces, Index v) {
  constexpr double between_levels_m = 3.0, curvature_per_m = 2.0;
  const Vec2 flat_m = pieces.flat_m[v];
  const Vec2 from_m = flat_m - pieces.flat_m[pieces.triangles[pieces.panel_triangles[pieces.panel_of[v]]][0]];
  return {flat_m.x, flat_m.y, between_levels_m * pieces.panel_of[v] + 0.5 * curvature_per_m * glm::dot(from_m, from_m)};
}

/// Merges the vertices of each set. `positions_m` are the positions of the vertices of the pieces.
SewnPieces join_pieces(const CutPieces& pieces, sim::Groups joined, const std::vector<Vec3>& positions_m,
                       const Scene& scene) {
  SewnPieces sewn;
  std::vector<double> counts;
  sim::Mesh mesh;
  std::vector<Vec3> apart_m;
  for (Index v = 0; v < positions_m.size(); ++v) {
    // A set is named by its first vertex.
    if (joined.find(v) == v) {
      sewn.vertex_of.push_back(static_cast<Index>(counts.size()));
      counts.push_back(0.0);
      mesh.positions.emplace_back(0.0);
      apart_m.push_back(place_apart_m(pieces, v));
    } else {
      sewn.vertex_of.push_back(sewn.vertex_of[joined.find(v)]);
    }
    counts[sewn.vertex_of[v]] += 1.0;
    mesh.positions[sewn.vertex_of[v]] += positions_m[v];
  }
  for (std::size_t n = 0; n < counts.size(); ++n) mesh.positions[n] /= counts[n];
  for (const auto& [a, b, c] : pieces.triangles) {
    mesh.triangles.push_back({sewn.vertex_of[a], sewn.vertex_of[b], sewn.vertex_of[c]});
    mesh.cut_m.push_back({pieces.flat_m[a], pieces.flat_m[b], pieces.flat_m[c]});
  }
  sewn.garment = sim::make_garment(std::move(mesh), scene.mapping, scene.material);
  // The smallest distances within the cloth do not depend on its present distances.
  sewn.garment.untangled_m = std::move(apart_m);
  sewn.garment.warps = sim::warps_from_coordinates(sewn.garment.mesh, upright(sewn.garment.mesh.cut_m));
  return sewn;
}

/// Vertices that threads draw together.
struct Knot {
  Vec3 sum_m = Vec3(0.0);  ///< sum of their positions
  double count = 0.0;
  double top_m = -std::numeric_limits<double>::infinity();  ///< height of the highest one as placed
  double pull_n = 0.0, reach_m = slack_m;

  Vec3 middle_m() const { return sum_m / count; }
};

/// Returns a tree of the dressed body; an empty one if there is none.
SurfaceTree tree_of_dressed(const LoadedBodies& bodies, double time_s) {
  const Dressed dressed = dressed_body(bodies);
  if (dressed.wearer == nullptr) return {{}, {}};
  const sim::Body& body = bodies.all[dressed.body];
  return {mesh_positions_m(body, time_s), std::get<sim::BodyMesh>(body.shape).data->triangles};
}

class Closing {
 public:
  Closing(const CutPieces& pieces, const Scene& scene, const LoadedBodies& bodies, double time_s)
      : pieces_(pieces),
        scene_(scene),
        bodies_(bodies.all),
        time_s_(time_s),
        body_tree_(tree_of_dressed(bodies, time_s)),
        joined_(pieces.flat_m.size()) {
    scene_.material.thickness_m = std::min(scene_.material.thickness_m, thickest_m);
    // Stiffness of threads matters only when cloth carries a load.
    scene_.material.tensile_warp_n_per_m = scene_.material.tensile_weft_n_per_m = scene_.material.shear_n_per_m = 0.0;
    scene_.material.friction = 0.0;
    // Ease is pushed together.
    scene_.material.compression_stiffness_n_per_m = 0.0;
    scene_.material.bending_rigidity_n_m = std::min(scene_.material.bending_rigidity_n_m, max_bending_rigidity_n_m);
    sim::ExternalForces& forces = scene_.surroundings.forces;
    forces.wind = {};
    forces = without_gravity_and_wind(std::move(forces));
    forces.air_drag_per_s = closing_drag_per_s;
    for (sim::Body& body : bodies_) body.friction = 0.0;
    begin(join_pieces(pieces, joined_, pieces.placed_m, scene_));
    panel_masses_kg_.assign(pieces.panel_count(), 0.0);
    for (std::size_t v = 0; v < pieces.flat_m.size(); ++v) {
      panel_masses_kg_[pieces.panel_of[v]] += sewn_.garment.masses_kg[sewn_.vertex_of[v]];
    }
  }

  SewnPieces run(const SewingReport& report) {
    const int budget = max_steps * static_cast<int>(pieces_.layer_of.back() + 1);
    if (report) report(share_joined(), sewn_.garment, now_m());
    int next_join = first_join, between_joins = frames_between_joins;
    for (int frame = 1; steps_ <= budget && share_joined() < 1.0; ++frame) {
      throw_if_interrupted();
      const std::vector<std::size_t> seams = pulled_seams(frame);
      pull(seams);
      if (!advance()) break;
      if (frame >= next_join) {
        const double before = share_joined();
        join_what_met(seams);
        const double closed = share_joined() - before;
        between_joins = closed > 0.0 ? frames_between_joins : std::min(2 * between_joins, max_frames_between_joins);
        next_join = frame + between_joins;
        if (closed < min_pass_fraction * (1.0 - before)) {
          // Cloth that a strong pull has crumpled comes loose in a weak one.
          strength_ = strength_ * strength_growth > max_strength ? 1.0 : strength_growth * strength_;
        }
      }
      if (report) report(share_joined(), sewn_.garment, now_m());
    }
    if (find_gap() > 0.0 && sewn_.reason.empty()) {
      const auto nearest = body_tree_.find_nearest(sewn_.gap_place_m, blocking_distance_m, accept_all);
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
    surroundings.bodies = bodies_;
    simulation_.emplace(sim::share(sewn_.garment), std::vector<Index>{}, simulation_settings(scene_.simulation),
                        std::move(surroundings), start_m);
    simulation_->set_time(time_s_);
  }

  void keep_shape() { sewn_.garment.mesh.positions = now_m(); }

  /// Advances a frame. Returns false if it is blocked.
  bool advance() {
    try {
      simulation_->advance_frame(throw_if_interrupted);
      steps_ += simulation_->last_report().substeps;
      sewn_.reason.clear();
    } catch (const sim::ContactBlocked& error) {
      sewn_.reason = error.what();
    }
    return sewn_.reason.empty();
  }

  bool is_joined(const std::pair<Index, Index>& pair) { return joined_.find(pair.first) == joined_.find(pair.second); }
  bool is_closed(const Seam& seam) {
    return std::ranges::all_of(seam, [&](const auto& pair) { return is_joined(pair); });
  }

  double share_joined() {
    std::size_t all = 0, joined = 0;
    for (const Seam& seam : pieces_.seams) {
      all += seam.size();
      for (const auto& pair : seam) joined += is_joined(pair) ? 1 : 0;
    }
    return all == 0 ? 1.0 : static_cast<double>(joined) / static_cast<double>(all);
  }

  double find_gap() {
    sewn_.gap_m = 0.0;
    for (std::size_t s = 0; s < pieces_.seams.size(); ++s) {
      for (const auto& [a, b] : pieces_.seams[s]) {
        const double gap_m = is_joined({a, b}) ? 0.0 : glm::distance(at(a), at(b));
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

  /// Returns whether all of these seams that belong to the present layer are closed.
  bool is_layer_closed(const std::vector<std::size_t>& seams) {
    return std::ranges::all_of(seams,
                               [&](std::size_t s) { return layer_of(s) != layer_ || is_closed(pieces_.seams[s]); });
  }

  /// Returns the seams to pull: seams of the innermost open layer, and at first only those that carry the garment.
  std::vector<std::size_t> pulled_seams(int frame) {
    std::vector<std::size_t> all(pieces_.seams.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    while (layer_ < pieces_.layer_of.back() && is_layer_closed(all)) {
      ++layer_;
      layer_began_ = frame;
      strength_ = 1.0;
    }
    is_carried_ = frame - layer_began_ >= max_frames_for_first || is_layer_closed(pieces_.first_seams);
    std::vector<std::size_t> seams = is_carried_ ? all : pieces_.first_seams;
    std::erase_if(seams, [&](std::size_t s) { return layer_of(s) != layer_; });
    return seams;
  }

  /// Pulls vertices that are sewn together towards their middle. The threads of all panels pull with the same force.
  void pull(const std::vector<std::size_t>& seams) {
    sim::Groups together(now_m().size());
    for (const std::size_t s : seams) {
      for (const auto& [a, b] : pieces_.seams[s]) {
        together.join(sewn_.vertex_of[a], sewn_.vertex_of[b]);
      }
    }
    std::vector<Knot> knots(now_m().size());
    const auto knot_at = [&](Index v) -> Knot& { return knots[together.find(v)]; };
    for (Index v = 0; v < now_m().size(); ++v) {
      knot_at(v).sum_m += now_m()[v];
      knot_at(v).count += 1.0;
    }
    std::vector<double> threads(pieces_.panel_count(), 0.0);
    for (std::size_t v = 0; v < pieces_.flat_m.size(); ++v) {
      Knot& knot = knot_at(sewn_.vertex_of[v]);
      knot.top_m = std::max(knot.top_m, pieces_.placed_m[v].y);
      threads[pieces_.panel_of[v]] += knot.count > 1.0 ? 1.0 : 0.0;
    }
    // Forces within a knot add up to nothing, so that threads do not move the cloth as a whole.
    for (std::size_t v = 0; v < pieces_.flat_m.size(); ++v) {
      const Index p = pieces_.panel_of[v];
      Knot& knot = knot_at(sewn_.vertex_of[v]);
      if (knot.count > 1.0) knot.pull_n += strength_ * pull_m_per_s2 * panel_masses_kg_[p] / threads[p] / knot.count;
    }
    for (Knot& knot : knots) {
      // Panels tilt as their shoulders are drawn together, which lowers the shoulders beside the body. The target stays
      // above.
      if (!is_carried_ && knot.count > 1.0) knot.sum_m.y = knot.count * knot.top_m;
    }
    for (Index v = 0; v < now_m().size(); ++v) {
      knot_at(v).reach_m = std::max(knot_at(v).reach_m, glm::distance(now_m()[v], knot_at(v).middle_m()));
    }
    sim::Surroundings surroundings = simulation_->surroundings();
    surroundings.forces.grabbed_vertices.clear();
    for (Index v = 0; v < now_m().size(); ++v) {
      const Knot& knot = knot_at(v);
      if (knot.count > 1.0) {
        surroundings.forces.grabbed_vertices.push_back(
            {v, knot.middle_m(), knot.pull_n / knot.reach_m, 2.0 * knot.pull_n});
      }
    }
    draw_in_layers(surroundings.forces.grabbed_vertices);
    simulation_->set_surroundings(surroundings);
  }

  /// Draws sewn layers towards the body, out of the way of the layers that are sewn over them.
  void draw_in_layers(std::vector<sim::GrabbedVertex>& held) const {
    if (layer_ == 0) return;
    std::vector<char> is_done(now_m().size(), 0);
    for (Index v = 0; v < pieces_.flat_m.size(); ++v) {
      const Index n = sewn_.vertex_of[v];
      if (pieces_.layer_of[pieces_.panel_of[v]] < layer_ && std::exchange(is_done[n], 1) == 0) {
        const auto nearest = body_tree_.find_nearest(at(v), std::numeric_limits<double>::infinity(), accept_all);
        const double pull_n = inwards_m_per_s2 * sewn_.garment.masses_kg[n];
        if (nearest) held.push_back({n, nearest->place_m, pull_n / inwards_from_m, pull_n});
      }
    }
  }

  /// Joins vertices that have met.
  void join_what_met(const std::vector<std::size_t>& seams) {
    std::vector<std::pair<Index, Index>> met;
    for (const std::size_t s : seams) {
      for (const auto& [a, b] : pieces_.seams[s]) {
        if (!is_joined({a, b}) && glm::distance(at(a), at(b)) < reach_fraction * pieces_.edge_m) met.emplace_back(a, b);
      }
    }
    keep_shape();
    const SewnPieces before = sewn_;
    const auto of_pieces_m = collect<Vec3>(sewn_.vertex_of, [&](Index n) { return now_m()[n]; });
    while (!met.empty()) {
      sim::Groups joined = joined_;
      for (const auto& [a, b] : met) joined.join(a, b);
      begin(join_pieces(pieces_, joined, of_pieces_m, scene_));
      pull(seams);
      const std::vector<char> is_crossed = advance() ? crossed() : std::vector<char>(now_m().size(), 1);
      const auto touches = [&](const auto& pair) { return is_crossed[sewn_.vertex_of[pair.first]] != 0; };
      const double bound = scene_.simulation.solver.bounded.max_stretch + bound_rounding;
      if (std::ranges::find(is_crossed, 1) == is_crossed.end() &&
          sim::measure_surface_stretch(sewn_.garment, now_m()).max <= bound) {
        joined_ = joined;
        return;
      }
      if (std::ranges::all_of(met, touches) || std::erase_if(met, touches) == 0) leave_out_nearest(is_crossed, met);
    }
    begin(before);
  }

  /// Leaves out the half of the pairs that is nearest to vertices that cross.
  void leave_out_nearest(const std::vector<char>& is_crossed, std::vector<std::pair<Index, Index>>& met) const {
    std::vector<std::pair<double, std::pair<Index, Index>>> by_distance;
    for (const auto& pair : met) {
      double min_distance_m = std::numeric_limits<double>::infinity();
      for (std::size_t v = 0; v < is_crossed.size(); ++v) {
        min_distance_m =
            is_crossed[v] != 0 ? std::min(min_distance_m, glm::distance(now_m()[v], at(pair.first))) : min_distance_m;
      }
      by_distance.emplace_back(-min_distance_m, pair);
    }
    std::ranges::sort(by_distance);
    met.clear();
    for (std::size_t k = 0; k < by_distance.size() / 2; ++k) met.push_back(by_distance[k].second);
  }

  /// Returns, per vertex, whether it is near triangles that cross something.
  std::vector<char> crossed() const {
    const sim::Surface cloth = {now_m(), sewn_.garment.mesh.triangles};
    std::vector<char> is_crossed(now_m().size(), 0);
    const auto mark = [&](Index t) {
      for (const Index v : cloth.triangles[t]) is_crossed[v] = 1;
    };
    bool any = false;
    for (const SceneCrossings& crossings : scene_crossings(cloth, bodies_, time_s_)) {
      for (const sim::CrossingPair& pair : crossings.pairs) {
        mark(pair.first);
        if (!crossings.body) mark(pair.second);
        any = true;
      }
    }
    // The solver leaves out triangles that are too near to be resolved above rounding.
    for (const sim::ExcludedTriangle& t : simulation_->last_report().excluded_triangles) {
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
  std::vector<sim::Body> bodies_;  ///< bodies without friction
  double time_s_;
  SurfaceTree body_tree_;
  sim::Groups joined_;  ///< sets of joined vertices of the pieces
  std::vector<double> panel_masses_kg_;
  double strength_ = 1.0;    ///< factor of the pull of all threads
  int steps_ = 0;            ///< count of time steps made
  std::size_t layer_ = 0;    ///< layer that is sewn
  bool is_carried_ = false;  ///< true once the seams that carry the layer are closed
  int layer_began_ = 0;      ///< frame in which the layer began
  SewnPieces sewn_;
  std::optional<sim::Simulation> simulation_;
};

}  // namespace

SewnPieces close_seams(const CutPieces& pieces, const Scene& scene, const LoadedBodies& bodies, double time_s,
                       const SewingReport& report) {
  return Closing(pieces, scene, bodies, time_s).run(report);
}

}  // namespace taut::app
