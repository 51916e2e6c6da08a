#include "app/fitting/fitted_mesh.hpp"

#include <fmt/core.h>

#include "app/fitting/joining.hpp"
#include "app/fitting/walls.hpp"
#include "app/verify/crossing_pairs.hpp"
#include "sim/mesh/extent.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::app {
namespace {

constexpr double smallest_sheet = 0.02;           ///< share of the area; what is smaller is carried
constexpr double smallest_beside_largest = 0.05;  ///< where all are small, of the largest
constexpr double joined_share = 0.003;            ///< of the size, at most between borders that are joined
constexpr double gap_share = 0.02;                ///< the same between parts that are apart
constexpr double flat = 0.02;                     ///< thickness of patterns that lie flat, of the size
constexpr double first_longer = 1.08;             ///< edges than those of so many equilateral triangles
constexpr double longer = 1.02;                   ///< than they would have to be, where there were too many triangles
constexpr int most_trials = 4;
constexpr int most_fits = 4;  ///< each of what the one before came to
/// Each fit is farther from the model, so that of few crossings, which can be parted, it has to leave less
/// than half.
constexpr std::size_t few_crossings = 70;
constexpr double least_left = 0.8;         ///< of the area
constexpr double closed_hole_edges = 5.0;  ///< round a hole that is closed

std::vector<double> areas_of_sheets(const Sheets& sheets) {
  std::vector<double> areas(sheets.count, 0.0);
  for (std::size_t t = 0; t < sheets.sheet_of.size(); ++t) {
    const auto& [a, b, c] = sheets.mesh.triangles[t];
    const auto& at = sheets.mesh.positions;
    areas[sheets.sheet_of[t]] += 0.5 * glm::length(glm::cross(at[b] - at[a], at[c] - at[a]));
  }
  return areas;
}

/// The mesh without crumbs.
sim::Mesh large_sheets(const Sheets& sheets) {
  const std::vector<double> areas = areas_of_sheets(sheets);
  double all = 0.0, largest = 0.0;
  for (const double area : areas) {
    all += area;
    largest = std::max(largest, area);
  }
  const double least = std::min(smallest_sheet * all, smallest_beside_largest * largest);
  sim::Mesh large{sheets.mesh.positions, {}, {}};
  for (std::size_t t = 0; t < sheets.sheet_of.size(); ++t) {
    if (areas[sheets.sheet_of[t]] >= least) large.triangles.push_back(sheets.mesh.triangles[t]);
  }
  return large;
}

double edge_for(double area_m2, std::size_t triangles) {
  return std::sqrt(4.0 * area_m2 / (std::numbers::sqrt3 * static_cast<double>(triangles)));
}

/// One mesh of a model. Crossings in it are mostly ends of a wall that lie on others.
FittedMesh fit_once(const sim::Mesh& model_m, const FittingSettings& settings) {
  FittedMesh fitted;
  Sheets sheets = cut_into_sheets(model_m);
  turn_outwards(sheets);
  const std::vector<char> kept = choose_walls(sheets, find_other_walls(sheets));
  sim::Mesh wall{sheets.mesh.positions, {}, {}};
  for (std::size_t t = 0; t < kept.size(); ++t) {
    if (kept[t] != 0) wall.triangles.push_back(sheets.mesh.triangles[t]);
  }
  wall = cut_into_sheets(wall).mesh;
  const double size_m = glm::length(sim::extent_of(wall.positions).size());
  const double distance_m = std::min(settings.join_distance_m, joined_share * size_m);
  fitted.joined_vertices = join_borders(distance_m, wall);
  wall = cut_into_sheets(wall).mesh;
  fitted.joined_vertices += join_parts(gap_between_parts(wall, settings), distance_m, wall);
  Sheets joined = cut_into_sheets(wall);
  turn_outwards(joined);
  sim::Mesh surface = large_sheets(joined);
  const double area = sim::surface_area(surface);
  fitted.edge_m = std::max(settings.least_edge_m, first_longer * edge_for(area, settings.most_triangles));
  fitted.closed_holes = fill_small_holes(closed_hole_edges * fitted.edge_m, surface);
  fitted.mesh = remesh(surface, fitted.edge_m);
  for (int i = 0; i < most_trials && fitted.mesh.triangles.size() > settings.most_triangles; ++i) {
    const auto found = static_cast<double>(fitted.mesh.triangles.size());
    fitted.edge_m *= longer * std::sqrt(found / static_cast<double>(settings.most_triangles));
    fitted.mesh = remesh(surface, fitted.edge_m);
  }
  // Sheets that an edge alone joined may have come apart.
  Sheets cut = cut_into_sheets(large_sheets(cut_into_sheets(fitted.mesh)));
  fitted.mesh = std::move(cut.mesh);
  fitted.sheets = cut.count;
  fitted.is_simulated.assign(kept.begin(), kept.end());
  fitted.carried_triangles = static_cast<std::size_t>(std::ranges::count(kept, 0));
  fitted.crossings = crossing_pairs({fitted.mesh.positions, fitted.mesh.triangles}).size();
  return fitted;
}

constexpr double two_walled = 0.3;            ///< share of the area from which cloth is modelled with two walls
constexpr std::size_t too_many = 16000;       ///< triangles
constexpr std::size_t too_few = 1000;         ///< triangles for the folds of a garment
constexpr std::size_t fewest_apart = 8;       ///< vertices of borders that lie along another part
constexpr double needle_share = 0.003;        ///< of the triangles
constexpr double short_share = 0.002;         ///< of the edges: contact tears cloth thicker than they are long
constexpr double needle_sine = 0.0871557427;  ///< of 5 degrees

/// The sine of the smallest angle, which lies between the two longest sides.
double sine_of_smallest_angle(const sim::Mesh& mesh, const sim::Triangle& t) {
  std::array<double, 3> sides{};
  for (std::size_t k = 0; k < 3; ++k) {
    sides[k] = glm::distance(mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]]);
  }
  std::ranges::sort(sides);
  const double area = glm::length(sim::doubled_area_vector(mesh.positions, t));
  return sides[1] > 0.0 ? area / (sides[1] * sides[2]) : 0.0;
}

std::size_t needles_of(const sim::Mesh& mesh) {
  return static_cast<std::size_t>(std::ranges::count_if(
      mesh.triangles, [&](const sim::Triangle& t) { return sine_of_smallest_angle(mesh, t) < needle_sine; }));
}

}  // namespace

double gap_between_parts(const sim::Mesh& model_m, const FittingSettings& settings) {
  const sim::Vec3 size = sim::extent_of(model_m.positions).size();
  const bool is_flat = std::min({size.x, size.y, size.z}) < flat * glm::length(size);
  return is_flat ? 0.0 : std::min(settings.gap_m, gap_share * glm::length(size));
}

FittedMesh fit_mesh(const sim::Mesh& model_m, const FittingSettings& settings) {
  FittedMesh fitted = fit_once(model_m, settings);
  for (int i = 1; i < most_fits && fitted.crossings > 0; ++i) {
    FittedMesh again = fit_once(fitted.mesh, settings);
    const std::size_t most = fitted.crossings > few_crossings ? fitted.crossings - 1 : (fitted.crossings - 1) / 2;
    if (again.crossings > most || sim::surface_area(again.mesh) < least_left * sim::surface_area(fitted.mesh)) {
      break;
    }
    again.is_simulated = std::move(fitted.is_simulated);
    again.carried_triangles = fitted.carried_triangles;
    again.joined_vertices += fitted.joined_vertices;
    again.closed_holes += fitted.closed_holes;
    fitted = std::move(again);
  }
  return fitted;
}

bool is_coarse(const sim::Mesh& model) {
  return model.triangles.size() < too_few && model.triangles.size() >= fewest_of_garment;
}

std::optional<std::string> why_not_fit_for_simulation(const sim::Mesh& model_m, std::size_t crossings,
                                                      double thickness_m) {
  const std::size_t count = model_m.triangles.size();
  if (crossings > 0) return fmt::format("it crosses itself in {} places", crossings);
  if (count > too_many) return fmt::format("it has {} triangles", count);
  const std::size_t needles = needles_of(model_m);
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
  sim::Mesh joined = sheets.mesh;
  const std::size_t apart = join_parts(gap_between_parts(joined), 0.0, joined);
  if (apart >= fewest_apart) {
    return fmt::format("parts of it lie apart along {} vertices of their borders", apart);
  }
  turn_outwards(sheets);
  const OtherWalls other = find_other_walls(sheets);
  const double share = share_of_two_walls(sheets, other);
  if (share > two_walled) return fmt::format("it has two walls over {:.0f} % of its area", 100.0 * share);
  const std::vector<char> kept = choose_walls(sheets, other);
  const auto carried = std::ranges::count(kept, 0);
  if (carried > 0) return fmt::format("parts of {} triangles lie on others", carried);
  return std::nullopt;
}

}  // namespace taut::app
