#include "app/models/strays.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>
#include <vector>

#include "app/base/counted.hpp"
#include "sim/mesh/extent.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

// Share of the area that may lie beyond the rest on each side of each axis.
constexpr double outlying_area = 0.005;
// Distance of strays beyond the rest, as a multiple of its size.
constexpr double stray_distance = 1.0;

struct Patch {
  sim::Vec3 middle;
  double area;
};

std::vector<Patch> patches_of(const sim::Mesh& mesh) {
  std::vector<Patch> patches;
  for (const auto& [a, b, c] : mesh.triangles) {
    const sim::Vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
    patches.push_back({(p + q + r) / 3.0, 0.5 * glm::length(glm::cross(q - p, r - p))});
  }
  return patches;
}

/// Where nearly all of the area is along an axis.
std::pair<double, double> bulk_along(int axis, const std::vector<Patch>& patches, double area) {
  std::vector<std::pair<double, double>> places;
  for (const Patch& patch : patches) {
    places.emplace_back(patch.middle[axis], patch.area);
  }
  std::sort(places.begin(), places.end());
  const auto beyond = [&](auto first, auto last) {
    double sum = 0.0;
    for (auto place = first; place != last; ++place) {
      sum += place->second;
      if (sum > outlying_area * area) {
        return place->first;
      }
    }
    return first->first;
  };
  return {beyond(places.begin(), places.end()), beyond(places.rbegin(), places.rend())};
}

sim::Extent bulk_of(const std::vector<Patch>& patches, double area) {
  sim::Extent bulk;
  for (int axis = 0; axis < 3; ++axis) {
    std::tie(bulk.lower[axis], bulk.upper[axis]) = bulk_along(axis, patches, area);
  }
  return bulk;
}

/// Vertices that triangles connect, of whatever shares a place.
sim::Groups pieces_of(const sim::Mesh& mesh) {
  sim::Groups pieces(mesh.positions.size());
  const std::vector<sim::Index> places = sim::first_at_same_position(mesh.positions);
  for (const auto& [a, b, c] : mesh.triangles) {
    pieces.join(places[a], places[b]);
    pieces.join(places[b], places[c]);
    pieces.join(places[a], a);
  }
  return pieces;
}

}  // namespace

Strays remove_strays(sim::Mesh& mesh) {
  const std::vector<Patch> patches = patches_of(mesh);
  double area = 0.0;
  bool are_finite = true;
  for (const Patch& patch : patches) {
    area += patch.area;
    are_finite = are_finite && std::isfinite(patch.middle.x + patch.middle.y + patch.middle.z);
  }
  Strays strays;
  if (!are_finite || !std::isfinite(area) || !(area > 0.0)) {
    return strays;
  }
  const sim::Extent bulk = bulk_of(patches, area);
  const sim::Vec3 size = bulk.size();
  const double reach = stray_distance * std::max({size.x, size.y, size.z});
  const sim::Extent near{bulk.lower - reach, bulk.upper + reach};
  std::vector<char> is_near(mesh.positions.size(), 0);
  sim::Groups pieces = pieces_of(mesh);
  for (std::size_t t = 0; t < patches.size(); ++t) {
    if (sim::overlap({patches[t].middle, patches[t].middle}, near)) {
      is_near[pieces.find(mesh.triangles[t][0])] = 1;
    }
  }
  std::vector<sim::Triangle> kept;
  for (std::size_t t = 0; t < patches.size(); ++t) {
    if (is_near[pieces.find(mesh.triangles[t][0])]) {
      kept.push_back(mesh.triangles[t]);
      continue;
    }
    ++strays.triangles;
    strays.area_share += patches[t].area / area;
    strays.distance = std::max(strays.distance, glm::distance(patches[t].middle, bulk.middle()));
  }
  mesh.triangles = std::move(kept);
  return strays;
}

std::string describe(const Strays& strays, double metres_per_unit) {
  return fmt::format("{} with {:.2g} % of its area {} {:.3g} m away and {} left out",
                     counted(strays.triangles, "triangle"), 100.0 * strays.area_share,
                     strays.triangles == 1 ? "lies" : "lie", strays.distance * metres_per_unit,
                     strays.triangles == 1 ? "is" : "are");
}

}  // namespace taut::app
