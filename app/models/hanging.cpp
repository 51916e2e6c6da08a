#include "app/models/hanging.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>

#include "app/base/counted.hpp"
#include "sim/mesh/extent.hpp"
#include "sim/mesh/groups.hpp"

namespace taut::app {
namespace {

// Fractions of a part's height, or of its size where that is said. This one is the height of the band that is
// pinned.
constexpr double band_height = 0.03;
constexpr double flat_thickness = 0.02;     ///< of the size; parts thinner than this are flat
constexpr double shortest_opening = 0.2;    ///< length around, of the size; shorter ones are holes or faults
constexpr double lowest_top_opening = 0.6;  ///< mean height of a top opening above the part's lowest point
/// from its lowest to its highest point; a steeper one is not a top opening
constexpr double steepest_top_opening = 0.4;
// Parts that `describe` lists one by one.
constexpr std::size_t most_lines = 12;

double largest(const sim::Vec3& v) {
  return std::max({v.x, v.y, v.z});
}

struct Opening {
  std::vector<sim::Index> vertices;
  double length_m = 0.0;
  double mean_height_m = 0.0;
  sim::Extent range;
};

struct Part {
  std::vector<sim::Index> vertices;
  std::vector<Opening> openings;
  sim::Extent range;
};

std::vector<Opening> openings_of(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  sim::Groups groups(mesh.positions.size());
  std::vector<double> lengths_m(mesh.positions.size(), 0.0);
  std::vector<sim::Index> at_border;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    if (adjacency.edge_triangles[e].size() == 1) {
      const auto [a, b] = adjacency.edges[e];
      groups.join(a, b);
      at_border.insert(at_border.end(), {a, b});
      lengths_m[a] += glm::distance(mesh.positions[a], mesh.positions[b]);
    }
  }
  std::sort(at_border.begin(), at_border.end());
  at_border.erase(std::unique(at_border.begin(), at_border.end()), at_border.end());
  std::map<sim::Index, Opening> openings;
  for (const sim::Index v : at_border) {
    Opening& opening = openings[groups.find(v)];
    opening.vertices.push_back(v);
    opening.length_m += lengths_m[v];
    opening.mean_height_m += mesh.positions[v].y;
    opening.range.add(mesh.positions[v]);
  }
  std::vector<Opening> list;
  for (auto& [first, opening] : openings) {
    opening.mean_height_m /= static_cast<double>(opening.vertices.size());
    list.push_back(std::move(opening));
  }
  return list;
}

std::vector<Part> parts_of(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  sim::Groups groups(mesh.positions.size());
  for (const sim::Edge& edge : adjacency.edges) {
    groups.join(edge[0], edge[1]);
  }
  // A group's name is its first vertex, so that parts come in the order of their first vertices.
  std::vector<std::size_t> part_of(mesh.positions.size(), 0);
  std::vector<Part> parts;
  for (sim::Index v = 0; v < mesh.positions.size(); ++v) {
    const sim::Index first = groups.find(v);
    if (first == v) {
      part_of[v] = parts.size();
      parts.emplace_back();
    }
    Part& part = parts[part_of[first]];
    part.vertices.push_back(v);
    part.range.add(mesh.positions[v]);
  }
  for (Opening& opening : openings_of(mesh, adjacency)) {
    parts[part_of[groups.find(opening.vertices.front())]].openings.push_back(std::move(opening));
  }
  return parts;
}

/// The opening a part is hung by; nullptr where it has none that will do. A single border is the outline of a
/// piece and no opening.
const Opening* top_opening(const Part& part) {
  const double height_m = part.range.size().y;
  const Opening* top = nullptr;
  std::size_t large_enough = 0;
  for (const Opening& opening : part.openings) {
    if (opening.length_m < shortest_opening * largest(part.range.size())) {
      continue;
    }
    ++large_enough;
    const bool is_high = opening.mean_height_m >= part.range.lower.y + lowest_top_opening * height_m;
    const bool is_level = opening.range.size().y <= steepest_top_opening * height_m;
    if (is_high && is_level && (top == nullptr || opening.mean_height_m > top->mean_height_m)) {
      top = &opening;
    }
  }
  return large_enough >= 2 ? top : nullptr;
}

std::vector<sim::Index> vertices_from(const sim::Mesh& mesh, const Part& part, int axis, double direction) {
  const double end = direction > 0.0 ? part.range.upper[axis] : part.range.lower[axis];
  const double reach = band_height * part.range.size()[axis];
  std::vector<sim::Index> vertices;
  for (const sim::Index v : part.vertices) {
    if (direction * (end - mesh.positions[v][axis]) <= reach) {
      vertices.push_back(v);
    }
  }
  return vertices;
}

HungPart hang_part(const sim::Mesh& mesh, const Part& part, std::vector<sim::Index>& pins) {
  const sim::Vec3 size = part.range.size();
  HungPart hung;
  hung.vertices = part.vertices.size();
  hung.closed = part.openings.empty();
  hung.flat = std::min({size.x, size.y, size.z}) <= flat_thickness * largest(size);
  std::vector<sim::Index> pins_of_part;
  if (const Opening* opening = top_opening(part); opening != nullptr) {
    hung.by = HungBy::top_opening;
    pins_of_part = opening->vertices;
  } else if (size.y <= flat_thickness * largest(size)) {
    hung.by = HungBy::back_edge;
    const bool is_a_ribbon = size.z <= flat_thickness * largest(size);
    pins_of_part = vertices_from(mesh, part, is_a_ribbon ? 0 : 2, -1.0);
  } else {
    pins_of_part = vertices_from(mesh, part, 1, 1.0);
  }
  hung.pins = pins_of_part.size();
  pins.insert(pins.end(), pins_of_part.begin(), pins_of_part.end());
  return hung;
}

const char* way_of(HungBy by) {
  constexpr std::array ways = {"hung by its top opening", "held at its highest points",
                               "lies flat, held by its back edge"};
  return ways[static_cast<std::size_t>(by)];
}

}  // namespace

Hanging hang(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  Hanging hanging;
  for (const Part& part : parts_of(mesh, adjacency)) {
    hanging.parts.push_back(hang_part(mesh, part, hanging.pins));
  }
  std::sort(hanging.pins.begin(), hanging.pins.end());
  return hanging;
}

std::vector<std::string> describe(const Hanging& hanging) {
  std::vector<std::string> lines;
  std::size_t closed = 0, flat = 0;
  for (std::size_t p = 0; p < hanging.parts.size(); ++p) {
    const HungPart& part = hanging.parts[p];
    closed += part.closed;
    flat += part.flat;
    if (p < most_lines) {
      lines.push_back(fmt::format("part {} of {}: {}, {}, {}", p + 1, hanging.parts.size(),
                                  counted(part.vertices, "vertex", "vertices"), way_of(part.by),
                                  counted(part.pins, "pin")));
    }
  }
  if (hanging.parts.size() > most_lines) {
    lines.push_back(
        fmt::format("and {} more, held likewise", counted(hanging.parts.size() - most_lines, "part")));
  }
  if (closed > 0) {
    lines.push_back(
        fmt::format("{} closed all around: cloth modelled with a thickness hangs as an outer and an "
                    "inner layer, joined where the model joins them",
                    closed == 1 ? "1 part is" : fmt::format("{} parts are", closed)));
  }
  if (flat > 1) {
    lines.push_back(
        fmt::format("{} parts are flat, like pattern pieces before they are sewn: each hangs by itself; "
                    "garment.weld sews borders that lie next to each other",
                    flat));
  }
  return lines;
}

}  // namespace taut::app
