#pragma once

#include "app/drawing/garment_sewing.hpp"
#include "renderer/surface/smooth_surface.hpp"
#include "renderer/surface/wrinkles.hpp"

namespace taut::app {

/// The drawn surface of a garment: a finer surface through the simulated vertices, with borders as thick as cloth, hems
/// and seams. Measurements always use the simulated triangles.
class GarmentSurface {
 public:
  /// corner_coordinates: three per triangle or none; colour_of_triangle: one per triangle or none. Both are defined as
  /// in renderer::SurfaceView, for the simulated triangles. An edge across which corner_coordinates differ is a seam.
  /// The weave follows these coordinates.
  explicit GarmentSurface(const sim::Garment& garment, std::vector<glm::vec2> corner_coordinates = {},
                          std::vector<std::uint32_t> colour_of_triangle = {});

  /// Sets the limits for renderer::SmoothSurface.
  void set_freedom(const renderer::SurfaceFreedom& freedom) { freedom_ = freedom; }

  /// Draws wrinkles that the mesh is too coarse for, where cloth is compressed.
  void set_wrinkled(bool is_wrinkled) { is_wrinkled_ = is_wrinkled; }

  /// Returns the mean length of the simulated edges at rest.
  float edge_m() const { return edge_m_; }
  float rim_radius_m() const { return sewing_.rim_radius_m; }

  /// Makes the surface, hems and seams as fine as a picture with this resolution can show. Edges shorter than
  /// min_edge_px are not halved; empty: only the simulated triangles, without hems. A change takes some milliseconds.
  void set_detail(float pixels_per_m, std::optional<float> min_edge_px);
  /// Returns true if the surface is finer than the simulated mesh.
  bool is_refined() const { return detail_.levels > 0; }
  /// Returns true if the surface leaves the simulated triangles, so that it needs clearances.
  bool leaves_triangles() const { return is_refined() || detail_.rim; }
  /// Moves the surface to these positions of the simulated vertices, in metres. `rooms_m`: see renderer::SmoothSurface.
  void place(std::span<const glm::vec3> positions, std::span<const float> rooms_m = {});
  /// Returns the drawn surface without a style. It is valid until the next call of any other function.
  renderer::SurfaceView view() const;
  /// Returns the edges of view() along these simulated edges, as pairs of vertices.
  std::vector<sim::Edge> refined_edges(std::span<const sim::Edge> edges) const {
    return surface_->mesh().refined_edges(edges);
  }
  /// Appends the interpolated values of the other vertices of view() to the values of the simulated vertices.
  void interpolate(std::vector<float>& values) const;

 private:
  struct Detail {
    int levels = 0;
    bool rim = false;
    bool sewn = false;
    bool operator==(const Detail&) const = default;
  };
  void make();
  std::vector<glm::vec2> fine_corner_values(std::span<const glm::vec2> corners) const;

  std::vector<std::uint32_t> triangles_;
  std::vector<glm::vec3> rest_positions_;
  std::vector<glm::vec2> corner_coordinates_;
  std::vector<glm::vec2> cloth_coordinates_;
  std::vector<std::uint32_t> colour_of_triangle_;
  float edge_m_;
  renderer::SurfaceFreedom freedom_;
  bool is_wrinkled_ = false;
  float wavelength_m_;  ///< wavelength of drawn wrinkles; 0: none are drawn
  GarmentSewing sewing_;
  Detail detail_;
  std::optional<renderer::SmoothSurface> surface_;
  std::optional<renderer::Wrinkles> wrinkles_;
  std::vector<glm::vec3> material_coordinates_;
  std::vector<glm::vec2> fine_corner_coordinates_;
  std::vector<std::uint32_t> fine_colour_of_triangle_;
  std::vector<renderer::TrimmedTriangle> trims_;
};

}  // namespace taut::app
