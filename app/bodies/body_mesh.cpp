#include "app/bodies/body_mesh.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/garments/fitting/fitted_mesh.hpp"
#include "app/garments/fitting/sheets.hpp"
#include "sim/mesh/extent.hpp"
#include "sim/mesh/topology.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

struct ClosedHole {
  double border_length = 0.0;  ///< length of its border, in the unit of the mesh
  sim::Index vertex = 0;       ///< index of a vertex of its border
};

using Loop = std::vector<sim::Index>;

double length_around(const sim::Mesh& mesh, const Loop& loop) {
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    length += glm::distance(mesh.positions[loop[i]], mesh.positions[loop[(i + 1) % loop.size()]]);
  }
  return length;
}

/// Returns a fan of triangles from one vertex of the loop, oriented against the border.
std::vector<sim::Triangle> fan_from(std::size_t apex, const Loop& loop) {
  std::vector<sim::Triangle> fan;
  for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
    fan.push_back({loop[apex], loop[(apex + k + 1) % loop.size()], loop[(apex + k) % loop.size()]});
  }
  return fan;
}

bool has_edge_from(sim::Index vertex, const Loop& loop, const sim::Adjacency& adjacency) {
  std::size_t shared = 0;
  for (const sim::Index e : adjacency.vertex_edges[vertex]) {
    const sim::Index other = sim::other_end(adjacency.edges[e], vertex);
    shared += std::ranges::find(loop, other) != loop.end() ? 1 : 0;
  }
  return shared > 2;  // the other two are edges of the border
}

std::vector<sim::Triangle> best_fan(const sim::Mesh& mesh, const sim::Adjacency& adjacency, const Loop& loop) {
  std::vector<sim::Triangle> best;
  double best_area = 0.0;
  for (std::size_t apex = 0; apex < loop.size(); ++apex) {
    if (!has_edge_from(loop[apex], loop, adjacency)) {
      std::vector<sim::Triangle> fan = fan_from(apex, loop);
      double smallest = std::numeric_limits<double>::infinity();
      for (const sim::Triangle& t : fan) {
        smallest = std::min(smallest, glm::length(sim::doubled_area_vector(mesh.positions, t)));
      }
      if (smallest > best_area) {
        best_area = smallest;
        best = std::move(fan);
      }
    }
  }
  return best;
}

/// Returns whether the loop is the border of a single triangle, which looks like a hole of three edges.
bool is_lone_triangle(const Loop& loop, const sim::Adjacency& adjacency) {
  return loop.size() == 3 &&
         std::ranges::all_of(loop, [&](sim::Index v) { return adjacency.vertex_edges[v].size() == 2; });
}

/// Closes each hole of the mesh whose border is at most `longest` long, in the unit of the mesh, by a fan of triangles.
/// The fan starts at the vertex of the border for which the smallest triangle has the largest area. No vertex is added.
/// A hole is left open if its border touches itself, or if each fan would have a triangle without area or an edge that
/// the mesh has. Returns the closed holes, the largest first. Requires a mesh whose triangles are oriented like their
/// neighbours.
std::vector<ClosedHole> close_small_holes(double longest, sim::Mesh& mesh) {
  const sim::Adjacency adjacency = sim::make_adjacency(mesh);
  std::vector<ClosedHole> closed;
  for (const Loop& loop : border_loops(mesh)) {
    const double around = length_around(mesh, loop);
    if (loop.size() < 3 || !(around <= longest) || is_lone_triangle(loop, adjacency)) continue;
    const std::vector<sim::Triangle> fan = best_fan(mesh, adjacency, loop);
    if (!fan.empty()) {
      mesh.triangles.insert(mesh.triangles.end(), fan.begin(), fan.end());
      closed.push_back({around, loop.front()});
    }
  }
  std::ranges::stable_sort(closed, std::greater{}, &ClosedHole::border_length);
  return closed;
}

struct FlatFaces {
  std::size_t drop_degenerate = 0;  ///< triangles with two or three corners at one position, which are left out
  std::size_t turned = 0;           ///< triangles with their corners in a line, whose long edge was flipped
};

using Places = std::vector<sim::Index>;

/// Passes of edge flips; adjacent flat triangles need several.
constexpr int max_passes = 8;

/// Returns the triangle rotated so that the corner opposite its longest edge comes first.
sim::Triangle rotate_to_middle_corner(const sim::Mesh& soup, const sim::Triangle& t) {
  const auto across = [&](std::size_t k) {
    return glm::distance(soup.positions[t[(k + 1) % 3]], soup.positions[t[(k + 2) % 3]]);
  };
  const std::size_t k = across(0) >= across(1) && across(0) >= across(2) ? 0 : across(1) >= across(2) ? 1 : 2;
  return {t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
}

/// Merges the ends of each edge without length and leaves out the triangles at it. Returns how many were left out.
std::size_t drop_degenerate(const Places& places, sim::Mesh& soup) {
  sim::Groups same(soup.positions.size());
  for (const auto& [a, b, c] : soup.triangles) {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      if (places[from] == places[to]) same.join(from, to);
    }
  }
  return merge_vertices(same, soup.triangles);
}

std::size_t turn_once(const Places& places, sim::Mesh& soup) {
  std::vector<std::size_t> flat;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    if (!sim::has_area(soup.positions, soup.triangles[t])) flat.push_back(t);
  }
  if (flat.empty()) return 0;
  const sim::Adjacency adjacency = sim::make_adjacency(sim::renumber_corners(soup, places));
  std::vector<char> is_changed(soup.triangles.size(), 0);
  std::size_t turned = 0;
  for (const std::size_t t : flat) {
    const auto [middle, from, to] = rotate_to_middle_corner(soup, soup.triangles[t]);
    const auto both = adjacency.edge_triangles[sim::edge_between(adjacency, places[from], places[to])];
    if (both.size() != 2 || is_changed[both[0]] || is_changed[both[1]]) continue;
    const sim::Index across = both[0] == t ? both[1] : both[0];
    const sim::Triangle& other = soup.triangles[across];
    const auto far = std::ranges::find_if(other, [&, from = from, to = to](sim::Index v) {
      return places[v] != places[from] && places[v] != places[to];
    });
    if (far == other.end()) continue;
    const sim::Triangle first = {from, *far, middle};
    const sim::Triangle second = {*far, to, middle};
    if (!sim::has_area(soup.positions, first) && !sim::has_area(soup.positions, second)) continue;
    soup.triangles[t] = first;
    soup.triangles[across] = second;
    is_changed[t] = is_changed[across] = 1;
    ++turned;
  }
  return turned;
}

/// Mends triangles without area, which remeshing, splitting of polygons and rounded numbers cause. The ends of an edge
/// without length become one vertex, and its triangles are left out. If the corners of a triangle lie in a line, its
/// long edge is flipped: the triangle and its neighbour become two triangles that meet at the middle corner. The
/// triangle stays if that edge has not two triangles, or if a flip does not help. No vertex is moved and no hole is
/// made.
FlatFaces mend_flat_faces(sim::Mesh& soup) {
  const Places places = sim::first_at_same_position(soup.positions);
  FlatFaces mended{drop_degenerate(places, soup), 0};
  for (int round = 0; round < max_passes; ++round) {
    const std::size_t now = turn_once(places, soup);
    mended.turned += now;
    if (now == 0) break;
  }
  return mended;
}

// A body whose file names no unit is in metres, unless that would exceed `max_size_m` and another unit would give it
// the size of a person.
constexpr double max_size_m = 20.0;
constexpr double min_person_m = 0.5;
constexpr double max_person_m = 2.5;
// A body longer along z than along the other axes by this factor, with y up, probably lies on its back.
constexpr double lying_length_ratio = 2.0;

/// Reports positions in the file's unit and axes, where they can be looked up.
void require_area(const sim::Mesh& soup) {
  for (const sim::Triangle& t : soup.triangles) {
    if (!sim::has_area(soup.positions, t)) {
      throw InputError("found a face without area at " + describe_point(soup.positions[t[0]]) +
                       ", expected faces that are neither points nor lines");
    }
  }
}

void require_closed(const sim::Mesh& mesh) {
  const sim::Adjacency adjacency = sim::make_adjacency(mesh);
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const auto [a, b] = adjacency.edges[e];
    const auto triangles = adjacency.edge_triangles[e];
    const std::string edge =
        "the edge from " + describe_point(mesh.positions[a]) + " to " + describe_point(mesh.positions[b]);
    if (triangles.size() != 2) {
      throw InputError("found {} with {}, expected two at every edge: {}", edge,
                       count_text(triangles.size(), "triangle"),
                       triangles.size() == 1 ? "a body has no holes" : "a body has one surface");
    }
    if (sim::is_misoriented(mesh, adjacency, e)) {
      throw InputError("found triangles that face different sides at " + edge +
                       ", expected a surface with an inside and an outside");
    }
  }
}

/// Flips the triangles of each component that encloses a negative volume.
void face_outwards(sim::Mesh& mesh) {
  sim::Groups parts = sim::connect_vertices(mesh.positions.size(), mesh.triangles);
  std::vector<double> volumes(mesh.positions.size(), 0.0);
  for (const auto& [a, b, c] : mesh.triangles) {
    const sim::Index part = parts.find(a);
    const sim::Vec3& origin = mesh.positions[part];
    volumes[part] +=
        glm::dot(mesh.positions[a] - origin, glm::cross(mesh.positions[b] - origin, mesh.positions[c] - origin));
  }
  for (sim::Triangle& t : mesh.triangles) {
    if (volumes[parts.find(t[0])] < 0.0) std::swap(t[1], t[2]);
  }
}

double choose_unit(const BodySource& source, const ImportedModel& model, double size,
                   std::vector<std::string>& remarks) {
  if (source.scale || model.metres_per_unit || size <= max_size_m) {
    return source.scale.value_or(model.metres_per_unit.value_or(1.0));
  }
  for (const Unit& unit : units) {
    if (size * unit.metres >= min_person_m && size * unit.metres <= max_person_m) {
      remarks.push_back(fmt::format(
          "its unit is the {}, guessed: in metres it would be {:.3g} m large (scale, --body-units)", unit.name, size));
      return unit.metres;
    }
  }
  return 1.0;
}

Placement choose_placement(const BodySource& source, const ImportedModel& model, const sim::Mesh& mesh,
                           std::vector<std::string>& remarks) {
  const sim::Vec3 size = sim::compute_extent(mesh.positions).size();
  const double scale = choose_unit(source, model, std::max({size.x, size.y, size.z}), remarks);
  Placement placement = place_model(mesh, {scale, source.up.value_or(model.up.value_or(ModelAxis::y)), {}, {}});
  placement.moved_m = sim::Vec3(0.0);
  if (!source.up && !model.up && size.z > lying_length_ratio * size.y && size.z > lying_length_ratio * size.x) {
    remarks.push_back(fmt::format("it is {:.3g} m along z and {:.3g} m along y, which is taken as up (up, --body-up)",
                                  size.z * scale, size.y * scale));
  }
  return placement;
}

sim::ValidatedMesh closed_mesh(const sim::Mesh& soup, const Placement& placement, std::vector<std::string>& remarks) {
  sim::ValidatedMesh valid = sim::weld_and_validate(soup);
  if (valid.report.duplicate_triangles > 0) {
    throw InputError("found a triangle that is there twice, expected each once");
  }
  const std::vector<ClosedHole> closed = close_small_holes(max_border_m / placement.scale, valid.mesh);
  if (!closed.empty()) {
    remarks.push_back(
        fmt::format("{} closed, {} {:.3g} m around at {}", count_text(closed.size(), "hole was", "holes were"),
                    closed.size() == 1 ? "it is" : "the largest is", closed.front().border_length * placement.scale,
                    describe_place(placement(valid.mesh.positions[closed.front().vertex]))));
  }
  require_closed(valid.mesh);
  face_outwards(valid.mesh);
  return valid;
}

}  // namespace

LoadedMesh make_body_mesh(const BodySource& source, const ImportedModel& model) try {
  LoadedMesh loaded;
  if (!model.is_importer_confined) loaded.remarks.emplace_back(importer_remark);
  sim::Mesh soup{model.positions, model.triangles, {}};
  const FlatFaces mended = mend_flat_faces(soup);
  if (mended.drop_degenerate + mended.turned > 0) {
    loaded.remarks.push_back(
        fmt::format("of its faces without area {} left out and {} turned", mended.drop_degenerate, mended.turned));
  }
  require_area(soup);
  loaded.places.placement = choose_placement(source, model, soup, loaded.remarks);
  sim::ValidatedMesh valid = closed_mesh(soup, loaded.places.placement, loaded.remarks);
  loaded.mesh = std::move(valid.mesh);
  loaded.places.file_vertex.resize(loaded.mesh.positions.size());
  loaded.file_vertices =
      model.position_of_vertex.empty() ? valid.result_vertices.size() : model.position_of_vertex.size();
  for (std::size_t v = loaded.file_vertices; v-- > 0;) {
    const sim::Index vertex = valid.result_vertices[model.position_of_vertex.empty() ? v : model.position_of_vertex[v]];
    if (vertex != sim::no_vertex) loaded.places.file_vertex[vertex] = v;
  }
  for (sim::Vec3& position : loaded.mesh.positions) position = loaded.places.placement(position);
  return loaded;
} catch (const std::exception& error) {
  throw InputError('\'' + source.file.string() + "': " + error.what());
}

}  // namespace taut::app
