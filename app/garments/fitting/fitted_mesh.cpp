#include "app/garments/fitting/fitted_mesh.hpp"

#include "app/base/words.hpp"
#include "app/garments/fitting/following.hpp"
#include "app/garments/fitting/sheets.hpp"
#include "app/garments/fitting/tuning.hpp"
#include "sim/contact/crossing_pairs.hpp"
#include "sim/mesh/topology.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {

using namespace fitting;

namespace {

/// A border edge in the orientation of its triangle.
struct SheetBorderEdge {
  sim::Index from, to, triangle;
  sim::Vec3 inwards;
};

std::vector<SheetBorderEdge> border_edges(const sim::Mesh& mesh) {
  const sim::Adjacency adjacency = sim::make_adjacency(mesh);
  std::vector<SheetBorderEdge> edges;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    if (adjacency.edge_triangles[e].size() != 1) continue;
    const sim::Index t = adjacency.edge_triangles[e][0];
    auto [from, to] = adjacency.edges[e];
    if (!sim::runs_along(mesh.triangles[t], adjacency.edges[e])) std::swap(from, to);
    const sim::Vec3 way = mesh.positions[to] - mesh.positions[from];
    const sim::Vec3 in = glm::cross(sim::doubled_area_vector(mesh.positions, mesh.triangles[t]), way);
    edges.push_back({from, to, t, glm::dot(in, in) > 0.0 ? glm::normalize(in) : in});
  }
  return edges;
}

/// A vertex, and the point of an edge that it is welded to.
struct Weld {
  std::size_t edge;
  double way_m;  ///< distance from the start of the edge
  sim::Index vertex;
  auto operator<=>(const Weld&) const = default;
};

class Seams {
  struct Border {
    sim::Vec3 inwards = sim::Vec3(0.0);
    std::set<sim::Index> near;  ///< the vertex and its neighbours along the border
  };

 public:
  Seams(double distance_m, sim::Mesh& mesh)
      : distance_m_(distance_m),
        mesh_(mesh),
        edges_(border_edges(mesh)),
        part_of_(sim::connect_vertices(mesh.positions.size(), mesh.triangles)) {
    for (const SheetBorderEdge& edge : edges_) {
      for (const sim::Index v : {edge.from, edge.to}) {
        Border& border = borders_[v];
        border.inwards += edge.inwards;
        border.near.insert({edge.from, edge.to});
      }
    }
  }

  /// Finds welds within a part, and between parts closer than the join distance.
  std::vector<Weld> find_seams() { return find(distance_m_, false); }

  /// Finds welds to other parts across a gap that runs along most of a border.
  std::vector<Weld> find_gaps(double gap_m) {
    std::vector<Weld> welds = find(gap_m, true);
    std::vector<std::size_t> loop_of(mesh_.positions.size());
    std::vector<std::array<std::size_t, 2>> counts;  ///< per border: its welded vertices, all its vertices
    for (const std::vector<sim::Index>& loop : border_loops(mesh_)) {
      for (const sim::Index v : loop) loop_of[v] = counts.size();
      counts.push_back({0, loop.size()});
    }
    for (const Weld& weld : welds) ++counts[loop_of[weld.vertex]][0];
    const auto is_most = [&](sim::Index v) { return 2 * counts[loop_of[v]][0] > counts[loop_of[v]][1]; };
    std::erase_if(welds, [&](const Weld& w) { return !is_most(w.vertex) && !is_most(edges_[w.edge].from); });
    return welds;
  }

  std::size_t join(std::vector<Weld> welds) {
    std::ranges::sort(welds);
    pairs_.clear();
    for (std::size_t begin = 0; begin < welds.size();) {
      std::size_t end = begin;
      while (end < welds.size() && welds[end].edge == welds[begin].edge) ++end;
      split(edges_[welds[begin].edge], std::span(welds).subspan(begin, end - begin));
      begin = end;
    }
    weld();
    return welds.size();
  }

 private:
  bool may_join(sim::Index v, const Border& border, const TreeSurfacePoint& place, bool is_gap) {
    const SheetBorderEdge& edge = edges_[place.triangle];
    const bool is_other_part = part_of_.find(v) != part_of_.find(edge.from);
    const double length = glm::length(border.inwards), cosine = glm::dot(border.inwards, edge.inwards);
    if (is_other_part && !is_gap) return cosine < min_layer_cosine * length;
    return is_other_part == is_gap && cosine < (is_gap ? max_gap_cosine : max_seam_cosine) * length &&
           glm::dot(place.place_m - mesh_.positions[v], border.inwards) <=
               max_across_cosine * place.distance_m * length;
  }

  std::vector<Weld> find(double reach_m, bool is_gap) {
    std::vector<sim::Triangle> segments;
    for (const SheetBorderEdge& edge : edges_) segments.push_back({edge.from, edge.to, edge.to});
    const SurfaceTree tree(mesh_.positions, segments);
    std::vector<Weld> welds;
    for (const auto& [v, border] : borders_) {
      const auto found =
          tree.find_nearest(mesh_.positions[v], reach_m, [&, vertex = v, &own = border](const TreeSurfacePoint& place) {
            const SheetBorderEdge& edge = edges_[place.triangle];
            return !own.near.contains(edge.from) && !own.near.contains(edge.to) && may_join(vertex, own, place, is_gap);
          });
      if (found) {
        const sim::Vec3& from = mesh_.positions[edges_[found->triangle].from];
        welds.push_back({found->triangle, glm::distance(from, found->place_m), v});
      }
    }
    return welds;
  }

  /// Inserts vertices into an edge where others are welded to it, except near its ends and near each other.
  void split(const SheetBorderEdge& edge, std::span<const Weld> welds) {
    const sim::Vec3 from = mesh_.positions[edge.from], to = mesh_.positions[edge.to];
    const double length = glm::distance(from, to);
    sim::Index last = edge.from;
    double last_m = 0.0;
    for (const Weld& weld : welds) {
      if (length - weld.way_m < distance_m_) {
        pairs_.push_back({weld.vertex, weld.way_m - last_m < length - weld.way_m ? last : edge.to});
        continue;
      }
      if (weld.way_m - last_m >= distance_m_) {
        const auto added = static_cast<sim::Index>(mesh_.positions.size());
        mesh_.positions.push_back(from + weld.way_m / length * (to - from));
        cut_side(edge.triangle, last, edge.to, added);
        last = added;
        last_m = weld.way_m;
      }
      pairs_.push_back({weld.vertex, last});
    }
  }

  /// Cuts the triangle or its piece that has this side.
  void cut_side(sim::Index triangle, sim::Index from, sim::Index to, sim::Index between) {
    std::vector<sim::Index> pieces = pieces_[triangle];
    pieces.push_back(triangle);
    for (const sim::Index t : pieces) {
      for (int k = 0; k < 3; ++k) {
        sim::Triangle& corners = mesh_.triangles[t];
        if (corners[k] == from && corners[(k + 1) % 3] == to) {
          sim::Triangle rest = corners;
          rest[k] = between;
          corners[(k + 1) % 3] = between;
          pieces_[triangle].push_back(static_cast<sim::Index>(mesh_.triangles.size()));
          mesh_.triangles.push_back(rest);
          return;
        }
      }
    }
  }

  void weld() {
    sim::Groups groups(mesh_.positions.size());
    for (const sim::Edge& pair : pairs_) groups.join(pair[0], pair[1]);
    std::vector<sim::Vec3> sums(mesh_.positions.size(), sim::Vec3(0.0));
    std::vector<double> counts(mesh_.positions.size(), 0.0);
    for (sim::Index v = 0; v < sums.size(); ++v) {
      sums[groups.find(v)] += mesh_.positions[v];
      counts[groups.find(v)] += 1.0;
    }
    for (sim::Index v = 0; v < sums.size(); ++v) {
      mesh_.positions[v] = sums[groups.find(v)] / counts[groups.find(v)];
    }
    merge_vertices(groups, mesh_.triangles);
  }

  double distance_m_;
  sim::Mesh& mesh_;
  std::vector<SheetBorderEdge> edges_;
  sim::Groups part_of_;
  std::map<sim::Index, Border> borders_;
  std::map<sim::Index, std::vector<sim::Index>> pieces_;  ///< per cut triangle, the triangles that were cut off it
  std::vector<sim::Edge> pairs_;
};

/// Joins borders that run along each other within `distance_m`, unless one lies on the other. Their vertices need not
/// match: each vertex is welded to the nearest point of the other border. Where more than two triangles meet
/// afterwards, `cut_into_sheets` chooses. Requires at most two triangles at each edge.
void join_borders(double distance_m, sim::Mesh& mesh) {
  Seams seams(distance_m, mesh);
  seams.join(seams.find_seams());
}

/// Joins parts that lie farther apart where another part continues beyond the gap along most of a border, as trousers
/// do below their waistband; but not flat pattern pieces, which lie beside each other as cut. Welded points are at
/// least `spacing_m` apart. Returns the number of welded vertices. Requires the same as join_borders().
std::size_t join_parts(double spacing_m, sim::Mesh& mesh) {
  const sim::Vec3 size = sim::compute_extent(mesh.positions).size();
  const bool is_flat = std::min({size.x, size.y, size.z}) < flat_thickness_fraction * glm::length(size);
  Seams seams(spacing_m, mesh);
  return seams.join(seams.find_gaps(is_flat ? 0.0 : std::min(max_gap_m, gap_share * glm::length(size))));
}

/// Closes holes whose border is shorter than `max_length_m`.
void fill_small_holes(double max_length_m, sim::Mesh& mesh) {
  for (const std::vector<sim::Index>& loop : border_loops(mesh)) {
    double length = 0.0;
    sim::Vec3 sum(0.0), doubled_area(0.0);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const sim::Vec3 &at = mesh.positions[loop[i]], &next = mesh.positions[loop[(i + 1) % loop.size()]];
      doubled_area += glm::cross(at - mesh.positions[loop[0]], next - mesh.positions[loop[0]]);
      length += glm::distance(at, next);
      sum += at;
    }
    const bool is_slit = glm::length(doubled_area) < slit_width_ratio * max_length_m * length;
    if (length >= (is_slit ? 2.0 : 1.0) * max_length_m) continue;
    const auto middle = static_cast<sim::Index>(mesh.positions.size());
    mesh.positions.push_back(sum / static_cast<double>(loop.size()));
    for (std::size_t i = 0; i < loop.size(); ++i) {
      mesh.triangles.push_back({loop[(i + 1) % loop.size()], loop[i], middle});
    }
  }
}

sim::Mesh select_sheets(const Sheets& sheets, const std::vector<char>& is_chosen) {
  const auto of_chosen = [&](sim::Index sheet) { return is_chosen[sheet]; };
  return select_triangles(sheets.mesh, collect<std::uint8_t>(sheets.sheet_of, of_chosen));
}

/// Returns the fraction of the vertices of each sheet that are near a triangle of another sheet that is marked.
std::vector<double> fractions_beside(const Sheets& sheets, const std::vector<char>& is_marked) {
  const sim::Mesh marked = select_sheets(sheets, is_marked);
  const SurfaceTree tree(marked.positions, marked.triangles);
  const double reach_m = trim_distance_fraction * glm::length(sim::compute_extent(marked.positions).size());
  std::vector<double> near(sheets.count, 0.0), all(sheets.count, 0.0);
  for (std::size_t t = 0; t < sheets.sheet_of.size(); ++t) {
    const sim::Index sheet = sheets.sheet_of[t];
    if (is_marked[sheet] != 0) continue;
    const sim::Vec3& place_m = sheets.mesh.positions[sheets.mesh.triangles[t][0]];
    all[sheet] += 1.0;
    near[sheet] += tree.find_nearest(place_m, reach_m, accept_all).has_value() ? 1.0 : 0.0;
  }
  for (std::size_t k = 0; k < near.size(); ++k) near[k] /= std::max(all[k], 1.0);
  return near;
}

/// Returns the mesh without tiny sheets and without small ones beside large ones. Adds them to those that were dropped.
sim::Mesh large_sheets(const Sheets& sheets, FittedMesh& fitted) {
  std::vector<double> areas(sheets.count, 0.0);
  for (std::size_t t = 0; t < sheets.sheet_of.size(); ++t) {
    areas[sheets.sheet_of[t]] += triangle_area(sheets.mesh.positions, sheets.mesh.triangles[t]);
  }
  if (areas.empty()) return {};
  const double all = std::accumulate(areas.begin(), areas.end(), 0.0);
  const double min_area = std::min(min_sheet_share * all, min_share_of_largest * *std::ranges::max_element(areas));
  auto is_kept = collect<char>(areas, [&](double area) { return area >= min_area; });
  const std::vector<double> beside = fractions_beside(sheets, is_kept);
  for (std::size_t k = 0; k < areas.size(); ++k) {
    is_kept[k] |= static_cast<char>(areas[k] >= tiny_sheet_share * all && beside[k] < min_trim_fraction);
    fitted.dropped_sheets += is_kept[k] == 0;
    fitted.dropped_area_fraction += is_kept[k] == 0 ? areas[k] / all : 0.0;
  }
  return select_sheets(sheets, is_kept);
}

/// Fits one mesh to a model. Its crossings are mostly ends of a wall that lie on others.
FittedMesh fit_once(const sim::Mesh& model_m, const FittingSettings& settings, bool is_simplified) {
  FittedMesh fitted;
  Wall wall = find_wall(model_m);
  fitted.is_simulated = std::move(wall.is_chosen);
  sim::Mesh surface = large_sheets(wall.sheets, fitted);
  const auto max_triangles = static_cast<double>(settings.max_triangles);
  const double equal_edge_m = std::sqrt(4.0 * sim::surface_area(surface) / (std::numbers::sqrt3 * max_triangles));
  fitted.edge_m = std::max(settings.min_edge_m, target_edge_ratio * equal_edge_m);
  fill_small_holes(closed_hole_edges * fitted.edge_m, surface);
  const std::size_t max_looks = max_looks_per_triangle * settings.max_triangles;
  fitted.mesh = is_simplified ? simplify(surface, settings.max_triangles) : remesh(surface, fitted.edge_m, max_looks);
  for (int i = 0; !is_simplified && i < max_edge_trials && fitted.mesh.triangles.size() > settings.max_triangles; ++i) {
    fitted.edge_m *= target_edge_ratio * std::sqrt(static_cast<double>(fitted.mesh.triangles.size()) / max_triangles);
    fitted.mesh = remesh(surface, fitted.edge_m, max_looks);
  }
  // Sheets that were joined by a single edge may have come apart.
  Sheets cut = cut_into_sheets(large_sheets(cut_into_sheets(fitted.mesh), fitted));
  fitted.mesh = std::move(cut.mesh);
  fitted.sheets = cut.count;
  fitted.crossings = sim::find_crossing_pairs({fitted.mesh.positions, fitted.mesh.triangles}).size();
  return fitted;
}

}  // namespace

std::vector<std::vector<sim::Index>> border_loops(const sim::Mesh& mesh) {
  std::map<sim::Index, sim::Index> next;
  for (const SheetBorderEdge& edge : border_edges(mesh)) {
    const auto [place, is_first] = next.emplace(edge.from, edge.to);
    if (!is_first) place->second = sim::no_vertex;
  }
  std::vector<std::vector<sim::Index>> loops;
  while (!next.empty()) {
    std::vector<sim::Index> loop;
    sim::Index to = next.begin()->first;
    for (auto at = next.begin(); at != next.end(); at = next.find(to)) {
      loop.push_back(at->first);
      to = at->second;
      next.erase(at);
    }
    if (to == loop.front()) loops.push_back(std::move(loop));
  }
  return loops;
}

Wall find_wall(const sim::Mesh& model_m) {
  Sheets sheets = cut_into_sheets(model_m);
  turn_outwards(sheets);
  Wall wall{{}, choose_walls(sheets, find_other_walls(sheets))};
  sim::Mesh mesh = cut_into_sheets(select_triangles(sheets.mesh, wall.is_chosen)).mesh;
  const double size_m = glm::length(sim::compute_extent(mesh.positions).size());
  const double distance_m = std::min(max_joined_m, joined_share * size_m);
  join_borders(distance_m, mesh);
  mesh = cut_into_sheets(mesh).mesh;
  join_parts(distance_m, mesh);
  wall.sheets = cut_into_sheets(mesh);
  turn_outwards(wall.sheets);
  return wall;
}

FittedMesh fit_mesh(const sim::Mesh& model_m, const FittingSettings& settings) {
  FittedMesh fitted = fit_once(model_m, settings, false);
  const double min_area_m2 = min_area_left * sim::surface_area(fitted.mesh);
  for (int i = 1; i < max_fits && fitted.crossings > 0; ++i) {
    FittedMesh again = fit_once(fitted.mesh, settings, false);
    if (2 * again.crossings >= fitted.crossings || sim::surface_area(again.mesh) < min_area_m2) break;
    again.is_simulated = std::move(fitted.is_simulated);
    again.dropped_sheets += fitted.dropped_sheets;
    again.dropped_area_fraction += fitted.dropped_area_fraction;
    fitted = std::move(again);
  }
  return fitted;
}

FittedMesh simplify_model(const sim::Mesh& model_m, const FittingSettings& settings) {
  return fit_once(model_m, settings, true);
}

double sine_of_smallest_angle(const sim::Mesh& mesh, const sim::Triangle& t) {
  std::array<double, 3> sides{};
  for (std::size_t k = 0; k < 3; ++k) {
    sides[k] = glm::distance(mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]]);
  }
  std::ranges::sort(sides);
  const double area = glm::length(sim::doubled_area_vector(mesh.positions, t));
  return sides[1] > 0.0 ? area / (sides[1] * sides[2]) : 0.0;
}

bool is_coarse(const sim::Mesh& model) {
  return model.triangles.size() < min_fold_triangles && model.triangles.size() >= min_garment_triangles;
}

std::optional<std::string> why_not_fit_for_simulation(const sim::Mesh& model_m, std::size_t crossings,
                                                      double thickness_m) {
  const std::size_t count = model_m.triangles.size();
  if (crossings > 0) return fmt::format("it crosses itself in {} places", crossings);
  if (count > max_simulated_triangles) return fmt::format("it has {} triangles", count);
  const auto needles = std::ranges::count_if(
      model_m.triangles, [&](const sim::Triangle& t) { return sine_of_smallest_angle(model_m, t) < needle_sine; });
  if (static_cast<double>(needles) > needle_share * static_cast<double>(count)) {
    return fmt::format("{} of its {} triangles are needles", needles, count);
  }
  const sim::Adjacency adjacency = sim::make_adjacency(model_m);
  const auto is_short = [&](const sim::Edge& edge) {
    return glm::distance(model_m.positions[edge[0]], model_m.positions[edge[1]]) < thickness_m;
  };
  const auto too_short = std::ranges::count_if(adjacency.edges, is_short);
  if (static_cast<double>(too_short) > short_share * static_cast<double>(adjacency.edges.size())) {
    return fmt::format("{} of its edges are shorter than the cloth is thick", too_short);
  }
  const std::size_t fins = sim::measure_topology(model_m, adjacency).non_manifold_edges;
  if (fins > 0) return fmt::format("more than two triangles meet at {} of its edges", fins);
  Sheets sheets = cut_into_sheets(model_m);
  sim::Mesh joined_mesh = sheets.mesh;
  const std::size_t apart = join_parts(0.0, joined_mesh);
  if (apart >= min_border_vertices) {
    return fmt::format("parts of it lie apart along {} vertices of their borders", apart);
  }
  turn_outwards(sheets);
  const OtherWalls other = find_other_walls(sheets);
  const double share = share_of_two_walls(sheets, other);
  if (share > max_two_walled_fraction) return fmt::format("it has two walls over {:.0f} % of its area", 100.0 * share);
  const auto carried = std::ranges::count(choose_walls(sheets, other), 0);
  if (carried > 0) return fmt::format("parts of {} triangles lie on others", carried);
  return std::nullopt;
}

}  // namespace taut::app
