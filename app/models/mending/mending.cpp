#include "app/models/mending/mending.hpp"

#include "app/base/words.hpp"
#include "app/garments/fitting/following.hpp"
#include "app/garments/fitting/sheets.hpp"
#include "app/models/mending/tuning.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {

using namespace mending;

namespace {

struct Patch {
  sim::Vec3 middle;
  double area;
};

/// Returns the interval along an axis that contains nearly all of the area.
std::pair<double, double> bulk_along(int axis, const std::vector<Patch>& patches, double area) {
  std::vector<std::pair<double, double>> places;
  for (const Patch& patch : patches) places.emplace_back(patch.middle[axis], patch.area);
  std::ranges::sort(places);
  const auto beyond = [&](auto first, auto last) {
    double sum = 0.0;
    for (auto place = first; place != last; ++place) {
      sum += place->second;
      if (sum > max_outlying_fraction * area) return place->first;
    }
    return first->first;
  };
  return {beyond(places.begin(), places.end()), beyond(places.rbegin(), places.rend())};
}

/// Returns whether the part encloses much space and has at most one opening that is no small hole.
bool is_thick(const GarmentPart& part, double max_opening, const sim::Mesh& mesh) {
  double length = 0.0;
  sim::Vec3 middle = part.centre_m;  // of its largest opening, so that the volume is that up to there
  double max_length = 0.0;
  for (const Opening& opening : part.openings) {
    length += opening.length_m;
    if (opening.length_m > max_length) middle = opening.range.middle();
    max_length = std::max(max_length, opening.length_m);
  }
  const double volumes = six_times_volume(mesh, part.triangles, middle);
  const double root = std::sqrt(part.area_m2);
  return max_length <= max_opening * root && length - max_length <= max_holes_length * root &&
         std::numbers::pi * volumes * volumes >= min_compactness * std::pow(part.area_m2, 3);
}

/// Returns the fraction of the part's vertices that lie near the surface.
double share_near(const GarmentPart& part, const SurfaceTree& surface, const sim::Mesh& mesh) {
  const std::size_t step = 1 + part.vertices.size() / max_places_below_cloth;
  std::size_t near = 0, looked = 0;
  for (std::size_t k = 0; k < part.vertices.size(); k += step, ++looked) {
    near += surface.find_nearest(mesh.positions[part.vertices[k]], max_below_cloth_distance * part.size_m(), accept_all)
                .has_value();
  }
  return static_cast<double>(near) / static_cast<double>(looked);
}

/// Groups triangles that are connected across edges with two triangles. At other edges no sides correspond.
sim::Groups find_surfaces(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  sim::Groups surfaces(mesh.triangles.size());
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const auto pair = adjacency.edge_triangles[e];
    if (pair.size() == 2) surfaces.join(pair[0], pair[1]);
  }
  return surfaces;
}

struct SurfaceFacing {
  double outwards = 0.0;  ///< sum over the triangles, 6 times the volume of a closed surface
  double all = 0.0;       ///< sum of the absolute values
};

/// A vertex of a trim, and the triangle of cloth below it.
struct StitchPlace {
  sim::Index vertex;
  sim::Index triangle;
  double distance;
};

/// Returns places far from each other: the nearest to the cloth, then each time the farthest from the places before.
std::vector<StitchPlace> find_stitches(const std::vector<StitchPlace>& places, std::size_t max_stitches,
                                       const sim::Mesh& mesh) {
  std::vector<StitchPlace> stitches;
  const auto nearer = [](const StitchPlace& a, const StitchPlace& b) { return a.distance < b.distance; };
  stitches.push_back(*std::ranges::min_element(places, nearer));
  // Distance of each place from the nearest stitch.
  std::vector<double> distances(places.size(), std::numeric_limits<double>::infinity());
  while (stitches.size() < max_stitches) {
    for (std::size_t k = 0; k < places.size(); ++k) {
      const sim::Vec3 &place = mesh.positions[places[k].vertex], &last = mesh.positions[stitches.back().vertex];
      distances[k] = std::min(distances[k], glm::distance(place, last));
    }
    const auto farthest = std::ranges::max_element(distances);
    if (!(*farthest > 0.0)) break;
    stitches.push_back(places[static_cast<std::size_t>(farthest - distances.begin())]);
  }
  return stitches;
}

/// Returns the largest triangle from the vertex to two corners of the cloth below, facing the side of the cloth.
sim::Triangle stitch_at(const StitchPlace& place, const sim::Mesh& mesh) {
  const sim::Triangle& below = mesh.triangles[place.triangle];
  std::array<sim::Triangle, 3> stitches{};
  for (int k = 0; k < 3; ++k) stitches[k] = {place.vertex, below[k], below[(k + 1) % 3]};
  return *std::ranges::max_element(stitches, {},
                                   [&](const sim::Triangle& t) { return triangle_area(mesh.positions, t); });
}

}  // namespace

Strays remove_strays(sim::Mesh& mesh) {
  const auto patches = collect<Patch>(mesh.triangles, [&](const sim::Triangle& t) {
    return Patch{triangle_middle(mesh.positions, t), triangle_area(mesh.positions, t)};
  });
  double area = 0.0;
  bool are_finite = true;
  for (const Patch& patch : patches) {
    area += patch.area;
    are_finite = are_finite && std::isfinite(patch.middle.x + patch.middle.y + patch.middle.z);
  }
  Strays strays;
  if (!are_finite || !std::isfinite(area) || !(area > 0.0)) return strays;
  sim::Extent bulk;
  for (int axis = 0; axis < 3; ++axis) {
    std::tie(bulk.lower[axis], bulk.upper[axis]) = bulk_along(axis, patches, area);
  }
  const sim::Vec3 size = bulk.size();
  const double reach = min_stray_distance * std::max({size.x, size.y, size.z});
  const sim::Extent near{bulk.lower - reach, bulk.upper + reach};
  std::vector<char> is_near(mesh.positions.size(), 0);
  sim::Groups pieces = sim::find_pieces(mesh);
  for (std::size_t t = 0; t < patches.size(); ++t) {
    if (sim::overlap({patches[t].middle, patches[t].middle}, near)) {
      is_near[pieces.find(mesh.triangles[t][0])] = 1;
    }
  }
  const auto is_stray = [&](const sim::Triangle& t) { return is_near[pieces.find(t[0])] == 0; };
  for (std::size_t t = 0; t < patches.size(); ++t) {
    if (!is_stray(mesh.triangles[t])) continue;
    strays.area_share += patches[t].area / area;
    strays.distance = std::max(strays.distance, glm::distance(patches[t].middle, bulk.middle()));
  }
  strays.triangles = std::erase_if(mesh.triangles, is_stray);
  return strays;
}

std::string describe(const Strays& strays, double metres_per_unit) {
  return fmt::format("{} with {:.2g} % of its area {} {:.3g} m away and {} left out",
                     count_text(strays.triangles, "triangle"), 100.0 * strays.area_share,
                     strays.triangles == 1 ? "lies" : "lie", strays.distance * metres_per_unit,
                     strays.triangles == 1 ? "is" : "are");
}

RigidParts remove_rigid_parts(sim::Mesh& mesh) {
  RigidParts rigid;
  const sim::ValidatedMesh valid = sim::weld_and_validate(mesh);
  const std::vector<GarmentPart> parts = find_garment_parts(valid.mesh, sim::make_adjacency(valid.mesh));
  double area = 0.0, cloth_area = 0.0;
  std::vector<sim::Triangle> cloth;
  std::vector<const GarmentPart*> thick;
  for (const GarmentPart& part : parts) {
    area += part.area_m2;
    if (is_thick(part, max_end_length, valid.mesh)) {
      thick.push_back(&part);
      continue;
    }
    cloth_area += part.area_m2;
    for (const sim::Index t : part.triangles) cloth.push_back(valid.mesh.triangles[t]);
  }
  rigid.are_all = cloth_area < min_cloth_area_fraction * area;
  if (thick.empty() || rigid.are_all) return rigid;
  const SurfaceTree tree(valid.mesh.positions, cloth);
  std::vector<char> is_rigid(valid.mesh.positions.size(), 0);
  for (const GarmentPart* part : thick) {
    const bool is_closed = is_thick(*part, max_holes_length, valid.mesh);
    const bool is_small = part->area_m2 < (is_closed ? min_rigid_area_on_cloth : min_rigid_area_with_end) * area;
    const double near = share_near(*part, tree, valid.mesh);
    if (is_closed ? is_small && near > 0.0 : is_small || near < min_below_cloth_fraction) continue;
    ++rigid.count;
    rigid.area_share += part->area_m2 / area;
    for (const sim::Index v : part->vertices) is_rigid[v] = 1;
  }
  std::erase_if(mesh.triangles, [&](const sim::Triangle& t) {
    const sim::Index v = valid.result_vertices[t[0]];
    const bool is_left_out = v != sim::no_vertex && is_rigid[v] != 0;
    if (is_left_out) rigid.mesh.triangles.push_back(t);
    return is_left_out;
  });
  if (rigid.count > 0) rigid.mesh.positions = mesh.positions;
  return rigid;
}

std::string describe(const RigidParts& rigid) {
  return fmt::format("{} with {:.2g} % of its area {} no cloth, but closed and thick, like a stand or a body, and {}",
                     count_text(rigid.count, "part"), 100.0 * rigid.area_share, rigid.count == 1 ? "is" : "are",
                     rigid.is_body ? "cloth cannot enter" : "left out");
}

std::size_t turn_outside_out(std::span<const GarmentPart> parts, const sim::Adjacency& adjacency, sim::Mesh& mesh) {
  sim::Groups surfaces = find_surfaces(mesh, adjacency);
  std::size_t turned = 0;
  for (const GarmentPart& part : parts) {
    if (part.openings.size() == 1) continue;
    std::map<sim::Index, SurfaceFacing> facings;
    for (const sim::Index t : part.triangles) {
      const sim::Vec3 out = mesh.positions[mesh.triangles[t][0]] - part.centre_m;
      const double outwards = glm::dot(sim::doubled_area_vector(mesh.positions, mesh.triangles[t]), out);
      SurfaceFacing& facing = facings[surfaces.find(t)];
      facing.outwards += outwards;
      facing.all += std::abs(outwards);
    }
    const double limit = part.openings.empty() && facings.size() == 1 ? 0.0 : min_outward_fraction;
    for (const sim::Index t : part.triangles) {
      const SurfaceFacing& facing = facings[surfaces.find(t)];
      if (facing.outwards < limit * facing.all) {
        std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
        ++turned;
      }
    }
  }
  return turned;
}

std::size_t sew_on_trims(std::span<const GarmentPart> parts, double metres_per_unit, sim::Mesh& mesh) {
  double area = 0.0;
  for (const GarmentPart& part : parts) area += part.area_m2;
  const auto is_trim = [&](const GarmentPart& part) { return part.area_m2 <= max_trim_area_fraction * area; };
  if (std::ranges::none_of(parts, is_trim) || std::ranges::all_of(parts, is_trim)) return 0;
  const double farthest = max_trim_distance_m / metres_per_unit;
  std::vector<sim::Index> cloth;
  for (const GarmentPart& part : parts) {
    if (!is_trim(part)) cloth.insert(cloth.end(), part.triangles.begin(), part.triangles.end());
  }
  std::ranges::sort(cloth);
  const auto triangles = collect<sim::Triangle>(cloth, [&](sim::Index t) { return mesh.triangles[t]; });
  const SurfaceTree tree(mesh.positions, triangles);
  std::vector<sim::Triangle> stitches;
  std::size_t sewn_on = 0;
  for (const GarmentPart& part : parts) {
    std::vector<StitchPlace> places;
    for (const sim::Index v : is_trim(part) ? part.vertices : std::vector<sim::Index>{}) {
      const auto below = tree.find_nearest(mesh.positions[v], farthest, accept_all);
      if (below) places.push_back({v, cloth[below->triangle], below->distance_m});
    }
    if (!places.empty()) {
      ++sewn_on;
      const auto more = static_cast<std::size_t>(part.area_m2 / (stitch_area_fraction * area));
      for (const StitchPlace& place : find_stitches(places, min_stitches + more, mesh)) {
        stitches.push_back(stitch_at(place, mesh));
      }
    }
  }
  mesh.triangles.insert(mesh.triangles.end(), stitches.begin(), stitches.end());
  return sewn_on;
}

}  // namespace taut::app
