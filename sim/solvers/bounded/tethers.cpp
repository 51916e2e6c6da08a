#include "sim/solvers/bounded/tethers.hpp"

#include "sim/solvers/bounded/tuning.hpp"

namespace taut::sim::bounded {

Tethers make_tethers(const Garment& garment, const Layout& layout, double slack) {
  Tethers tethers;
  tethers.pin.resize(layout.row_count(), 0);
  tethers.lanes.resize(layout.row_count());
  const double stretched = 1.0 + slack;
  const std::vector<Vec3>& rest = garment.mesh.positions;
  for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
    const double along_m = layout.distance_from_pins_m[row];
    if (!std::isfinite(along_m)) continue;
    const Index pin = layout.nearest_pin_row[row];
    // The distance along the cloth can come out slightly too short, but the cloth must fit at rest.
    const double straight_m = glm::length(rest[layout.vertex_of_row[row]] - rest[layout.vertex_of_row[pin]]);
    const double length_m = stretched * std::max(along_m, straight_m);
    tethers.pin[row] = pin;
    tethers.lanes[row].squared_length = static_cast<float>(length_m * length_m);
  }
  return tethers;
}

void start_tethers(const StartRows& start, Tethers& tethers) {
  const auto& [high, low] = start;
  for (std::size_t row = 0; row < tethers.lanes.size(); ++row) {
    const Index pin = tethers.pin[row];
    Tether& tether = tethers.lanes[row];
    tether.start_x = (high[row].x - high[pin].x) + (low[row].x - low[pin].x);
    tether.start_y = (high[row].y - high[pin].y) + (low[row].y - low[pin].y);
    tether.start_z = (high[row].z - high[pin].z) + (low[row].z - low[pin].z);
  }
}

}  // namespace taut::sim::bounded
