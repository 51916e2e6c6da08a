#include "tailor/dressing/lift.hpp"

#include <algorithm>
#include <cassert>

namespace taut::tailor {
namespace {

Vec3 on_seam(const Seam& seam, double fraction, const std::vector<Vec3>& positions) {
  const auto above = std::upper_bound(seam.fractions.begin() + 1, seam.fractions.end() - 1, fraction);
  const auto i = static_cast<std::size_t>(above - seam.fractions.begin());
  const double low = seam.fractions[i - 1];
  const double along = (fraction - low) / (seam.fractions[i] - low);
  return (1.0 - along) * positions[seam.vertices[i - 1]] + along * positions[seam.vertices[i]];
}

/// By the triangle the point lies in. Where a curved outline was cut off by a coarse edge, by the triangle it
/// lies least outside of.
Vec3 on_panel(const Panel& panel, const Vec2& flat, const std::vector<Vec3>& positions) {
  double best_weight = -1e9;
  Barycentric best{};
  const Triangle* found = nullptr;
  for (const Triangle& t : panel.triangles) {
    const Barycentric w = barycentric(panel.flat_m[t[0]], panel.flat_m[t[1]], panel.flat_m[t[2]], flat);
    const double smallest = std::min({w.a, w.b, w.c});
    if (smallest > best_weight) {
      best_weight = smallest;
      best = w;
      found = &t;
    }
  }
  const auto at = [&](std::size_t corner) { return positions[panel.vertices[(*found)[corner]]]; };
  return best.a * at(0) + best.b * at(1) + best.c * at(2);
}

}  // namespace

std::vector<Vec3> lift_onto(const Shirt& shirt, const Shirt& surface,
                            const std::vector<Vec3>& surface_positions) {
  assert(surface_positions.size() == surface.vertex_count);
  std::vector<Vec3> positions(shirt.vertex_count);
  for (const Seam& seam : shirt.seams) {
    const Seam& there = surface.seam(seam.name);
    for (std::size_t i = 0; i < seam.vertices.size(); ++i) {
      positions[seam.vertices[i]] = on_seam(there, seam.fractions[i], surface_positions);
    }
  }
  for (std::size_t p = 0; p < piece_count; ++p) {
    const Panel& panel = shirt.panels[p];
    for (std::size_t i = panel.outline_count; i < panel.flat_m.size(); ++i) {
      positions[panel.vertices[i]] = on_panel(surface.panels[p], panel.flat_m[i], surface_positions);
    }
  }
  return positions;
}

}  // namespace taut::tailor
