#include "app/garments/sewing/placing.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/garments/dressing/wearing.hpp"
#include "app/garments/sewing/tuning.hpp"
#include "sim/contact/crossing_pairs.hpp"

namespace taut::app {
namespace {

using sim::Index;
using sim::Vec3;
using namespace sewing;

/// Panels that cross another panel, or the body.
using Crossings = std::set<std::pair<Index, std::optional<Index>>>;

/// Pieces that must not touch each other or the body.
class Surrounded {
 public:
  Surrounded(const sim::Surface& body, const Vec3& axis_m, CutPieces& pieces)
      : body_(body), axis_m_(axis_m), pieces_(pieces) {
    const std::vector<sim::Extent> boxes = panel_boxes(pieces);
    for (std::size_t p = 0; p < boxes.size(); ++p) {
      const auto [a, b, c] = pieces.triangles[pieces.panel_triangles[p]];
      const auto& at = pieces.placed_m;
      const Vec3 normal = glm::cross(at[b] - at[a], at[c] - at[a]), middle = boxes[p].middle() - axis_m;
      const double across = glm::length(glm::dvec2(normal.x, normal.z));
      // A piece that lies flat is above the body.
      const bool is_free = body.triangles.empty(), is_flat = across <= min_level * glm::length(normal);
      Vec3 way = is_free   ? glm::normalize(normal)
                 : is_flat ? Vec3(0.0, 1.0, 0.0)
                           : Vec3(normal.x, 0.0, normal.z) / across;
      way = (is_free || !is_flat) && glm::dot(way, middle) < 0.0 ? -way : way;
      ways_.push_back(way);
      out_m_.push_back(glm::dot(middle, way));
    }
    put_over();
  }

  /// Moves pieces outwards along their normals if they cross the body or a piece further in. Pieces that cross one
  /// which faces the same way move sideways. Returns how many pieces moved.
  std::size_t part() {
    std::set<Index> all;
    Crossings before;
    for (int push = 0; push < max_pushes; ++push) {
      std::set<Index> moved;
      Crossings found = crossing(pieces_.placed_m);
      // Pieces that have come apart are pushed once more, so that they do not nearly touch.
      const Crossings& pushed = found.empty() ? before : found;
      if (pushed.empty()) break;
      for (const auto& [a, b] : pushed) {
        if (b && pieces_.layer_of[a] != pieces_.layer_of[*b]) {
          moved.insert(pieces_.layer_of[a] > pieces_.layer_of[*b] ? a : *b);
        } else if (b && glm::dot(ways_[a], ways_[*b]) > same_way) {
          part_sideways(a, *b);
          all.insert({a, *b});
        } else {
          moved.insert(b && out_m_[*b] >= out_m_[a] ? *b : a);
        }
      }
      move(moved, step_m, pieces_.placed_m);
      for (const Index p : moved) out_m_[p] += step_m;
      all.merge(moved);
      before = std::move(found);
    }
    return all.size();
  }

  /// Moves pieces inwards as far as they keep clear of all others, so that threads have less to draw. Pieces that face
  /// the same way move together and so do not pass each other.
  void draw_in() {
    std::set<Index> moving;
    const std::vector<sim::Extent> boxes = panel_boxes(pieces_);
    for (Index p = 0; p < pieces_.panel_count(); ++p) {
      // Hoods stay wide, or they would close around the thin neck.
      if (ways_[p].y == 0.0 && boxes[p].middle().y < axis_m_.y) moving.insert(p);
    }
    while (!moving.empty()) {
      std::vector<Vec3> ahead_m = pieces_.placed_m;
      std::set<Index> stopped;
      // Small steps are taken because a thin body may lie on the path.
      for (double ahead = 0.0; ahead < clear_m + 0.5 * step_m; ahead += step_m) {
        move(moving, -step_m, ahead_m);
        for (const auto& [a, b] : crossing(ahead_m)) {
          stopped.insert(a);
          stopped.insert(b.value_or(a));
        }
      }
      for (const Index p : moving) {
        if (out_m_[p] < clear_m) stopped.insert(p);
      }
      std::erase_if(moving, [&](Index p) {
        return std::ranges::any_of(stopped, [&](Index other) { return glm::dot(ways_[p], ways_[other]) > same_way; });
      });
      move(moving, -step_m, pieces_.placed_m);
      for (const Index p : moving) out_m_[p] -= step_m;
    }
  }

  /// Bends pieces towards the middle of all.
  void bend() {
    const double size_m = glm::length(sim::compute_extent(pieces_.placed_m).size());
    for (std::size_t v = 0; v < pieces_.placed_m.size(); ++v) {
      const Vec3& way = ways_[pieces_.panel_of[v]];
      Vec3 along_m = pieces_.placed_m[v] - axis_m_;
      along_m -= glm::dot(along_m, way) * way;
      pieces_.placed_m[v] -= bow_fraction / size_m * glm::dot(along_m, along_m) * way;
    }
  }

 private:
  /// Moves pieces of outer layers further out than pieces of inner layers that face nearly the same way.
  void put_over() {
    for (Index a = 0; a < ways_.size(); ++a) {
      double out_m = out_m_[a];
      for (Index b = 0; b < a; ++b) {
        if (pieces_.layer_of[b] < pieces_.layer_of[a] && glm::dot(ways_[a], ways_[b]) > nearly_same_way) {
          out_m = std::max(out_m, out_m_[b] + over_m);
        }
      }
      move({a}, out_m - out_m_[a], pieces_.placed_m);
      out_m_[a] = out_m;
    }
  }

  /// Moves two pieces that face the same way apart, half a step each.
  void part_sideways(Index a, Index b) {
    const std::vector<sim::Extent> boxes = panel_boxes(pieces_);
    Vec3 way = boxes[b].middle() - boxes[a].middle();
    way -= glm::dot(way, ways_[a]) * ways_[a];
    way = glm::length(way) > 1e-3 ? glm::normalize(way) : glm::cross(Vec3(0.0, 1.0, 0.0), ways_[a]);
    for (std::size_t v = 0; v < pieces_.placed_m.size(); ++v) {
      const Index p = pieces_.panel_of[v];
      pieces_.placed_m[v] += p == a ? -0.5 * step_m * way : p == b ? 0.5 * step_m * way : Vec3(0.0);
    }
  }

  Crossings crossing(const std::vector<Vec3>& positions_m) const {
    throw_if_interrupted();
    const sim::Surface cloth = {positions_m, pieces_.triangles};
    const auto panel = [&](Index t) { return pieces_.panel_of[pieces_.triangles[t][0]]; };
    Crossings found;
    for (const sim::CrossingPair& pair : sim::find_crossing_pairs(cloth, body_)) {
      found.insert({panel(pair.first), std::nullopt});
    }
    for (const sim::CrossingPair& pair : sim::find_crossing_pairs(cloth))
      found.insert({panel(pair.first), panel(pair.second)});
    return found;
  }

  void move(const std::set<Index>& panels, double by_m, std::vector<Vec3>& positions_m) const {
    for (std::size_t v = 0; v < positions_m.size(); ++v) {
      const Index p = pieces_.panel_of[v];
      positions_m[v] += panels.contains(p) ? by_m * ways_[p] : Vec3(0.0);
    }
  }

  sim::Surface body_;
  Vec3 axis_m_;
  CutPieces& pieces_;
  std::vector<Vec3> ways_;     ///< per panel, level and outwards
  std::vector<double> out_m_;  ///< per panel, the outward position of its middle
};

/// Requires that panels are sewn to others and do not all lie in one place.
void require_joined_and_placed(const SewingPattern& pattern) {
  if (pattern.panels.size() == 1) return;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    if (pattern.sewn_with({p}, [](std::size_t) { return true; }).size() == 1) {
      throw InputError("the panel '{}': found no stitch to another panel, expected one in pattern.stitches",
                       pattern.panels[p].name);
    }
  }
  const PatternPanel& first = pattern.panels.front();
  const bool is_any_placed = std::ranges::any_of(pattern.panels, [&](const PatternPanel& panel) {
    return panel.translation_m != first.translation_m || panel.rotation != first.rotation;
  });
  if (!is_any_placed) {
    throw InputError(
        "found all {} panels of the pattern at {} m, turned alike; expected translations and rotations that place them "
        "about a body",
        pattern.panels.size(), describe_point(first.translation_m));
  }
}

/// Lets the body begin thin and moves pieces as place_pieces() does. Returns how many moved.
std::size_t place_about_body(CutPieces& pieces, const Scene& scene, LoadedBodies& bodies) {
  const Dressed dressed = dressed_body(bodies);
  Wearer wearer = *dressed.wearer;
  sim::Body& body = bodies.all[dressed.body];
  const double frame_rate_hz = scene.simulation.frame_rate_hz;
  // An undressed body has no clearance for cloth.
  BodySource undressed = scene.bodies[dressed.body].source;
  undressed.dress = 0;
  wearer.own_m = read_body(undressed, {1.0, frame_rate_hz}).mesh.data->positions_m;
  wearer.motion = nullptr;
  wearer.rate_hz = frame_rate_hz;
  // Limbs turn while they are thin. Sleeves are cut for hanging arms, and would otherwise pull at the shoulders.
  const auto let_limbs_turn = [&] {
    std::vector<RigPose> poses = make_turning_poses(*wearer.rig, wearer.pose, turned_limbs(wearer, pieces));
    poses.insert(poses.end(), poses.size(), wearer.pose);
    std::get<sim::BodyMesh>(body.shape).frames = make_growing_frames(wearer, poses);
  };
  let_limbs_turn();
  const std::vector<Vec3> thin_m = mesh_positions_m(body, thin_time_s(bodies));
  const sim::Surface thin = {thin_m, std::get<sim::BodyMesh>(body.shape).data->triangles};
  const std::size_t moved = part_and_draw_in(thin, *wearer.measures.neck_m, pieces);
  // Pieces that were moved take along the limbs that belong into them.
  if (moved > 0) let_limbs_turn();
  return moved;
}

}  // namespace

std::size_t part_and_draw_in(const sim::Surface& body, const Vec3& axis_m, CutPieces& pieces) {
  const std::size_t moved = Surrounded(body, axis_m, pieces).part();
  Surrounded apart(body, axis_m, pieces);
  body.triangles.empty() ? apart.bend() : apart.draw_in();
  return moved;
}

double thin_time_s(const LoadedBodies& bodies) {
  if (bodies.all.empty()) return 0.0;
  return std::get<sim::BodyMesh>(bodies.all[dressed_body(bodies).body].shape).frames->first_s() - 1000.0;
}

std::vector<std::string> bring_to_body(const SewingPattern& pattern, const LoadedBodies& bodies, CutPieces& pieces) {
  require_joined_and_placed(pattern);
  std::vector<std::string> said;
  if (bodies.all.empty()) return said;
  const Wearer* const wearer = dressed_body(bodies).wearer;
  if (wearer == nullptr) {
    throw InputError("found no body that is dressed, expected someone to sew the pattern on");
  }
  const sim::Extent range = sim::compute_extent(pieces.placed_m);
  const double size_m = range.size()[sim::long_axis(range)];
  if (size_m < min_clothes_m || size_m > max_clothes_m) {
    throw InputError(
        "found a pattern of {:.3g} m, expected clothes of {} to {} m; properties.units_in_meter says what a "
        "unit is",
        size_m, min_clothes_m, max_clothes_m);
  }
  const Vec3 shift = compute_shift(pattern, *wearer, pieces, said);
  for (Vec3& position : pieces.placed_m) position += shift;
  turn_sleeves(pattern, shift, *wearer, pieces);
  return said;
}

std::vector<std::string> place_pieces(CutPieces& pieces, const Scene& scene, LoadedBodies& bodies) {
  const std::size_t moved = bodies.all.empty()
                                ? part_and_draw_in({}, sim::compute_extent(pieces.placed_m).middle(), pieces)
                                : place_about_body(pieces, scene, bodies);
  if (moved == 0) return {};
  return {fmt::format("{} of its {} pieces crossed another{} where they were placed: moved apart", moved,
                      pieces.panel_count(), bodies.all.empty() ? "" : " or the body")};
}

}  // namespace taut::app
