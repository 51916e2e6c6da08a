#include "app/drawing/surface_rooms.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "sim/mesh/extent.hpp"

namespace taut::app {
namespace {

// Shares of an edge. What is farther than the last is not looked for, which would take longer than it shows.
constexpr float most_bulge = 0.1F;
constexpr float most_fairing = 0.15F;
constexpr float most_clearance = 0.45F;
// However long the edges are, the surface goes by where the vertices are.
constexpr float most_fairing_m = 0.004F;
// Of the distance between two things, what each may use of it.
constexpr float share_of_clearance = 0.45F;
// Cloth that is larger is lost, and nothing is looked for.
constexpr double largest_m = 1e4;

std::vector<sim::Triangle> triangles_of(std::span<const sim::Body> bodies, std::size_t first_vertex) {
  std::vector<sim::Triangle> triangles;
  auto first = static_cast<sim::Index>(first_vertex);
  for (const sim::Body& body : bodies) {
    if (const auto* mesh = std::get_if<sim::BodyMesh>(&body.shape)) {
      for (const sim::Triangle& t : mesh->data->triangles) {
        triangles.push_back({first + t[0], first + t[1], first + t[2]});
      }
      first += static_cast<sim::Index>(mesh->data->positions_m.size());
    }
  }
  return triangles;
}

void append_mesh_positions(std::span<const sim::Body> bodies, double time_s,
                           std::vector<sim::Vec3>& positions_m) {
  for (const sim::Body& body : bodies) {
    if (const auto* mesh = std::get_if<sim::BodyMesh>(&body.shape)) {
      const std::size_t first = positions_m.size();
      positions_m.resize(first + mesh->data->positions_m.size());
      sim::positions_at(body, time_s, std::span(positions_m).subspan(first));
    }
  }
}

}  // namespace

SurfaceRooms::SurfaceRooms(const DrawnScene& scene, const sim::Garment& garment, float edge_m)
    : freedom_{most_bulge * edge_m, std::min(most_fairing * edge_m, most_fairing_m)},
      most_clearance_m_(most_clearance * edge_m),
      bodies_(scene.surroundings.bodies),
      garment_vertices_(garment.mesh.positions.size()),
      positions_m_(garment.mesh.positions) {
  const SolverChoice& solver = scene.simulation.solver;
  const bool layers_apart = solver.kind == sim::SolverKind::bounded && solver.bounded.contact;
  if (!layers_apart && bodies_.empty()) {
    return;
  }
  append_mesh_positions(bodies_, 0.0, positions_m_);
  clearances_.emplace(garment.mesh.triangles, triangles_of(bodies_, garment_vertices_), layers_apart,
                      positions_m_);
}

std::span<const float> SurfaceRooms::find(const std::vector<sim::Vec3>& positions, double time_s) {
  if (!clearances_) {
    return {};
  }
  const double size_m = glm::length(sim::extent_of(positions).size());
  if (!(size_m < largest_m)) {
    rooms_m_.assign(positions_m_.size(), 0.0F);
    return rooms_m_;
  }
  positions_m_.assign(positions.begin(), positions.end());
  append_mesh_positions(bodies_, time_s, positions_m_);
  const std::span<const float> clearances_m = clearances_->find(positions_m_, most_clearance_m_);
  rooms_m_.assign(clearances_m.begin(), clearances_m.end());
  keep_off_shapes(time_s);
  for (float& room_m : rooms_m_) {
    room_m *= share_of_clearance;
  }
  return rooms_m_;
}

void SurfaceRooms::keep_off_shapes(double time_s) {
  for (const sim::Body& body : bodies_) {
    if (std::holds_alternative<sim::BodyMesh>(body.shape)) {
      continue;
    }
    const sim::Shape shape = sim::shape_at(body, time_s);
    for (std::size_t v = 0; v < garment_vertices_; ++v) {
      const double distance_m = sim::nearest_surface(shape, positions_m_[v]).distance_m;
      rooms_m_[v] = std::clamp(static_cast<float>(distance_m), 0.0F, rooms_m_[v]);
    }
  }
}

}  // namespace taut::app
