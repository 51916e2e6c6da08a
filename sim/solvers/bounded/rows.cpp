#include "sim/solvers/bounded/rows.hpp"

#include "sim/mesh/elementary.hpp"
#include "sim/mesh/geodesics.hpp"
#include "sim/solvers/bounded/kernels/blocks.hpp"
#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {
namespace {

void number_rows(const Garment& garment, const Pins& pins, Rows& rows) {
  const GeodesicDistances geodesics = geodesic_distances(garment.mesh, garment.adjacency, pins.vertices);
  const std::vector<double>& distances_m = geodesics.distances_m;
  std::vector<Index>& order = rows.vertex_of_row;
  order.resize(distances_m.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return distances_m[a] < distances_m[b]; });
  rows.row_of_vertex.resize(order.size());
  for (Index row = 0; row < order.size(); ++row) {
    rows.row_of_vertex[order[row]] = row;
    rows.distance_from_pins_m.push_back(distances_m[order[row]]);
    rows.inverse_masses_per_kg.push_back(static_cast<float>(pins.inverse_masses_per_kg[order[row]]));
  }
  for (const Index v : order) {
    const Index pin = geodesics.nearest_sources[v];
    rows.nearest_pin_row.push_back(pin == GeodesicDistances::no_source ? 0 : rows.row_of_vertex[pin]);
  }
  rows.inverse_masses_per_kg.resize(rows.row_count(), 0.0F);
  rows.pin_count = pins.vertices.size();
}

void measure_reach(const Garment& garment, Rows& rows) {
  const std::size_t count = garment.springs.begin_of(SpringKind::flexural);
  for (const double distance_m : rows.distance_from_pins_m) {
    rows.reach_m = std::isfinite(distance_m) ? std::max(rows.reach_m, distance_m) : rows.reach_m;
  }
  double total_m = 0.0;
  for (std::size_t s = 0; s < count; ++s) total_m += garment.springs.rest_lengths_m[s];
  rows.reach_springs = total_m > 0.0 ? rows.reach_m * static_cast<double>(count) / total_m : 0.0;
}

}  // namespace

std::size_t Rows::row_count() const { return (vertex_count() + 3 * block_size - 1) / block_size * block_size; }

Rows make_rows(const Garment& garment, const Pins& pins) {
  Rows rows;
  number_rows(garment, pins, rows);
  measure_reach(garment, rows);
  return rows;
}

double projection_ratio(Index row_i, Index row_j, const Rows& rows) {
  const double further_m = rows.distance_from_pins_m[row_j] - rows.distance_from_pins_m[row_i];
  if (!std::isfinite(further_m) || !(rows.reach_m > 0.0)) return 1.0;
  return exponential(-tuning::projection_weight_growth * further_m * rows.reach_springs / rows.reach_m);
}

}  // namespace taut::sim::bounded
