#include "app/models/trims.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "sim/mesh/point_cells.hpp"

namespace taut::app {
namespace {

constexpr double largest_trim = 0.1;  ///< share of the area of all parts
constexpr double farthest_m = 0.02;   ///< from the cloth; what is farther away does not go with it
constexpr std::size_t fewest_stitches = 3;
/// of each, share of the area of all parts: a belt needs more of them than a button
constexpr double area_of_stitch = 0.005;

/// A vertex of a trim, and the triangle of cloth below it.
struct Place {
  sim::Index vertex;
  sim::Index triangle;
  double distance;
};

double distance_to_segment(const sim::Vec3& point, const sim::Vec3& a, const sim::Vec3& b) {
  const double squared = glm::dot(b - a, b - a);
  const double at = squared > 0.0 ? std::clamp(glm::dot(point - a, b - a) / squared, 0.0, 1.0) : 0.0;
  return glm::distance(point, a + at * (b - a));
}

double distance_to_triangle(const sim::Vec3& point, const sim::Mesh& mesh, const sim::Triangle& t) {
  const sim::Vec3 normal = glm::normalize(sim::doubled_area_vector(mesh.positions, t));
  double to_border = std::numeric_limits<double>::infinity();
  bool is_above = true;
  for (int k = 0; k < 3; ++k) {
    const sim::Vec3 &a = mesh.positions[t[k]], &b = mesh.positions[t[(k + 1) % 3]];
    is_above = is_above && glm::dot(glm::cross(b - a, point - a), normal) >= 0.0;
    to_border = std::min(to_border, distance_to_segment(point, a, b));
  }
  return is_above ? std::abs(glm::dot(point - mesh.positions[t[0]], normal)) : to_border;
}

/// The triangles of all parts that are no trims, by their middles.
struct Cloth {
  Cloth(std::span<const GarmentPart> parts, double most_area, double farthest, const sim::Mesh& source)
      : mesh(source), reach(longest_way(parts, most_area) + farthest), middles(reach) {
    for (const GarmentPart& part : parts) {
      for (const sim::Index t : part.area_m2 > most_area ? part.triangles : std::vector<sim::Index>{}) {
        middles.add(middle_of(t), t);
      }
    }
  }

  /// The place below this vertex; empty if there is no cloth nearer than `farthest`.
  std::optional<Place> below(sim::Index vertex, double farthest) const {
    std::optional<Place> best;
    middles.visit_near(mesh.positions[vertex], [&](sim::Index t) {
      const double distance = distance_to_triangle(mesh.positions[vertex], mesh, mesh.triangles[t]);
      const bool is_nearer = distance <= (best ? best->distance : farthest);
      if (is_nearer && !(best && distance == best->distance && t > best->triangle)) {
        best = Place{vertex, t, distance};
      }
    });
    return best;
  }

  const sim::Mesh& mesh;
  double reach;
  sim::PointCells middles;

 private:
  sim::Vec3 middle_of(sim::Index t) const {
    const auto& [a, b, c] = mesh.triangles[t];
    return (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.0;
  }
  /// From the middle of any triangle to its farthest corner.
  double longest_way(std::span<const GarmentPart> parts, double most_area) const {
    double longest = 0.0;
    for (const GarmentPart& part : parts) {
      for (const sim::Index t : part.area_m2 > most_area ? part.triangles : std::vector<sim::Index>{}) {
        for (const sim::Index v : mesh.triangles[t]) {
          longest = std::max(longest, glm::distance(mesh.positions[v], middle_of(t)));
        }
      }
    }
    return longest;
  }
};

/// Places as far from each other as there are: the nearest to the cloth, then the farthest from those before.
std::vector<Place> stitches_of(const std::vector<Place>& places, std::size_t most_stitches,
                               const sim::Mesh& mesh) {
  std::vector<Place> stitches;
  const auto nearer = [](const Place& a, const Place& b) { return a.distance < b.distance; };
  stitches.push_back(*std::min_element(places.begin(), places.end(), nearer));
  while (stitches.size() < most_stitches) {
    const Place* farthest = nullptr;
    double farthest_distance = 0.0;
    for (const Place& place : places) {
      double distance = glm::distance(mesh.positions[place.vertex], mesh.positions[stitches[0].vertex]);
      for (const Place& stitch : stitches) {
        distance =
            std::min(distance, glm::distance(mesh.positions[place.vertex], mesh.positions[stitch.vertex]));
      }
      if (distance > farthest_distance) {
        farthest = &place;
        farthest_distance = distance;
      }
    }
    if (farthest == nullptr) {
      break;
    }
    stitches.push_back(*farthest);
  }
  return stitches;
}

/// The largest triangle from the vertex to two corners of the cloth below, which faces its side.
sim::Triangle stitch_at(const Place& place, const sim::Mesh& mesh) {
  const sim::Triangle& below = mesh.triangles[place.triangle];
  sim::Triangle largest{};
  double largest_area = -1.0;
  for (int k = 0; k < 3; ++k) {
    const sim::Triangle stitch = {place.vertex, below[k], below[(k + 1) % 3]};
    const double area = glm::length(sim::doubled_area_vector(mesh.positions, stitch));
    if (area > largest_area) {
      largest = stitch;
      largest_area = area;
    }
  }
  return largest;
}

}  // namespace

std::size_t sew_on_trims(std::span<const GarmentPart> parts, double metres_per_unit, sim::Mesh& mesh) {
  double area = 0.0;
  for (const GarmentPart& part : parts) {
    area += part.area_m2;
  }
  const auto is_trim = [&](const GarmentPart& part) { return part.area_m2 <= largest_trim * area; };
  if (std::none_of(parts.begin(), parts.end(), is_trim) || std::all_of(parts.begin(), parts.end(), is_trim)) {
    return 0;
  }
  const double farthest = farthest_m / metres_per_unit;
  const Cloth cloth(parts, largest_trim * area, farthest, mesh);
  std::vector<sim::Triangle> stitches;
  std::size_t sewn_on = 0;
  for (const GarmentPart& part : parts) {
    std::vector<Place> places;
    for (const sim::Index v : is_trim(part) ? part.vertices : std::vector<sim::Index>{}) {
      if (const auto place = cloth.below(v, farthest)) {
        places.push_back(*place);
      }
    }
    if (!places.empty()) {
      ++sewn_on;
      const auto more = static_cast<std::size_t>(part.area_m2 / (area_of_stitch * area));
      for (const Place& place : stitches_of(places, fewest_stitches + more, mesh)) {
        stitches.push_back(stitch_at(place, mesh));
      }
    }
  }
  mesh.triangles.insert(mesh.triangles.end(), stitches.begin(), stitches.end());
  return sewn_on;
}

}  // namespace taut::app
