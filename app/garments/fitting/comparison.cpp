#include "app/garments/fitting/comparison.hpp"

#include <fmt/core.h>

#include "app/base/progress.hpp"
#include "app/garments/fitting/following.hpp"
#include "app/garments/fitting/sheets.hpp"
#include "app/garments/fitting/tuning.hpp"
#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/extent.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {

using namespace fitting;

namespace {

/// Returns points evenly over the area, by a sequence that fills a square evenly (Roberts 2018).
std::vector<sim::Vec3> sample_surface(const sim::Mesh& mesh) {
  std::vector<double> areas_up_to;
  double area = 0.0;
  for (const sim::Triangle& t : mesh.triangles) {
    areas_up_to.push_back(area += glm::length(sim::doubled_area_vector(mesh.positions, t)));
  }
  std::vector<sim::Vec3> points;
  for (std::size_t k = 0; k < sample_count && area > 0.0; ++k) {
    const double at = (static_cast<double>(k) + 0.5) / static_cast<double>(sample_count) * area;
    const auto t =
        static_cast<std::size_t>(std::lower_bound(areas_up_to.begin(), areas_up_to.end(), at) - areas_up_to.begin());
    const auto [a, b, c] = sim::corner_positions(mesh.triangles[std::min(t, areas_up_to.size() - 1)], mesh.positions);
    double u = std::fmod(0.7548776662466927 * static_cast<double>(k), 1.0);
    double v = std::fmod(0.5698402909980532 * static_cast<double>(k), 1.0);
    if (u + v > 1.0) {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    points.push_back(a + u * (b - a) + v * (c - a));
  }
  return points;
}

/// Returns the 99th percentile of the distances of points from a surface.
double distance_m(const std::vector<sim::Vec3>& points_m, const sim::Mesh& surface) {
  const SurfaceTree tree(surface.positions, surface.triangles);
  std::vector<double> distances_m = {0.0};
  for (const sim::Vec3& point_m : points_m) {
    distances_m.push_back(tree.find_nearest(point_m, std::numeric_limits<double>::infinity(), accept_all)->distance_m);
  }
  return quantile(std::move(distances_m), 0.99);
}

/// Returns the edges at which a sheet of the model may end, as triangles without area: borders, edges of more than two
/// triangles, rims and creases.
std::vector<sim::Triangle> find_rims(const sim::Mesh& mesh) {
  const sim::Adjacency adjacency = sim::make_adjacency(mesh);
  const std::vector<sim::Vec3> normals = unit_normals(mesh);
  std::vector<sim::Triangle> rims;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const auto around = adjacency.edge_triangles[e];
    const auto& [a, b] = adjacency.edges[e];
    if (around.size() != 2 || glm::dot(normals[around[0]], normals[around[1]]) < crease_cosine)
      rims.push_back({a, b, b});
  }
  return rims;
}

/// Returns the fraction of the length of the mesh's borders that runs along no rim of the model within `distance_m`.
double torn_fraction(const sim::Mesh& model_m, const sim::Mesh& mesh, double distance_m) {
  const SurfaceTree rims(model_m.positions, find_rims(model_m));
  const sim::Adjacency adjacency = sim::make_adjacency(mesh);
  double all_m = 0.0, torn_m = 0.0;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    if (adjacency.edge_triangles[e].size() != 1) continue;
    const sim::Vec3 &a = mesh.positions[adjacency.edges[e][0]], &b = mesh.positions[adjacency.edges[e][1]];
    all_m += glm::distance(a, b);
    const bool is_rim = rims.find_nearest(0.5 * (a + b), distance_m, accept_all).has_value();
    torn_m += is_rim ? 0.0 : glm::distance(a, b);
  }
  return all_m > 0.0 ? torn_m / all_m : 0.0;
}

}  // namespace

FittingComparison compare_with_model(const sim::Mesh& model_m, std::size_t model_crossings, const FittedMesh& fitted,
                                     const ComparisonLimits& limits) {
  const double size_m = glm::length(sim::compute_extent(model_m.positions).size());
  const sim::Mesh cloth = select_triangles(model_m, fitted.is_simulated);
  FittingComparison c;
  c.area_fraction = sim::surface_area(fitted.mesh) / sim::surface_area(cloth);
  c.torn_fraction = torn_fraction(model_m, fitted.mesh, limits.border_distance_fraction * size_m);
  c.parts = fitted.sheets;
  c.model_parts = cut_into_sheets(cloth).count;
  c.distance_from_model = distance_m(sample_surface(model_m), fitted.mesh) / size_m;
  c.distance_to_model = distance_m(sample_surface(fitted.mesh), model_m) / size_m;
  c.triangles = fitted.mesh.triangles.size();
  c.crossings = fitted.crossings;
  c.model_crossings = model_crossings;
  const auto triangles = static_cast<double>(fitted.mesh.triangles.size());
  // The same lines of crossing have more pairs in a finer mesh.
  const double finer = std::max(1.0, std::sqrt(triangles / static_cast<double>(model_m.triangles.size())));
  c.added_crossing_fraction =
      (static_cast<double>(c.crossings) - finer * static_cast<double>(model_crossings)) / triangles;
  return c;
}

std::optional<std::string> why_not_the_model(const FittingComparison& c, const ComparisonLimits& limits) {
  if (c.area_fraction < limits.min_area_fraction || c.area_fraction > limits.max_area_fraction) {
    return fmt::format("its area is {:.0f} % of the cloth's, expected {:.0f} to {:.0f} %", 100.0 * c.area_fraction,
                       100.0 * limits.min_area_fraction, 100.0 * limits.max_area_fraction);
  }
  if (c.torn_fraction > limits.max_torn_fraction) {
    return fmt::format("{:.0f} % of its borders run where the model has none, expected at most {:.0f} %",
                       100.0 * c.torn_fraction, 100.0 * limits.max_torn_fraction);
  }
  if (c.parts > c.model_parts) {
    return fmt::format("it has {} parts, expected at most the model's {}", c.parts, c.model_parts);
  }
  const double distance = std::max(c.distance_from_model, c.distance_to_model);
  if (distance > limits.max_distance_fraction) {
    return fmt::format("a hundredth of {} is farther than {:.1f} % of the size from {}, expected at most {:g} %",
                       c.distance_from_model >= distance ? "the model" : "it", 100.0 * distance,
                       c.distance_from_model >= distance ? "it" : "the model", 100.0 * limits.max_distance_fraction);
  }
  if (c.added_crossing_fraction > limits.max_added_crossing_fraction) {
    return fmt::format(
        "it crosses itself in {} places and the model in {}, expected at most {:g} % of its triangles more",
        c.crossings, c.model_crossings, 100.0 * limits.max_added_crossing_fraction);
  }
  const double all = static_cast<double>(c.crossings) / static_cast<double>(c.triangles);
  if (all > limits.max_crossing_fraction) {
    return fmt::format("it crosses itself in {} places, expected at most {:g} % of its {} triangles", c.crossings,
                       100.0 * limits.max_crossing_fraction, c.triangles);
  }
  return std::nullopt;
}

}  // namespace taut::app
