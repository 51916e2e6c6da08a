#include "app/drawing/garment_surface.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "app/drawing/framing.hpp"

namespace taut::app {
namespace {

std::vector<std::uint32_t> flat(const std::vector<sim::Triangle>& triangles) {
  std::vector<std::uint32_t> indices;
  indices.reserve(triangles.size() * 3);
  for (const sim::Triangle& t : triangles) {
    indices.insert(indices.end(), t.begin(), t.end());
  }
  return indices;
}

float mean_edge_m(const sim::Garment& garment) {
  double sum_m = 0.0;
  for (const sim::Edge& edge : garment.adjacency.edges) {
    sum_m += glm::distance(garment.mesh.positions[edge[0]], garment.mesh.positions[edge[1]]);
  }
  return static_cast<float>(sum_m /
                            static_cast<double>(std::max<std::size_t>(garment.adjacency.edges.size(), 1)));
}

}  // namespace

GarmentSurface::GarmentSurface(const sim::Garment& garment)
    : triangles_(flat(garment.mesh.triangles)),
      rest_positions_(to_float(garment.mesh.positions)),
      edge_m_(mean_edge_m(garment)) {
  refine(0);
}

void GarmentSurface::refine(int levels) {
  if (surface_ && surface_->mesh().levels().size() == static_cast<std::size_t>(levels)) {
    return;
  }
  surface_.emplace(rest_positions_, triangles_, levels, most_bulge_m_);
  surface_->place(rest_positions_);
  material_coordinates_ = surface_->positions();
  parent_triangles_.resize(surface_->mesh().triangles().size() / 3);
  for (std::size_t t = 0; t < parent_triangles_.size(); ++t) {
    parent_triangles_[t] = static_cast<std::uint32_t>(t >> (2 * levels));
  }
}

void GarmentSurface::place(std::span<const glm::vec3> positions) {
  surface_->place(positions);
}

renderer::SurfaceView GarmentSurface::view() const {
  const renderer::RefinedMesh& mesh = surface_->mesh();
  renderer::SurfaceView view;
  view.positions = surface_->positions();
  view.normals = surface_->normals();
  view.triangles = mesh.triangles();
  view.material_coordinates = material_coordinates_;
  view.refinement =
      renderer::Refinement{mesh.coarse_vertex_count(), triangles_, mesh.parents(), parent_triangles_};
  return view;
}

std::vector<std::uint32_t> GarmentSurface::refined_edges(std::span<const std::uint32_t> edges) const {
  return surface_->mesh().refined_edges(edges);
}

void GarmentSurface::interpolate(std::vector<float>& values) const {
  renderer::interpolate(std::span(surface_->mesh().parents()), values);
}

}  // namespace taut::app
