#include "app/models/hanging/garment_parts.hpp"

#include "app/garments/fitting/sheets.hpp"
#include "app/models/hanging/tuning.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/mesh/point_cells.hpp"

namespace taut::app {

using namespace hanging;

namespace {

struct OpeningEdge {
  sim::Edge ends;
  double length_m;
  sim::Vec3 middle_m;
  sim::Vec3 outwards;  ///< unit vector in the plane of its triangle
};

std::vector<OpeningEdge> border_edges(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  std::vector<OpeningEdge> border;
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    if (adjacency.edge_triangles[e].size() != 1) continue;
    const auto [a, b] = adjacency.edges[e];
    const sim::Vec3 &p = mesh.positions[a], &q = mesh.positions[b];
    const sim::Triangle& t = mesh.triangles[adjacency.edge_triangles[e][0]];
    const sim::Vec3 third = mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]] - p - q;
    const sim::Vec3 along = glm::normalize(q - p);
    const sim::Vec3 away = p - third;
    border.push_back(
        {adjacency.edges[e], glm::distance(p, q), 0.5 * (p + q), glm::normalize(away - glm::dot(away, along) * along)});
  }
  return border;
}

/// Returns whether the edges face each other, so that the cloth continues beyond the gap between them.
bool are_face_to_face(const OpeningEdge& a, const OpeningEdge& b) {
  return glm::dot(a.outwards, b.outwards) < max_opposite_border_cosine &&
         glm::dot(a.outwards, b.middle_m - a.middle_m) >= 0.0;
}

/// Returns, per edge of the border, the edge of its part across the gap of a seam; itself if there is none.
std::vector<sim::Index> across_seams(const std::vector<OpeningEdge>& border, sim::Groups& parts) {
  double max_length_m = 0.0;
  for (const OpeningEdge& edge : border) max_length_m = std::max(max_length_m, edge.length_m);
  std::vector<sim::Index> across(border.size());
  std::iota(across.begin(), across.end(), sim::Index{0});
  std::map<sim::Index, sim::PointCells> middles_by_part;
  const auto middles = [&](const OpeningEdge& edge) -> sim::PointCells& {
    return middles_by_part.try_emplace(parts.find(edge.ends[0]), max_seam_gap_ratio * max_length_m).first->second;
  };
  for (sim::Index k = 0; k < border.size(); ++k) middles(border[k]).add(border[k].middle_m, k);
  for (sim::Index k = 0; k < border.size(); ++k) {
    double min_distance_m = std::numeric_limits<double>::infinity();
    middles(border[k]).visit_near(border[k].middle_m, [&](sim::Index other) {
      const double reach_m = max_seam_gap_ratio * std::max(border[k].length_m, border[other].length_m);
      const double distance_m = glm::distance(border[k].middle_m, border[other].middle_m);
      const bool is_nearer = distance_m < min_distance_m || (distance_m == min_distance_m && other < across[k]);
      if (distance_m <= reach_m && other != k && is_nearer && are_face_to_face(border[k], border[other])) {
        min_distance_m = distance_m;
        across[k] = other;
      }
    });
  }
  return across;
}

std::vector<Opening> find_openings(const sim::Mesh& mesh, const sim::Adjacency& adjacency, sim::Groups& parts) {
  sim::Groups groups(mesh.positions.size());
  std::vector<double> lengths_m(mesh.positions.size(), 0.0);
  std::set<sim::Index> at_border;
  const std::vector<OpeningEdge> border = border_edges(mesh, adjacency);
  const std::vector<sim::Index> across = across_seams(border, parts);
  for (sim::Index k = 0; k < border.size(); ++k) {
    const auto [a, b] = border[k].ends;
    if (across[k] != k) {
      // An opening continues beyond a seam that ends in it.
      const auto [c, d] = border[across[k]].ends;
      const bool is_c =
          glm::distance(mesh.positions[a], mesh.positions[c]) < glm::distance(mesh.positions[a], mesh.positions[d]);
      groups.join(a, is_c ? c : d);
      groups.join(b, is_c ? d : c);
      continue;
    }
    groups.join(a, b);
    at_border.insert({a, b});
    lengths_m[a] += border[k].length_m;
  }
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

bool is_wide(const GarmentPart& part, const Opening& opening) {
  return opening.range.size()[part.across()] >= min_opening_width * part.width_m();
}

/// Returns the large openings that carry the part; none if it has only one large opening, which may be its outline.
std::vector<const Opening*> carrying_openings(const GarmentPart& part) {
  std::vector<const Opening*> openings = large_openings(part);
  const bool is_outline = openings.size() < 2;
  std::erase_if(openings, [&](const Opening* opening) {
    return is_outline || !is_wide(part, *opening) || !carries(part, opening->range);
  });
  return openings;
}

bool is_high_and_level(const GarmentPart& part, const Opening& opening) {
  const double height_m = part.range.size().y;
  return opening.mean_height_m >= part.range.lower.y + min_top_opening_height * height_m &&
         opening.range.size().y <= max_top_opening_steepness * height_m;
}

/// Returns whether the opening comes as near to the middle as an armhole does.
bool is_near_middle(const GarmentPart& part, const Opening& opening) {
  const int axis = part.across();
  const double inside_m =
      std::max(opening.range.lower[axis] - part.centre_m[axis], part.centre_m[axis] - opening.range.upper[axis]);
  return inside_m <= max_armhole_offset * part.width_m();
}

bool is_armhole(const GarmentPart& part, const Opening& opening) {
  return is_high_and_level(part, opening) && is_near_middle(part, opening);
}

/// Returns the signed distance of the opening's middle from the centre, as a fraction of the width.
double beside_middle(const GarmentPart& part, const Opening& opening) {
  const int axis = part.across();
  return (opening.range.middle()[axis] - part.centre_m[axis]) / part.width_m();
}

bool are_a_pair(const GarmentPart& part, const Opening& a, const Opening& b) {
  const double side_a = beside_middle(part, a), side_b = beside_middle(part, b);
  // A part without a width has no sides: they are no numbers.
  if (!(side_a * side_b < 0.0)) return false;
  sim::Extent joint_range = a.range;
  joint_range.add(b.range.lower);
  joint_range.add(b.range.upper);
  return is_armhole(part, a) && is_armhole(part, b) && carries(part, joint_range) &&
         std::abs(a.mean_height_m - b.mean_height_m) <= max_pair_height_difference * part.range.size().y;
}

}  // namespace

std::vector<GarmentPart> find_garment_parts(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  sim::Groups groups = sim::connect_vertices(mesh.positions.size(), mesh.triangles);
  // A group is named by its first vertex, so that parts come in the order of their first vertices.
  std::vector<std::size_t> part_of(mesh.positions.size(), 0);
  std::vector<GarmentPart> parts;
  for (sim::Index v = 0; v < mesh.positions.size(); ++v) {
    const sim::Index first = groups.find(v);
    if (first == v) {
      part_of[v] = parts.size();
      parts.emplace_back();
    }
    GarmentPart& part = parts[part_of[v] = part_of[first]];
    part.vertices.push_back(v);
    part.range.add(mesh.positions[v]);
  }
  for (sim::Index triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    const sim::Triangle& t = mesh.triangles[triangle];
    GarmentPart& part = parts[part_of[t[0]]];
    const double area_m2 = triangle_area(mesh.positions, t);
    part.triangles.push_back(triangle);
    part.area_m2 += area_m2;
    part.centre_m += area_m2 / 3.0 * (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]);
  }
  for (GarmentPart& part : parts) part.centre_m /= part.area_m2;
  for (Opening& opening : find_openings(mesh, adjacency, groups)) {
    parts[part_of[opening.vertices.front()]].openings.push_back(std::move(opening));
  }
  return parts;
}

std::vector<const Opening*> large_openings(const GarmentPart& part) {
  std::vector<const Opening*> large;
  for (const Opening& opening : part.openings) {
    if (opening.length_m >= min_opening_length_ratio * part.size_m()) large.push_back(&opening);
  }
  return large;
}

bool carries(const GarmentPart& part, const sim::Extent& held) {
  const auto reaches = [&](int axis, double slack) {
    return part.centre_m[axis] >= held.lower[axis] - slack * part.width_m() &&
           part.centre_m[axis] <= held.upper[axis] + slack * part.width_m();
  };
  return reaches(part.across(), max_off_balance_across) && reaches(2 - part.across(), max_off_balance_in_depth);
}

const Opening* top_opening(const GarmentPart& part) {
  std::vector<const Opening*> openings = carrying_openings(part);
  std::erase_if(openings, [&](const Opening* opening) { return !is_high_and_level(part, *opening); });
  return openings.empty() ? nullptr : *std::ranges::max_element(openings, {}, &Opening::mean_height_m);
}

const Opening* inner_opening(const GarmentPart& part) {
  const std::vector<const Opening*> openings = carrying_openings(part);
  return openings.empty() ? nullptr : *std::ranges::min_element(openings, {}, &Opening::length_m);
}

bool has_sleeves(const GarmentPart& part) {
  return std::ranges::any_of(large_openings(part),
                             [&](const Opening* opening) { return !is_near_middle(part, *opening); });
}

std::vector<sim::Index> pair_of_openings(const GarmentPart& part) {
  const std::vector<const Opening*> large = large_openings(part);
  std::vector<sim::Index> pair;
  double max_height_m = 0.0;
  for (std::size_t i = 0; i < large.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double height_m = large[i]->mean_height_m + large[k]->mean_height_m - 2.0 * part.range.lower.y;
      if (are_a_pair(part, *large[i], *large[k]) && height_m > max_height_m) {
        max_height_m = height_m;
        pair = large[i]->vertices;
        pair.insert(pair.end(), large[k]->vertices.begin(), large[k]->vertices.end());
      }
    }
  }
  return pair;
}

}  // namespace taut::app
