#include "app/garments/sewing/cutting.hpp"

#include <fmt/core.h>

#include "app/garments/sewing/filling.hpp"
#include "app/garments/sewing/tuning.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::app {
namespace {

using sim::Index;
using sim::Triangle;
using sim::Vec2;
using sim::Vec3;
using namespace sewing;

std::vector<Vec2> fine_outline(const PatternPanel& panel) {
  std::vector<Vec2> outline;
  for (const std::vector<Vec2>& line : panel.edges_m) outline.insert(outline.end(), line.begin(), line.end() - 1);
  return outline;
}

/// Returns the side of that many equilateral triangles with the area of all panels.
double edge_for(const SewingPattern& pattern, int triangles) {
  double area_m2 = 0.0;
  for (const PatternPanel& panel : pattern.panels) area_m2 += std::abs(polygon_area(fine_outline(panel)));
  return std::clamp(std::sqrt(area_m2 * 4.0 / (std::sqrt(3.0) * triangles)), finest_edge_m, coarsest_edge_m);
}

/// Returns, per panel and edge, its number of steps. Edges that are sewn together get the same number. Unsewn edges may
/// be shortened by the fraction `of_borders`.
std::vector<std::vector<std::size_t>> steps_of_edges(const SewingPattern& pattern, double edge_m,
                                                     double of_borders = 0.0) {
  const std::vector<PanelEdge> edges = pattern.edges();
  const auto number = [&](const PanelEdge& e) {
    return static_cast<Index>(std::ranges::find(edges, e) - edges.begin());
  };
  sim::Groups sewn(edges.size());
  for (const Stitch& stitch : pattern.stitches) sewn.join(number(stitch.first), number(stitch.second));
  std::vector<double> lengths(edges.size(), 0.0), counts(edges.size(), 0.0);
  for (Index k = 0; k < edges.size(); ++k) {
    lengths[sewn.find(k)] += polyline_length(pattern.line_of(edges[k]));
    counts[sewn.find(k)] += 1.0;
  }
  std::vector<std::size_t> of_group(edges.size(), 1);
  for (Index k = 0; k < edges.size(); ++k) {
    const Index group = sewn.find(k);
    const std::vector<Vec2>& line = pattern.line_of(edges[k]);
    const double least = pattern.panels[edges[k].panel].edges_m.size() == 2 ? 2.0 : 1.0;
    std::size_t& steps = of_group[group];
    steps =
        std::max(steps, static_cast<std::size_t>(std::max(least, std::round(lengths[group] / counts[group] / edge_m))));
    const double shortened_m =
        std::max(max_shortening_m, counts[group] > 1.0 ? 0.0 : of_borders * polyline_length(line));
    while (polyline_length(evenly_along(line, steps)) < polyline_length(line) - shortened_m) ++steps;
  }
  std::vector<std::vector<std::size_t>> steps(pattern.panels.size());
  for (Index k = 0; k < edges.size(); ++k) steps[edges[k].panel].push_back(of_group[sewn.find(k)]);
  return steps;
}

/// Adds a panel. Returns, per edge, its vertices from start to end.
std::vector<std::vector<Index>> add_panel(const PatternPanel& panel, const std::vector<std::size_t>& steps,
                                          const Filling& filling, CutPieces& pieces) {
  std::vector<Vec2> outline;
  std::vector<std::size_t> begins;
  for (std::size_t e = 0; e < steps.size(); ++e) {
    const std::vector<Vec2> points = evenly_along(panel.edges_m[e], steps[e]);
    begins.push_back(outline.size());
    outline.insert(outline.end(), points.begin(), points.end() - 1);
  }
  const std::size_t count = outline.size();
  const bool is_clockwise = polygon_area(outline) < 0.0;
  if (is_clockwise) std::ranges::reverse(outline);
  FilledOutline filled;
  try {
    filled = fill_outline(outline, pieces.edge_m, filling);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("the panel '" + panel.name + "': " + error.what());
  }
  const auto first = static_cast<Index>(pieces.flat_m.size());
  const auto p = static_cast<Index>(pieces.panel_triangles.size());
  for (const Vec2& point : filled.points_m) {
    pieces.flat_m.push_back(point);
    pieces.placed_m.push_back(panel.placed_m(point));
    pieces.panel_of.push_back(p);
  }
  pieces.panel_triangles.push_back(static_cast<Index>(pieces.triangles.size()));
  for (const auto& [a, b, c] : filled.triangles) pieces.triangles.push_back({first + a, first + b, first + c});
  std::vector<std::vector<Index>> vertices(steps.size());
  for (std::size_t e = 0; e < steps.size(); ++e) {
    for (std::size_t k = 0; k <= steps[e]; ++k) {
      const std::size_t at = (begins[e] + k) % count;
      vertices[e].push_back(first + static_cast<Index>(is_clockwise ? count - 1 - at : at));
    }
  }
  return vertices;
}

using Borders = std::vector<std::vector<std::vector<Index>>>;  ///< vertices per panel and edge

/// Returns the seam of each stitch. A pattern does not say in which direction a seam closes. First come the seams in
/// which one direction is much shorter than the other; they imply which panels face the same side. For the other seams
/// these decide.
std::vector<Seam> find_seams(const SewingPattern& pattern, const Borders& borders, const CutPieces& pieces) {
  /// Scores from -1, certainly ahead, to 1, certainly back, and the stitches.
  std::vector<std::pair<double, std::size_t>> ways;
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const auto& [a, b] = pattern.stitches[s];
    const std::vector<Index>&first = borders[a.panel][a.edge], &second = borders[b.panel][b.edge];
    const auto at = [&](Index v) { return pieces.placed_m[v]; };
    const auto way_m = [&](Index v, Index w) { return glm::distance(at(v), at(w)); };
    const double ahead_m = way_m(first.front(), second.front()) + way_m(first.back(), second.back());
    const double back_m = way_m(first.front(), second.back()) + way_m(first.back(), second.front());
    const double lengths_m[] = {polyline_length(pattern.line_of(a)), polyline_length(pattern.line_of(b))};
    // The directions of borders say more than their distances where panels are far apart.
    const double alike = glm::dot(at(first.back()) - at(first.front()), at(second.back()) - at(second.front())) /
                         (lengths_m[0] * lengths_m[1]);
    ways.push_back({0.5 * ((ahead_m - back_m) / (lengths_m[0] + lengths_m[1]) - alike), s});
  }
  std::ranges::stable_sort(ways, std::greater(), [](const auto& way) { return std::abs(way.first); });
  sim::FacingGroups facing(pattern.panels.size());
  std::vector<Seam> seams(ways.size());
  for (const auto& [shorter, s] : ways) {
    const auto& [a, b] = pattern.stitches[s];
    // Borders of panels that face the same side run in opposite directions.
    const std::optional<bool> opposite = facing.opposite(a.panel, b.panel);
    const bool runs_back = opposite ? !*opposite : shorter > 0.0;
    facing.join(a.panel, b.panel, !runs_back);
    std::vector<Index> second = borders[b.panel][b.edge];
    if (runs_back) std::ranges::reverse(second);
    for (std::size_t k = 0; k < second.size(); ++k) seams[s].emplace_back(borders[a.panel][a.edge][k], second[k]);
  }
  return seams;
}

/// Returns whether the border of the panel runs counter-clockwise from this vertex to the other.
bool goes_along(const CutPieces& pieces, Index from, Index to) {
  return std::ranges::any_of(pieces.triangles, [&](const Triangle& t) { return sim::runs_along(t, {from, to}); });
}

/// Turns panels so that panels that are sewn together face the same side: outwards, away from the middle of all. They
/// are seen from outside in the flat.
void turn_outwards(const SewingPattern& pattern, CutPieces& pieces) {
  const std::size_t count = pieces.panel_count();
  sim::FacingGroups facing(count);
  for (std::size_t s = 0; s < pieces.seams.size(); ++s) {
    const auto& [begin, next] = std::pair(pieces.seams[s][0], pieces.seams[s][1]);
    facing.join(pattern.stitches[s].first.panel, pattern.stitches[s].second.panel,
                goes_along(pieces, begin.first, next.first) == goes_along(pieces, begin.second, next.second));
  }
  const Vec3 middle = std::accumulate(pieces.placed_m.begin(), pieces.placed_m.end(), Vec3(0.0)) /
                      static_cast<double>(pieces.placed_m.size());
  // Sums are kept at the first panel of those that are sewn together.
  std::vector<double> outwards(count, 0.0);
  std::vector<std::size_t> first(count);
  for (std::size_t p = 0; p < count; ++p) {
    while (!facing.opposite(first[p], p)) ++first[p];
    const double side = *facing.opposite(first[p], p) ? -1.0 : 1.0;
    for (Index t = pieces.panel_triangles[p]; t < pieces.panel_triangles[p + 1]; ++t) {
      const auto& [a, b, c] = pieces.triangles[t];
      const Vec3 &at = pieces.placed_m[a], out = at - middle;
      outwards[first[p]] +=
          side * glm::dot(glm::cross(pieces.placed_m[b] - at, pieces.placed_m[c] - at), Vec3(out.x, 0.0, out.z));
    }
  }
  for (std::size_t p = 0; p < count; ++p) {
    if (*facing.opposite(first[p], p) == (outwards[first[p]] < 0.0)) continue;
    for (Index t = pieces.panel_triangles[p]; t < pieces.panel_triangles[p + 1]; ++t) {
      std::swap(pieces.triangles[t][1], pieces.triangles[t][2]);
    }
    for (std::size_t v = 0; v < pieces.flat_m.size(); ++v) pieces.flat_m[v].x *= pieces.panel_of[v] == p ? -1.0 : 1.0;
  }
}

/// Lays panels side by side, at positions in cm that single precision holds, because files store these.
void lay_side_by_side(CutPieces& pieces) {
  std::vector<sim::Extent> boxes(pieces.panel_count());
  for (std::size_t v = 0; v < pieces.flat_m.size(); ++v) boxes[pieces.panel_of[v]].add({pieces.flat_m[v], 0.0});
  std::vector<double> begin_m = {0.0};
  for (const sim::Extent& box : boxes) {
    begin_m.push_back(begin_m.back() + box.upper.x - box.lower.x + between_panels_m);
  }
  for (std::size_t v = 0; v < pieces.flat_m.size(); ++v) {
    const Index p = pieces.panel_of[v];
    const Vec2 moved = pieces.flat_m[v] + Vec2(begin_m[p] - boxes[p].lower.x, 0.0);
    pieces.flat_m[v] = Vec2(glm::vec2(moved / metres_per_uv_of_cut)) * metres_per_uv_of_cut;
  }
}

/// Adds a step to the longest unsewn edge if the number of steps is odd and `wanted` even, or the reverse. The number
/// of triangles has the parity of the number of steps.
void match_parity(std::size_t wanted, const SewingPattern& pattern, std::vector<std::vector<std::size_t>>& steps) {
  std::size_t all = wanted;
  for (const std::vector<std::size_t>& of_panel : steps) all = std::reduce(of_panel.begin(), of_panel.end(), all);
  std::vector<PanelEdge> unsewn = pattern.unsewn_edges();
  const auto count = [&](const PanelEdge& e) -> std::size_t& { return steps[e.panel][e.edge]; };
  if (all % 2 == 1 && !unsewn.empty()) ++count(*std::ranges::max_element(unsewn, {}, count));
}

/// Meshes the panels anew. Returns their borders. Points are added in the panel that had most triangles before.
Borders mesh_panels(const SewingPattern& pattern, double edge_m, const std::vector<std::vector<std::size_t>>& steps,
                    const Filling& filling, CutPieces& pieces) {
  std::size_t largest_panel = 0;
  const auto size = [&](std::size_t p) { return pieces.panel_triangles[p + 1] - pieces.panel_triangles[p]; };
  for (std::size_t p = 0; p + 1 < pieces.panel_triangles.size(); ++p)
    largest_panel = size(p) > size(largest_panel) ? p : largest_panel;
  pieces = {};
  pieces.edge_m = edge_m;
  Borders borders;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const Filling own = {filling.jitter, p == largest_panel ? filling.more_points : 0};
    borders.push_back(add_panel(pattern.panels[p], steps[p], own, pieces));
  }
  pieces.panel_triangles.push_back(static_cast<Index>(pieces.triangles.size()));
  return borders;
}

/// Meshes the panels with exactly this number of irregular triangles. One more point in a panel usually makes two more
/// triangles.
Borders mesh_exactly(const SewingPattern& pattern, std::size_t triangles, CutPieces& pieces) {
  const auto wanted = static_cast<double>(triangles);
  double edge_m = pieces.edge_m, more = -1.0;
  for (int trial = 0; trial < max_meshes; ++trial) {
    const auto found = static_cast<double>(pieces.triangles.size());
    more += 0.5 * (wanted - found);
    if (more < 0.0 || more > max_point_growth * wanted) {
      edge_m *= std::sqrt(found / wanted) * spacing_growth;
      more = 0.0;
    }
    auto steps = steps_of_edges(pattern, edge_m, exact_shortened);
    match_parity(triangles, pattern, steps);
    Borders borders = mesh_panels(pattern, edge_m, steps, {exact_jitter, static_cast<std::size_t>(more)}, pieces);
    if (pieces.triangles.size() == triangles) return borders;
  }
  throw std::invalid_argument(fmt::format("no mesh of it was found that has exactly {} triangles", triangles));
}

}  // namespace

std::vector<sim::Extent> panel_boxes(const CutPieces& pieces) {
  std::vector<sim::Extent> boxes(pieces.panel_count());
  for (std::size_t v = 0; v < pieces.placed_m.size(); ++v) boxes[pieces.panel_of[v]].add(pieces.placed_m[v]);
  return boxes;
}

CutPieces cut_pieces(const SewingPattern& pattern, int triangles, bool is_exact) {
  CutPieces pieces;
  const double edge_m = edge_for(pattern, triangles);
  Borders borders = mesh_panels(pattern, edge_m, steps_of_edges(pattern, edge_m), {}, pieces);
  if (is_exact) borders = mesh_exactly(pattern, static_cast<std::size_t>(triangles), pieces);
  pieces.seams = find_seams(pattern, borders, pieces);
  turn_outwards(pattern, pieces);
  lay_side_by_side(pieces);
  pieces.layer_of.assign(pieces.panel_count(), 0);
  return pieces;
}

void add_over(const CutPieces& over, CutPieces& pieces) {
  const auto vertices = static_cast<Index>(pieces.flat_m.size()),
             triangles = static_cast<Index>(pieces.triangles.size());
  const auto panels = static_cast<Index>(pieces.panel_count());
  const std::size_t layer = pieces.layer_of.back() + 1;
  pieces.panel_triangles.pop_back();
  for (const Index first : over.panel_triangles) pieces.panel_triangles.push_back(triangles + first);
  pieces.flat_m.insert(pieces.flat_m.end(), over.flat_m.begin(), over.flat_m.end());
  // Shoulders of inner layers would be in the way of outer ones at the same height.
  const double lift_m = over.first_seams.empty() ? 0.0 : layer_lift_m * static_cast<double>(layer);
  for (const Vec3& placed_m : over.placed_m) pieces.placed_m.push_back(placed_m + Vec3(0.0, lift_m, 0.0));
  pieces.layer_of.insert(pieces.layer_of.end(), over.panel_count(), layer);
  for (const Index panel : over.panel_of) pieces.panel_of.push_back(panels + panel);
  for (const auto& [a, b, c] : over.triangles) pieces.triangles.push_back({vertices + a, vertices + b, vertices + c});
  for (const std::size_t seam : over.first_seams) pieces.first_seams.push_back(pieces.seams.size() + seam);
  for (Seam seam : over.seams) {
    for (auto& [a, b] : seam) {
      a += vertices;
      b += vertices;
    }
    pieces.seams.push_back(std::move(seam));
  }
  pieces.edge_m = std::min(pieces.edge_m, over.edge_m);
  lay_side_by_side(pieces);
}

}  // namespace taut::app
