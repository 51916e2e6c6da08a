#include "app/models/strays.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "app/base/counted.hpp"
#include "app/verify/solid_bodies.hpp"
#include "sim/mesh/extent.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

// Share of the area that may lie beyond the rest on each side of each axis.
constexpr double outlying_area = 0.005;
// Distance of strays beyond the rest, as a multiple of its size.
constexpr double stray_distance = 0.25;

// Of bodies: share of all area from which a piece is large; length of their open borders, such as of a neck, wrists
// and ankles, by the square root of their area, of which suits have 1.2 and shirts 2.8; mean thickness by their size.
constexpr double large_piece = 0.1;
constexpr double body_piece = 0.02;  // the same beside another body: its head, but no button
constexpr double near_body = 0.25;   // of its size
constexpr double widest_cut = 0.95;
constexpr double stoutness = 0.025;

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

/// Parts that triangles connect.
struct Piece {
  std::vector<sim::Triangle> triangles;  ///< of places
  sim::Extent range;
  double area = 0.0;
  double volume = 0.0;  ///< within it, if it is closed
  double border = 0.0;  ///< length of the edges with one triangle
  bool is_left_out = false;
};

/// The length of the borders. Those of what was cut away go to and fro from triangle to triangle, which is left out.
double border_of(const sim::Mesh& mesh, const std::vector<sim::Triangle>& triangles) {
  std::vector<sim::Edge> edges;
  for (const sim::Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) {
      edges.push_back({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::map<sim::Index, std::vector<sim::Index>> beside;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const bool is_alone =
        (e == 0 || edges[e - 1] != edges[e]) && (e + 1 == edges.size() || edges[e + 1] != edges[e]);
    for (std::size_t k = 0; is_alone && k < 2; ++k) {
      beside[edges[e][k]].push_back(edges[e][1 - k]);
    }
  }
  double length = 0.0;
  for (const auto& [vertex, ends] : beside) {
    length += ends.size() == 2 ? 0.5 * glm::distance(mesh.positions[ends[0]], mesh.positions[ends[1]]) : 0.0;
  }
  return length;
}

std::map<sim::Index, Piece> measured_pieces(const sim::Mesh& mesh, sim::Groups& pieces,
                                            const sim::Vec3& origin) {
  const std::vector<sim::Index> places = sim::first_at_same_position(mesh.positions);
  std::map<sim::Index, Piece> measured;
  for (const sim::Triangle& t : mesh.triangles) {
    Piece& piece = measured[pieces.find(t[0])];
    const sim::Vec3 a = mesh.positions[t[0]] - origin, b = mesh.positions[t[1]] - origin,
                    c = mesh.positions[t[2]] - origin;
    piece.triangles.push_back({places[t[0]], places[t[1]], places[t[2]]});
    piece.area += 0.5 * glm::length(glm::cross(b - a, c - a));
    piece.volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    for (const sim::Vec3& p : {a, b, c}) {
      piece.range.add(p + origin);
    }
  }
  for (auto& [first, piece] : measured) {
    piece.border = border_of(mesh, piece.triangles);
  }
  return measured;
}

/// A body is closed, but for where its head, hands or feet are cut off, and stout; a thick garment is closed and thin.
bool is_stout(const Piece& piece) {
  const double size = glm::length(piece.range.size());
  return piece.border <= widest_cut * std::sqrt(piece.area) &&
         2.0 * std::abs(piece.volume) >= stoutness * size * piece.area;
}

/// Finds the bodies among the pieces, with the small ones within them, such as eyes, and beside them, such as
/// a head. There has to be cloth besides, and it has to be about them.
void find_bodies(const sim::Mesh& mesh, std::map<sim::Index, Piece>& pieces, double area) {
  sim::Extent cloth;
  double cloth_area = 0.0;
  for (auto& [first, piece] : pieces) {
    piece.is_left_out = piece.area >= large_piece * area && is_stout(piece);
    if (!piece.is_left_out && piece.area >= large_piece * area) {
      cloth_area += piece.area;
      cloth.add(piece.range.lower);
      cloth.add(piece.range.upper);
    }
  }
  for (auto& [first, body] : pieces) {
    body.is_left_out = body.is_left_out && cloth_area > 0.0 && sim::overlap(body.range, cloth);
  }
  for (auto& [first, body] : pieces) {
    const double reach = near_body * glm::length(body.range.size());
    const sim::Extent near{body.range.lower - reach, body.range.upper + reach};
    for (auto& [other, piece] : pieces) {
      if (!body.is_left_out || body.area < large_piece * area || piece.area >= large_piece * area) {
        continue;
      }
      const bool is_apart =
          piece.area >= body_piece * area && is_stout(piece) && sim::overlap(piece.range, near);
      const bool is_within =
          sim::overlap(piece.range, body.range) &&
          std::abs(winding_number(piece.range.middle(), {mesh.positions, body.triangles})) > 0.5;
      piece.is_left_out = piece.is_left_out || is_apart || is_within;
    }
  }
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
  std::map<sim::Index, Piece> measured = measured_pieces(mesh, pieces, bulk.middle());
  find_bodies(mesh, measured, area);
  strays.body_triangles = std::erase_if(
      mesh.triangles, [&](const sim::Triangle& t) { return measured[pieces.find(t[0])].is_left_out; });
  return strays;
}

std::string describe(const Strays& strays, double metres_per_unit) {
  return fmt::format("{} with {:.2g} % of its area {} {:.3g} m away and {} left out",
                     counted(strays.triangles, "triangle"), 100.0 * strays.area_share,
                     strays.triangles == 1 ? "lies" : "lie", strays.distance * metres_per_unit,
                     strays.triangles == 1 ? "is" : "are");
}

}  // namespace taut::app
