#include "app/bodies/body_mesh.hpp"

#include <fmt/core.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "app/base/counted.hpp"
#include "app/base/errors.hpp"
#include "app/bodies/flat_faces.hpp"
#include "app/bodies/hole_closing.hpp"
#include "app/verify/crossing_pairs.hpp"
#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/extent.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/mesh/topology.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

// A body whose file names no unit is in metres, unless it would then be larger than any and a person in
// another unit.
constexpr double largest_m = 20.0;
constexpr double smallest_person_m = 0.5;
constexpr double largest_person_m = 2.5;
// Longer along z by this factor, with y up, it probably lies on its back.
constexpr double clearly_longer = 2.0;

/// Places in messages are in the file's unit and axes, where they can be looked up.
void require_area(const sim::Mesh& soup) {
  for (const sim::Triangle& t : soup.triangles) {
    for (const sim::Index v : t) {
      const sim::Vec3& p = soup.positions[v];
      if (!std::isfinite(p.x + p.y + p.z)) {
        throw InputError("found a vertex at " + describe_point(p) + ", expected numbers");
      }
    }
    const sim::Vec3 area = sim::doubled_area_vector(soup.positions, t);
    if (!(glm::dot(area, area) > 0.0)) {
      throw InputError("found a face without area at " + describe_point(soup.positions[t[0]]) +
                       ", expected faces that are neither points nor lines");
    }
  }
}

void require_closed(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const auto [a, b] = adjacency.edges[e];
    const auto triangles = adjacency.edge_triangles[e];
    const std::string edge =
        "the edge from " + describe_point(mesh.positions[a]) + " to " + describe_point(mesh.positions[b]);
    if (triangles.size() != 2) {
      throw InputError(fmt::format("found {} with {}, expected two at every edge: {}", edge,
                                   counted(triangles.size(), "triangle"),
                                   triangles.size() == 1 ? "a body has no holes" : "a body has one surface"));
    }
    if (sim::runs_along(mesh.triangles[triangles[0]], adjacency.edges[e]) ==
        sim::runs_along(mesh.triangles[triangles[1]], adjacency.edges[e])) {
      throw InputError("found triangles that face different sides at " + edge +
                       ", expected a surface with an inside and an outside");
    }
  }
}

/// Turns each part that encloses a negative volume inside out.
void face_outwards(const sim::Adjacency& adjacency, sim::Mesh& mesh) {
  sim::Groups parts(mesh.positions.size());
  for (const auto& [a, b] : adjacency.edges) {
    parts.join(a, b);
  }
  std::vector<double> volumes(mesh.positions.size(), 0.0);
  for (const auto& [a, b, c] : mesh.triangles) {
    const sim::Index part = parts.find(a);
    const sim::Vec3& origin = mesh.positions[part];
    volumes[part] += glm::dot(mesh.positions[a] - origin,
                              glm::cross(mesh.positions[b] - origin, mesh.positions[c] - origin));
  }
  for (sim::Triangle& t : mesh.triangles) {
    if (volumes[parts.find(t[0])] < 0.0) {
      std::swap(t[1], t[2]);
    }
  }
}

double unit_of(const BodySource& source, const ImportedModel& model, double size,
               std::vector<std::string>& remarks) {
  if (source.scale || model.metres_per_unit || size <= largest_m) {
    return source.scale.value_or(model.metres_per_unit.value_or(1.0));
  }
  for (const Unit& unit : units) {
    if (size * unit.metres >= smallest_person_m && size * unit.metres <= largest_person_m) {
      remarks.push_back(
          fmt::format("its unit is the {}, guessed: in metres it would be {:.3g} m large "
                      "(scale, --body-units)",
                      unit.name, size));
      return unit.metres;
    }
  }
  return 1.0;
}

Placement placement_of(const BodySource& source, const ImportedModel& model, const sim::Mesh& mesh,
                       std::vector<std::string>& remarks) {
  const sim::Vec3 size = sim::extent_of(mesh.positions).size();
  const double scale = unit_of(source, model, std::max({size.x, size.y, size.z}), remarks);
  Placement placement =
      place_model(mesh, {scale, source.up.value_or(model.up.value_or(ModelAxis::y)), {}, {}});
  placement.moved_m = sim::Vec3(0.0);
  if (!source.up && !model.up && size.z > clearly_longer * size.y && size.z > clearly_longer * size.x) {
    remarks.push_back(
        fmt::format("it is {:.3g} m along z and {:.3g} m along y, which is taken as up "
                    "(up, --body-up)",
                    size.z * scale, size.y * scale));
  }
  return placement;
}

sim::Mesh closed_mesh(const sim::Mesh& soup, const Placement& placement, std::vector<sim::Index>& kept,
                      std::vector<std::string>& remarks) {
  sim::ValidatedMesh valid = sim::weld_and_validate(soup, {}, kept);
  if (valid.report.duplicate_triangles > 0) {
    throw InputError("found a triangle that is there twice, expected each once");
  }
  const std::vector<ClosedHole> closed = close_small_holes(longest_border_m / placement.scale, valid.mesh);
  if (!closed.empty()) {
    remarks.push_back(
        fmt::format("{} closed, {} {:.3g} m around at {}", counted(closed.size(), "hole was", "holes were"),
                    closed.size() == 1 ? "it is" : "the largest is", closed.front().around * placement.scale,
                    describe_place(placement(valid.mesh.positions[closed.front().vertex]))));
  }
  const sim::Adjacency adjacency = sim::make_adjacency(valid.mesh);
  require_closed(valid.mesh, adjacency);
  face_outwards(adjacency, valid.mesh);
  return std::move(valid.mesh);
}

}  // namespace

LoadedMesh make_body_mesh(const BodySource& source, const ImportedModel& model) try {
  LoadedMesh loaded;
  sim::Mesh soup{model.positions, model.triangles, {}};
  const FlatFaces mended = mend_flat_faces(soup);
  if (mended.left_out + mended.turned > 0) {
    loaded.remarks.push_back(
        fmt::format("of its faces without area {} left out and {} turned", mended.left_out, mended.turned));
  }
  require_area(soup);
  loaded.places.placement = placement_of(source, model, soup, loaded.remarks);
  std::vector<sim::Index> kept;
  loaded.mesh = closed_mesh(soup, loaded.places.placement, kept, loaded.remarks);
  loaded.places.file_vertex.resize(loaded.mesh.positions.size());
  loaded.file_vertices = model.position_of_vertex.empty() ? kept.size() : model.position_of_vertex.size();
  for (std::size_t v = loaded.file_vertices; v-- > 0;) {
    const sim::Index vertex = kept[model.position_of_vertex.empty() ? v : model.position_of_vertex[v]];
    if (vertex != sim::no_vertex) {
      loaded.places.file_vertex[vertex] = v;
    }
  }
  for (sim::Vec3& position : loaded.mesh.positions) {
    position = loaded.places.placement(position);
  }
  return loaded;
} catch (const std::exception& error) {
  throw InputError('\'' + source.file.string() + "': " + error.what());
}

}  // namespace taut::app
