#include <fmt/core.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/fitting/fitted_mesh.hpp"
#include "app/fitting/joining.hpp"
#include "app/fitting/sheets.hpp"
#include "app/fitting/walls.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::app {
namespace {

constexpr double two_walled = 0.3;       ///< share of the area from which cloth is modelled with two walls
constexpr std::size_t too_many = 16000;  ///< triangles
constexpr std::size_t too_few = 1000;    ///< triangles for the folds of a garment
constexpr std::size_t fewest_apart = 8;  ///< vertices of borders that lie along another part
constexpr double needle_share = 0.003;   ///< of the triangles
constexpr double short_share = 0.002;    ///< of the edges: contact tears cloth thicker than they are long
constexpr double needle_sine = 0.0871557427;  ///< of 5 degrees

/// The sine of the smallest angle, which lies between the two longest sides.
double sine_of_smallest_angle(const sim::Mesh& mesh, const sim::Triangle& t) {
  std::array<double, 3> sides{};
  for (std::size_t k = 0; k < 3; ++k) {
    sides[k] = glm::distance(mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]]);
  }
  std::sort(sides.begin(), sides.end());
  const double area = glm::length(sim::doubled_area_vector(mesh.positions, t));
  return sides[1] > 0.0 ? area / (sides[1] * sides[2]) : 0.0;
}

std::size_t needles_of(const sim::Mesh& mesh) {
  return static_cast<std::size_t>(
      std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                    [&](const sim::Triangle& t) { return sine_of_smallest_angle(mesh, t) < needle_sine; }));
}

}  // namespace

bool is_coarse(const sim::Mesh& model) {
  return model.triangles.size() < too_few && model.triangles.size() >= fewest_of_garment;
}

std::optional<std::string> why_not_fit_for_simulation(const sim::Mesh& model_m, std::size_t crossings,
                                                      double thickness_m) {
  const std::size_t count = model_m.triangles.size();
  if (crossings > 0) {
    return fmt::format("it crosses itself in {} places", crossings);
  }
  if (count > too_many) {
    return fmt::format("it has {} triangles", count);
  }
  const std::size_t needles = needles_of(model_m);
  if (static_cast<double>(needles) > needle_share * static_cast<double>(count)) {
    return fmt::format("{} of its {} triangles are needles", needles, count);
  }
  const sim::Adjacency adjacency = sim::make_adjacency(model_m);
  const auto is_short = [&](const sim::Edge& edge) {
    return glm::distance(model_m.positions[edge[0]], model_m.positions[edge[1]]) < thickness_m;
  };
  const auto too_short = std::count_if(adjacency.edges.begin(), adjacency.edges.end(), is_short);
  if (static_cast<double>(too_short) > short_share * static_cast<double>(adjacency.edges.size())) {
    return fmt::format("{} of its edges are shorter than the cloth is thick", too_short);
  }
  const std::size_t fins = sim::measure_topology(model_m, adjacency).non_manifold_edges;
  if (fins > 0) {
    return fmt::format("more than two triangles meet at {} of its edges", fins);
  }
  Sheets sheets = cut_into_sheets(model_m);
  sim::Mesh joined = sheets.mesh;
  const std::size_t apart = join_parts(gap_between_parts(joined), 0.0, joined);
  if (apart >= fewest_apart) {
    return fmt::format("parts of it lie apart along {} vertices of their borders", apart);
  }
  turn_outwards(sheets);
  const OtherWalls other = find_other_walls(sheets);
  const double share = share_of_two_walls(sheets, other);
  if (share > two_walled) {
    return fmt::format("it has two walls over {:.0f} % of its area", 100.0 * share);
  }
  const std::vector<char> kept = choose_walls(sheets, other);
  const auto carried = std::count(kept.begin(), kept.end(), 0);
  if (carried > 0) {
    return fmt::format("parts of {} triangles lie on others", carried);
  }
  return std::nullopt;
}

}  // namespace taut::app
