#include "app/garments/fitting/sheets.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/garments/fitting/following.hpp"
#include "app/garments/fitting/tuning.hpp"
#include "sim/mesh/topology.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {

using namespace fitting;

namespace {

/// Returns how smoothly the surface continues from one triangle to another: the negative cosine between the directions
/// from the edge into both.
double smoothness(const sim::Mesh& mesh, const sim::Edge& edge, const sim::Triangle& a, const sim::Triangle& b) {
  const sim::Vec3 along = mesh.positions[edge[1]] - mesh.positions[edge[0]];
  const auto inwards = [&](const sim::Triangle& t) {
    for (const sim::Index v : t) {
      if (v != edge[0] && v != edge[1]) {
        const sim::Vec3 way = mesh.positions[v] - mesh.positions[edge[0]];
        return way - glm::dot(way, along) / glm::dot(along, along) * along;
      }
    }
    return sim::Vec3(0.0);
  };
  const sim::Vec3 x = inwards(a), y = inwards(b);
  const double lengths = glm::length(x) * glm::length(y);
  return lengths > 0.0 ? -glm::dot(x, y) / lengths : -2.0;
}

/// Returns the pairs of these triangles across which the surface continues most smoothly, the smoothest first. Each
/// triangle is in one pair at most.
std::vector<std::array<sim::Index, 2>> smoothest_pairs(const sim::Mesh& mesh, const sim::Edge& edge,
                                                       std::span<const sim::Index> around) {
  if (around.size() == 2) return {{around[0], around[1]}};
  struct WallPair {
    bool is_turned;  ///< true if the two face different sides: a surface of such pairs may be one-sided
    double roughness;
    std::size_t first, second;
  };
  std::vector<WallPair> pairs;
  for (std::size_t i = 0; i < around.size(); ++i) {
    for (std::size_t k = i + 1; k < around.size(); ++k) {
      const sim::Triangle &a = mesh.triangles[around[i]], &b = mesh.triangles[around[k]];
      const bool face_alike = sim::runs_along(a, edge) != sim::runs_along(b, edge);
      pairs.push_back({!face_alike, -smoothness(mesh, edge, a, b), i, k});
    }
  }
  std::ranges::stable_sort(pairs, {}, [](const WallPair& pair) { return std::pair(pair.is_turned, pair.roughness); });
  std::vector<char> is_taken(around.size(), 0);
  std::vector<std::array<sim::Index, 2>> smoothest;
  for (const auto& [is_turned, roughness, first, second] : pairs) {
    if (is_taken[first] != 0 || is_taken[second] != 0) continue;
    is_taken[first] = is_taken[second] = 1;
    smoothest.push_back({around[first], around[second]});
  }
  return smoothest;
}

/// Returns the pairs of triangles that stay together. At an edge of more than two triangles, these are the two across
/// which the surface continues most smoothly, and so on with the rest: many layers may have been welded to each other.
std::vector<sim::Joint> choose_joints(const sim::Mesh& mesh) {
  const sim::Adjacency adjacency = sim::make_adjacency(mesh);
  std::vector<sim::Joint> joints;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const sim::Edge& edge = adjacency.edges[e];
    throw_if_interrupted();
    for (const auto& [a, b] : smoothest_pairs(mesh, edge, adjacency.edge_triangles[e])) {
      joints.push_back(
          {edge, a, b, sim::runs_along(mesh.triangles[a], edge) == sim::runs_along(mesh.triangles[b], edge)});
    }
  }
  return joints;
}

/// Turns triangles so that neighbours face the side that most of their sheet faced. Drops joints where that is
/// impossible.
void orient(sim::Mesh& mesh, std::vector<sim::Joint>& joints) {
  const std::vector<char> turned = sim::turns_to_agree(mesh.triangles.size(), joints);
  std::erase_if(joints,
                [&](const sim::Joint& joint) { return (turned[joint.a] != turned[joint.b]) != joint.run_alike; });
  for (std::size_t t = 0; t < turned.size(); ++t) {
    if (turned[t] != 0) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
}

/// Returns the index of the triangle's side along this edge, by the corner where the side begins.
sim::Index side_at(const std::vector<sim::Triangle>& triangles, sim::Index t, const sim::Edge& edge) {
  return 3 * t + sim::corner_at(triangles[t], edge[sim::runs_along(triangles[t], edge) ? 0 : 1]);
}

/// Splits every vertex into one for each fan of triangles that stay together.
Sheets cut_between(const sim::Mesh& mesh, const std::vector<sim::Joint>& joints) {
  Sheets sheets{{{}, mesh.triangles, {}}, std::vector<sim::Index>(mesh.triangles.size()), 0, {}};
  std::vector<sim::Triangle>& triangles = sheets.mesh.triangles;
  sim::Groups fans(3 * triangles.size()), parts(triangles.size());
  sheets.beyond.assign(3 * triangles.size(), sim::no_vertex);
  const auto corner_of = [&](sim::Index t, sim::Index v) { return 3 * t + sim::corner_at(triangles[t], v); };
  for (const sim::Joint& joint : joints) {
    parts.join(joint.a, joint.b);
    sheets.beyond[side_at(triangles, joint.a, joint.edge)] = joint.b;
    sheets.beyond[side_at(triangles, joint.b, joint.edge)] = joint.a;
    for (const sim::Index v : joint.edge) fans.join(corner_of(joint.a, v), corner_of(joint.b, v));
  }
  std::vector<sim::Index> vertex_of_fan(3 * triangles.size(), sim::no_vertex);
  std::vector<sim::Index> number(triangles.size(), sim::no_vertex);
  for (sim::Index c = 0; c < 3 * triangles.size(); ++c) {
    sim::Index& vertex = vertex_of_fan[fans.find(c)];
    if (vertex == sim::no_vertex) {
      vertex = static_cast<sim::Index>(sheets.mesh.positions.size());
      sheets.mesh.positions.push_back(mesh.positions[mesh.triangles[c / 3][c % 3]]);
    }
    triangles[c / 3][c % 3] = vertex;
    sim::Index& sheet = number[parts.find(c / 3)];
    sheet = sheet == sim::no_vertex ? sheets.count++ : sheet;
    sheets.sheet_of[c / 3] = sheet;
  }
  return sheets;
}

/// Marks the triangles to separate at edges of more than two: those without a neighbour across the edge, and all after
/// the second. Empty if there are none.
std::vector<char> mark_crowded_edges(const Sheets& sheets) {
  const sim::Adjacency adjacency = sim::make_adjacency(sheets.mesh);
  std::vector<char> marked;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const auto around = adjacency.edge_triangles[e];
    for (std::size_t i = 0; i < around.size() && around.size() > 2; ++i) {
      marked.resize(sheets.mesh.triangles.size());
      const sim::Index side = side_at(sheets.mesh.triangles, around[i], adjacency.edges[e]);
      marked[around[i]] |= static_cast<char>(sheets.beyond[side] == sim::no_vertex || i > 1);
    }
  }
  return marked;
}

bool share_vertex(const sim::Triangle& a, const sim::Triangle& b) {
  return std::ranges::any_of(a, [&](sim::Index v) { return v == b[0] || v == b[1] || v == b[2]; });
}

/// The garment, prepared for rays and areas.
struct GarmentView {
  explicit GarmentView(const Sheets& source)
      : sheets(source), normals(unit_normals(source.mesh)), tree(source.mesh.positions, source.mesh.triangles) {
    size_m = glm::length(sim::compute_extent(source.mesh.positions).size());
    unit = std::min(1.0, size_m / usual_size_m);
    for (const sim::Triangle& t : source.mesh.triangles) areas.push_back(triangle_area(source.mesh.positions, t));
  }

  sim::Vec3 middle(sim::Index t) const { return triangle_middle(sheets.mesh.positions, sheets.mesh.triangles[t]); }

  /// Returns the fraction of the area of a piece, or of about `max_tried` of its triangles, for which `is_so(t)` holds.
  template <class IsSo>
  double fraction(std::span<const sim::Index> piece, const IsSo& is_so,
                  std::size_t max_tried = std::numeric_limits<std::size_t>::max()) const {
    const std::size_t stride = piece.size() / max_tried + 1;
    double chosen = 0.0, all = 0.0;
    for (std::size_t i = 0; i < piece.size(); i += stride) {
      throw_if_interrupted();
      chosen += is_so(piece[i]) ? areas[piece[i]] : 0.0;
      all += areas[piece[i]];
    }
    return all > 0.0 ? chosen / all : 0.0;
  }

  /// Returns the first point of the garment along the normal times `side` between these distances that is accepted and
  /// is on no neighbour.
  std::optional<TreeSurfacePoint> first_beyond(sim::Index t, double side, double begin_m, double end_m,
                                               const AcceptPoint& accept) const {
    return tree.first_hit(middle(t), side * normals[t], begin_m, end_m, [&](const TreeSurfacePoint& p) {
      return accept(p) && !share_vertex(sheets.mesh.triangles[t], sheets.mesh.triangles[p.triangle]);
    });
  }

  /// Returns the fraction of a piece's area whose rays along its normals times `side` miss the garment.
  double openness(std::span<const sim::Index> piece, double side) const {
    const auto is_beyond = [&](const TreeSurfacePoint& p) { return p.distance_m > 1e-5 * size_m; };
    return fraction(
        piece, [&](sim::Index t) { return !first_beyond(t, side, 0.0, size_m, is_beyond); }, max_triangles_tried);
  }

  const Sheets& sheets;
  std::vector<sim::Vec3> normals;
  std::vector<double> areas;
  SurfaceTree tree;
  double size_m;
  double unit;  ///< scale of lengths; below 1 for a doll's clothes, which are thinner
};

/// Returns lists of triangles by the number that each has. Triangles with `sim::no_vertex` are left out.
std::vector<std::vector<sim::Index>> gather_groups(const std::vector<sim::Index>& number_of, sim::Index count) {
  std::vector<std::vector<sim::Index>> rows(count);
  for (sim::Index t = 0; t < number_of.size(); ++t) {
    if (number_of[t] != sim::no_vertex) rows[number_of[t]].push_back(t);
  }
  return rows;
}

bool is_closed(const Sheets& sheets, std::span<const sim::Index> sheet) {
  return std::ranges::none_of(sheet, [&](sim::Index t) {
    return std::any_of(&sheets.beyond[3 * t], &sheets.beyond[3 * t] + 3,
                       [](sim::Index beyond) { return beyond == sim::no_vertex; });
  });
}

double total_area(const GarmentView& view, std::span<const sim::Index> piece) {
  double area = 0.0;
  for (const sim::Index t : piece) area += view.areas[t];
  return area;
}

/// Pieces that are chosen as a whole: sheets, and the walls of sheets that have two.
class Pieces {
 public:
  Pieces(const GarmentView& view, const OtherWalls& other)
      : piece_of(view.areas.size(), sim::no_vertex), view_(view), other_(other) {
    const auto all = gather_groups(view.sheets.sheet_of, view.sheets.count);
    const sim::Vec3 size = sim::compute_extent(view.sheets.mesh.positions).size();
    const bool is_flat = std::min({size.x, size.y, size.z}) < view.unit * flat_m;
    for (const auto& sheet : all) {
      const double doubled = view.fraction(sheet, [&](sim::Index t) { return other[t] != sim::no_vertex; });
      if (doubled > min_shell_area_fraction && (!is_flat || is_closed(view.sheets, sheet))) {
        cut_into_walls(sheet);
      } else {
        for (const sim::Index t : sheet) piece_of[t] = static_cast<sim::Index>(is_wall.size());
        is_wall.push_back(0);
      }
    }
  }

  std::vector<sim::Index> piece_of;  ///< piece of each triangle
  std::vector<char> is_wall;         ///< flag of each piece, whether it is a wall of a sheet that has two

 private:
  void flood(std::vector<sim::Index> front) {
    for (std::size_t i = 0; i < front.size(); ++i) {
      for (int side = 0; side < 3; ++side) {
        const sim::Index next = view_.sheets.beyond[3 * front[i] + side];
        if (next != sim::no_vertex && piece_of[next] == sim::no_vertex) {
          piece_of[next] = piece_of[front[i]];
          front.push_back(next);
        }
      }
    }
  }

  /// Cuts a sheet into its two walls: triangles face to face are of different walls, and neighbours of one wall where
  /// that does not contradict, the smoothest first. Small regions then join the large regions around them.
  void cut_into_walls(std::span<const sim::Index> sheet) {
    struct Smooth {
      double smoothness;
      sim::Index a, b;
    };
    sim::FacingGroups walls(piece_of.size());
    std::vector<Smooth> neighbours;
    for (const sim::Index t : sheet) {
      const sim::Index o = other_[t];
      if (o != sim::no_vertex && view_.sheets.sheet_of[o] == view_.sheets.sheet_of[t]) walls.join(t, o, true);
      for (int side = 0; side < 3; ++side) {
        const sim::Index next = view_.sheets.beyond[3 * t + side];
        if (next == sim::no_vertex || t > next) continue;
        // The crease at a rim, which has no other wall, comes after sharp seams: it would join the front's outer wall
        // to the back's inner one.
        const double cosine = glm::dot(view_.normals[t], view_.normals[next]);
        const bool is_at_rim = (o == sim::no_vertex || other_[next] == sim::no_vertex) && cosine < crease_cosine;
        neighbours.push_back({cosine - (is_at_rim ? 1.0 : 0.0), t, next});
      }
    }
    std::ranges::stable_sort(neighbours, std::greater{}, &Smooth::smoothness);
    sim::Groups regions(piece_of.size());
    for (const auto& [smoothness, a, b] : neighbours) {
      if (walls.opposite(a, b).value_or(false)) continue;
      walls.join(a, b, false);
      regions.join(a, b);
    }
    std::map<sim::Index, double> areas;
    for (const sim::Index t : sheet) areas[regions.find(t)] += view_.areas[t];
    const double least = min_wall_share * total_area(view_, sheet);
    std::map<sim::Index, sim::Index> number;
    for (const auto& [region, area] : areas) {
      if (area < least) continue;
      number.emplace(region, static_cast<sim::Index>(is_wall.size()));
      is_wall.push_back(1);
    }
    std::vector<sim::Index> front;
    for (const sim::Index t : sheet) {
      const auto found = number.find(regions.find(t));
      if (found == number.end()) continue;
      piece_of[t] = found->second;
      front.push_back(t);
    }
    flood(front);
    for (int half = 0; half < 2; ++half) leave_out_rims(sheet);
  }

  /// Takes triangles between two walls out of both: a half of each quad of a rim.
  void leave_out_rims(std::span<const sim::Index> sheet) {
    std::vector<sim::Index> rims;
    std::ranges::copy_if(sheet, std::back_inserter(rims), [&](sim::Index t) {
      return other_[t] == sim::no_vertex &&
             std::any_of(&view_.sheets.beyond[3 * t], &view_.sheets.beyond[3 * t] + 3,
                         [&](sim::Index next) { return next != sim::no_vertex && piece_of[next] != piece_of[t]; });
    });
    for (const sim::Index t : rims) piece_of[t] = sim::no_vertex;
  }

  static constexpr double min_wall_share = 0.02;  ///< smallest area of a wall, as a fraction of its sheet's area

  const GarmentView& view_;
  const OtherWalls& other_;
};

bool is_covered(const GarmentView& view, const OtherWalls& other, const std::vector<std::uint8_t>& kept, sim::Index t) {
  if (other[t] != sim::no_vertex && kept[other[t]] != 0) return true;
  const sim::Vec3 middle = view.middle(t);
  return view.tree
      .find_nearest(middle, view.unit * max_lying_distance_m,
                    [&](const TreeSurfacePoint& p) {
                      const double height = std::abs(glm::dot(p.place_m - middle, view.normals[p.triangle]));
                      return kept[p.triangle] != 0 && height >= min_over_cosine * p.distance_m;
                    })
      .has_value();
}

}  // namespace

Sheets cut_into_sheets(const sim::Mesh& mesh) {
  sim::Mesh oriented{mesh.positions, mesh.triangles, {}};
  std::vector<sim::Joint> joints = choose_joints(mesh);
  orient(oriented, joints);
  Sheets sheets = cut_between(oriented, joints);
  // A sheet can come back to an edge on a long detour.
  for (std::vector<char> apart = mark_crowded_edges(sheets); !apart.empty(); apart = mark_crowded_edges(sheets)) {
    std::erase_if(joints, [&](const sim::Joint& joint) { return apart[joint.a] != 0 || apart[joint.b] != 0; });
    sheets = cut_between(oriented, joints);
  }
  return sheets;
}

double six_times_volume(const sim::Mesh& mesh, std::span<const sim::Index> triangles, const sim::Vec3& apex) {
  double sum = 0.0;
  for (const sim::Index t : triangles) {
    const sim::Vec3 way = mesh.positions[mesh.triangles[t][0]] - apex;
    sum += glm::dot(sim::doubled_area_vector(mesh.positions, mesh.triangles[t]), way);
  }
  return sum;
}

std::size_t merge_vertices(sim::Groups& groups, std::vector<sim::Triangle>& triangles) {
  for (sim::Triangle& t : triangles) t = {groups.find(t[0]), groups.find(t[1]), groups.find(t[2])};
  return std::erase_if(triangles, [](const sim::Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

sim::Mesh select_triangles(const sim::Mesh& mesh, std::span<const std::uint8_t> is_marked) {
  sim::Mesh marked{mesh.positions, {}, {}};
  for (std::size_t t = 0; t < is_marked.size(); ++t) {
    if (is_marked[t] != 0) marked.triangles.push_back(mesh.triangles[t]);
  }
  return marked;
}

std::vector<sim::Vec3> unit_normals(const sim::Mesh& mesh) {
  return collect<sim::Vec3>(mesh.triangles, [&](const sim::Triangle& t) {
    return sim::unit_or_zero(sim::doubled_area_vector(mesh.positions, t));
  });
}

void turn_outwards(Sheets& sheets) {
  const GarmentView view(sheets);
  for (const std::vector<sim::Index>& sheet : gather_groups(sheets.sheet_of, sheets.count)) {
    if (is_closed(sheets, sheet) ? six_times_volume(sheets.mesh, sheet, view.middle(sheet.front())) >= 0.0
                                 : view.openness(sheet, -1.0) <= view.openness(sheet, 1.0) + 0.1) {
      continue;
    }
    for (const sim::Index t : sheet) {
      std::swap(sheets.mesh.triangles[t][1], sheets.mesh.triangles[t][2]);
      std::swap(sheets.beyond[3 * t], sheets.beyond[3 * t + 2]);
    }
  }
}

OtherWalls find_other_walls(const Sheets& sheets) {
  const GarmentView view(sheets);
  const double reach_m = view.unit * max_wall_distance_m;
  OtherWalls other(sheets.mesh.triangles.size(), sim::no_vertex);
  for (sim::Index t = 0; t < other.size(); ++t) {
    throw_if_interrupted();
    if (view.normals[t] == sim::Vec3(0.0)) continue;
    const auto hit =
        view.first_beyond(t, -1.0, -view.unit * max_wall_crossing_m, reach_m, [&](const TreeSurfacePoint& p) {
          return glm::dot(view.normals[t], view.normals[p.triangle]) < max_opposite_cosine;
        });
    other[t] = hit ? hit->triangle : sim::no_vertex;
  }
  return other;
}

double share_of_two_walls(const Sheets& sheets, const OtherWalls& other) {
  double doubled = 0.0, all = 0.0;
  for (std::size_t t = 0; t < other.size(); ++t) {
    const double area = glm::length(sim::doubled_area_vector(sheets.mesh.positions, sheets.mesh.triangles[t]));
    all += area;
    doubled += other[t] != sim::no_vertex ? area : 0.0;
  }
  return all > 0.0 ? doubled / all : 0.0;
}

std::vector<std::uint8_t> choose_walls(const Sheets& sheets, const OtherWalls& other) {
  const GarmentView view(sheets);
  const Pieces pieces(view, other);
  const auto triangles_of = gather_groups(pieces.piece_of, static_cast<sim::Index>(pieces.is_wall.size()));
  std::vector<std::pair<double, sim::Index>> order;
  for (sim::Index p = 0; p < pieces.is_wall.size(); ++p) {
    order.emplace_back(-total_area(view, triangles_of[p]) * (1.0 + view.openness(triangles_of[p], 1.0)), p);
  }
  std::ranges::sort(order);
  std::vector<std::uint8_t> kept(view.areas.size(), 0);
  for (const auto& [score, p] : order) {
    const double covered = view.fraction(
        triangles_of[p], [&](sim::Index t) { return is_covered(view, other, kept, t); }, max_triangles_tried);
    if (covered < (pieces.is_wall[p] != 0 ? min_behind_area_fraction : min_lying_area_fraction)) {
      for (const sim::Index t : triangles_of[p]) kept[t] = 1;
    }
  }
  return kept;
}

}  // namespace taut::app
