#include "app/models/body_loading.hpp"

#include <fmt/core.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <utility>

#include "app/base/counted.hpp"
#include "app/base/errors.hpp"
#include "app/models/garment_import.hpp"
#include "app/models/pc2_reading.hpp"
#include "app/models/placement.hpp"
#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/mesh/topology.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

/// The furthest a vertex goes from one frame to the next, in m. Further, the frames are of something else.
constexpr double furthest_m = 1.0;

std::string at(const sim::Vec3& place) {
  return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", place.x, place.y, place.z);
}

/// A body's mesh, and what became of the vertices of its file.
struct LoadedMesh {
  sim::Mesh mesh;
  Placement placement;
  /// Per vertex of the mesh, the first vertex of the file that became it.
  std::vector<std::size_t> file_vertex;
  std::size_t file_vertices = 0;
};

/// Places in messages are in the file's unit and axes, where they can be looked up.
void require_area(const sim::Mesh& soup) {
  for (const sim::Triangle& t : soup.triangles) {
    for (const sim::Index v : t) {
      const sim::Vec3& p = soup.positions[v];
      if (!std::isfinite(p.x + p.y + p.z)) {
        throw InputError("found a vertex at " + at(p) + ", expected numbers");
      }
    }
    const sim::Vec3 area = sim::doubled_area_vector(soup.positions, t);
    if (!(glm::dot(area, area) > 0.0)) {
      throw InputError("found a face without area at " + at(soup.positions[t[0]]) +
                       ", expected faces that are neither points nor lines");
    }
  }
}

void require_closed(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const auto [a, b] = adjacency.edges[e];
    const auto triangles = adjacency.edge_triangles[e];
    const std::string edge = "the edge from " + at(mesh.positions[a]) + " to " + at(mesh.positions[b]);
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

template <class Work>
auto naming(const std::filesystem::path& file, const Work& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    throw InputError('\'' + file.string() + "': " + error.what());
  }
}

sim::Mesh closed_mesh(const sim::Mesh& soup, std::vector<sim::Index>& kept) {
  require_area(soup);
  sim::ValidatedMesh valid = sim::weld_and_validate(soup, {}, kept);
  if (valid.report.duplicate_triangles > 0) {
    throw InputError("found a triangle that is there twice, expected each once");
  }
  const sim::Adjacency adjacency = sim::make_adjacency(valid.mesh);
  require_closed(valid.mesh, adjacency);
  face_outwards(adjacency, valid.mesh);
  return std::move(valid.mesh);
}

LoadedMesh load_mesh(const BodySource& source) {
  ImportedModel model = import_garment(source.file);
  LoadedMesh loaded;
  std::vector<sim::Index> kept;
  const sim::Mesh soup{std::move(model.positions), std::move(model.triangles), {}};
  loaded.mesh = naming(source.file, [&] { return closed_mesh(soup, kept); });
  // Nothing is guessed: a body has no usual size.
  loaded.placement = place_model(loaded.mesh, {source.scale.value_or(model.metres_per_unit.value_or(1.0)),
                                               source.up.value_or(model.up.value_or(ModelAxis::y)),
                                               {},
                                               {}});
  loaded.placement.moved_m = sim::Vec3(0.0);
  loaded.file_vertex.resize(loaded.mesh.positions.size());
  loaded.file_vertices = model.position_of_vertex.empty() ? kept.size() : model.position_of_vertex.size();
  for (std::size_t v = loaded.file_vertices; v-- > 0;) {
    const sim::Index vertex = kept[model.position_of_vertex.empty() ? v : model.position_of_vertex[v]];
    if (vertex != sim::no_vertex) {
      loaded.file_vertex[vertex] = v;
    }
  }
  return loaded;
}

std::vector<sim::Vec3> placed(const LoadedMesh& loaded, const std::vector<sim::Vec3>& in_file) {
  std::vector<sim::Vec3> positions_m;
  positions_m.reserve(loaded.file_vertex.size());
  for (const std::size_t v : loaded.file_vertex) {
    positions_m.push_back(loaded.placement(in_file[v]));
  }
  return positions_m;
}

void require_near(const LoadedMesh& loaded, std::size_t frame, const std::vector<sim::Vec3>& before_m,
                  const std::vector<sim::Vec3>& positions_m) {
  for (std::size_t v = 0; v < positions_m.size(); ++v) {
    const double moved_m = glm::distance(before_m[v], positions_m[v]);
    if (!(moved_m <= furthest_m)) {
      throw InputError(
          fmt::format("frame {}, vertex {}: found at {} m, {:.3g} m from where it is in the frame before, "
                      "expected at most "
                      "{:g} m",
                      frame, loaded.file_vertex[v], at(positions_m[v]), moved_m, furthest_m));
    }
  }
}

std::shared_ptr<const sim::BodyFrames> placed_frames(const std::vector<std::vector<sim::Vec3>>& in_files_unit,
                                                     const BodySource& source, const LoadedMesh& loaded) {
  sim::BodyFrames frames{source.frame_rate_hz, {}};
  for (const std::vector<sim::Vec3>& in_file : in_files_unit) {
    if (in_file.size() != loaded.file_vertices) {
      throw InputError(fmt::format("found {}, expected the {} of '{}', in their order",
                                   counted(in_file.size(), "vertex", "vertices"), loaded.file_vertices,
                                   source.file.string()));
    }
    frames.positions_m.push_back(placed(loaded, in_file));
    if (frames.positions_m.size() > 1) {
      require_near(loaded, frames.positions_m.size() - 1, *(frames.positions_m.end() - 2),
                   frames.positions_m.back());
    }
  }
  return std::make_shared<const sim::BodyFrames>(std::move(frames));
}

sim::BodyMesh load_body(const BodySource& source) {
  LoadedMesh loaded = load_mesh(source);
  sim::BodyMesh body;
  if (!source.frames.empty()) {
    const auto frames = read_pc2(source.frames);
    body.frames = naming(source.frames, [&] { return placed_frames(frames, source, loaded); });
  }
  for (sim::Vec3& position : loaded.mesh.positions) {
    position = loaded.placement(position);
  }
  body.data = std::make_shared<const sim::BodyMeshData>(
      sim::BodyMeshData{std::move(loaded.mesh.positions), std::move(loaded.mesh.triangles)});
  return body;
}

}  // namespace

void load_bodies(Scene& scene) {
  for (std::size_t k = 0; k < scene.surroundings.bodies.size(); ++k) {
    sim::Body& body = scene.surroundings.bodies[k];
    auto* mesh = std::get_if<sim::BodyMesh>(&body.shape);
    if (mesh == nullptr || mesh->data) {
      continue;
    }
    try {
      *mesh = load_body(scene.body_sources.at(k));
    } catch (const InputError& error) {
      const std::string name = body.name.empty() ? fmt::format("{}", k + 1) : '\'' + body.name + '\'';
      throw InputError("body " + name + ": " + error.what());
    }
  }
}

}  // namespace taut::app
