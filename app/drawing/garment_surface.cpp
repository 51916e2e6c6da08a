#include "app/drawing/garment_surface.hpp"

#include "app/drawing/framing.hpp"

namespace taut::app {
namespace {

// Size in pixels below which a rim or a stitch is not drawn.
constexpr float min_rim_px = 0.7F;
constexpr float min_stitch_px = 0.8F;

float mean_edge_m(const sim::Garment& garment) {
  double sum_m = 0.0;
  for (const sim::Edge& edge : garment.adjacency.edges) {
    sum_m += glm::distance(garment.mesh.positions[edge[0]], garment.mesh.positions[edge[1]]);
  }
  return static_cast<float>(sum_m / static_cast<double>(std::max<std::size_t>(garment.adjacency.edges.size(), 1)));
}

// Wrinkles are about two bending lengths long. The mesh itself shows wrinkles of four edges and more. If its edges are
// nearly as long as the wrinkles, it does not tell where they are.
constexpr float wrinkle_bending_lengths = 2.0F;
constexpr float resolved_wrinkle_edges = 4.0F;
constexpr float min_wrinkle_edges = 1.2F;
constexpr float min_drawn_wrinkle_edges = 2.5F, max_drawn_wrinkle_edges = 3.5F;

/// Returns the wavelength in metres of the wrinkles to draw; 0: none. The bending length is the edge of a square of
/// cloth that its own weight bends clearly (Peirce 1930).
float wavelength_m(const sim::Material& material, float edge_m) {
  const double bending_length_m = std::cbrt(material.bending_rigidity_n_m / (material.areal_density_kg_per_m2 * 9.81));
  const float wanted_m = wrinkle_bending_lengths * static_cast<float>(bending_length_m);
  const bool is_drawn = wanted_m > min_wrinkle_edges * edge_m && wanted_m < resolved_wrinkle_edges * edge_m;
  return !is_drawn ? 0.0F : std::clamp(wanted_m, min_drawn_wrinkle_edges * edge_m, max_drawn_wrinkle_edges * edge_m);
}

}  // namespace

GarmentSurface::GarmentSurface(const sim::Garment& garment, std::vector<glm::vec2> corner_coordinates,
                               std::vector<std::uint32_t> colour_of_triangle)
    : triangles_(flat(garment.mesh.triangles)),
      rest_positions_(to_float(garment.mesh.positions)),
      corner_coordinates_(std::move(corner_coordinates)),
      cloth_coordinates_(cloth_coordinates(garment, corner_coordinates_)),
      colour_of_triangle_(std::move(colour_of_triangle)),
      edge_m_(mean_edge_m(garment)),
      wavelength_m_(wavelength_m(garment.material, edge_m_)),
      sewing_(make_garment_sewing(garment, corner_coordinates_)) {}

void GarmentSurface::set_detail(float pixels_per_m, std::optional<float> min_edge_px) {
  Detail wanted;
  if (min_edge_px) {
    wanted.levels = renderer::refinement_levels(edge_m_ * pixels_per_m, triangles_.size() / 3, *min_edge_px);
    wanted.rim = 2.0F * sewing_.rim_radius_m * pixels_per_m > min_rim_px;
    wanted.sewn = sewing_.stitch_m * pixels_per_m > min_stitch_px;
  }
  if (!surface_ || wanted != detail_) {
    detail_ = wanted;
    make();
  }
}

void GarmentSurface::make() {
  surface_.emplace(rest_positions_, triangles_, detail_.levels, freedom_, detail_.rim ? sewing_.rim_radius_m : 0.0F);
  surface_->place(rest_positions_);
  material_coordinates_ = surface_->positions();
  wrinkles_.reset();
  if (is_wrinkled_ && is_refined() && wavelength_m_ > 0.0F) {
    wrinkles_.emplace(rest_positions_, triangles_, wavelength_m_);
    wrinkles_->refine(std::span(material_coordinates_).first(surface_->mesh().vertex_count()),
                      surface_->mesh().parents());
  }
  fine_corner_coordinates_ = fine_corner_values(corner_coordinates_);
  fine_colour_of_triangle_.clear();
  if (!colour_of_triangle_.empty()) {
    for (const std::uint32_t parent : surface_->parent_triangles()) {
      fine_colour_of_triangle_.push_back(colour_of_triangle_[parent]);
    }
  }
  trims_.clear();
  if (detail_.sewn) {
    trims_ = renderer::trimmed_triangles(*surface_, material_coordinates_,
                                         {sewing_.bands, sewing_.seams, sewing_.stitch_m, sewing_.rim_radius_m});
  }
  if (!cloth_coordinates_.empty()) {
    material_coordinates_.clear();
    for (const glm::vec2& place : surface_->part_vertices(fine_corner_values(cloth_coordinates_))) {
      material_coordinates_.emplace_back(place, 0.0F);
    }
  }
}

// Returns texture coordinates of the fine surface. A vertex of the rim takes the values of the border beside it.
std::vector<glm::vec2> GarmentSurface::fine_corner_values(std::span<const glm::vec2> corners) const {
  if (corners.empty()) return {};
  std::vector<glm::vec2> fine = renderer::refined_corner_values(corners, detail_.levels);
  const std::vector<std::uint32_t>& triangles = surface_->triangles();
  std::vector<glm::vec2> at_vertex(surface_->positions().size(), glm::vec2(0.0F));
  for (std::size_t corner = 0; corner < fine.size(); ++corner) at_vertex[triangles[corner]] = fine[corner];
  const std::size_t coarse = surface_->mesh().coarse_vertex_count();
  for (std::size_t v = surface_->mesh().vertex_count(); v < at_vertex.size(); ++v) {
    at_vertex[v] = at_vertex[surface_->parents()[v - coarse][0]];
  }
  for (std::size_t corner = fine.size(); corner < triangles.size(); ++corner) {
    fine.push_back(at_vertex[triangles[corner]]);
  }
  return fine;
}

void GarmentSurface::place(std::span<const glm::vec3> positions, std::span<const float> clearances_m) {
  surface_->place(positions, clearances_m, wrinkles_ ? wrinkles_->heights(positions) : std::span<const float>());
}

renderer::SurfaceView GarmentSurface::view() const {
  const renderer::RefinedMesh& mesh = surface_->mesh();
  renderer::SurfaceView view;
  view.positions = surface_->positions();
  view.normals = surface_->normals();
  view.triangles = surface_->triangles();
  view.material_coordinates = material_coordinates_;
  view.refinement = renderer::Refinement{mesh.coarse_vertex_count(), triangles_, surface_->parents(),
                                         surface_->parent_triangles(), freedom_.max_bulge};
  view.corner_coordinates = fine_corner_coordinates_;
  view.base_colour_of_triangle = fine_colour_of_triangle_;
  view.trims = trims_;
  return view;
}

void GarmentSurface::interpolate(std::vector<float>& values) const {
  renderer::interpolate(std::span(surface_->parents()), values);
}

}  // namespace taut::app
