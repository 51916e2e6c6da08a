#include "sim/mesh/grid.hpp"

namespace taut::sim {

Mesh make_grid(const GridSettings& s) {
  if (s.columns < 2 || s.rows < 2) throw std::invalid_argument("a grid needs at least 2 columns and 2 rows");
  if (!(s.width_m > 0.0) || !(s.height_m > 0.0)) {
    throw std::invalid_argument("a grid needs a width and a height above 0");
  }
  const Vec3 across = {s.width_m, 0.0, 0.0};
  const Vec3 down = s.plane == GridPlane::vertical ? Vec3{0.0, -s.height_m, 0.0} : Vec3{0.0, 0.0, s.height_m};

  Mesh mesh;
  mesh.positions.reserve(std::size_t{s.columns} * s.rows);
  for (Index r = 0; r < s.rows; ++r) {
    for (Index c = 0; c < s.columns; ++c) {
      mesh.positions.push_back(s.top_centre_m + across * (c / (s.columns - 1.0) - 0.5) + down * (r / (s.rows - 1.0)));
    }
  }
  for (Index r = 0; r + 1 < s.rows; ++r) {
    for (Index c = 0; c + 1 < s.columns; ++c) {
      const Index top_left = r * s.columns + c;
      const Quad q = {top_left, top_left + s.columns, top_left + s.columns + 1, top_left + 1};
      mesh.quads.push_back(q);
      mesh.triangles.push_back({q[0], q[1], q[2]});
      mesh.triangles.push_back({q[0], q[2], q[3]});
    }
  }
  return mesh;
}

}  // namespace taut::sim
