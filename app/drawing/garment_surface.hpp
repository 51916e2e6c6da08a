#pragma once

#include "app/drawing/drawn_scene.hpp"
#include "app/models/garment_loading.hpp"
#include "renderer/surface/lines.hpp"

namespace taut::app {

/// Returns the position of each corner of the garment's triangles on its flat piece of cloth, three per triangle, in
/// metres: v along the warp, u to the right as seen from outside. Each piece between seams is scaled so that its area
/// in texture coordinates becomes its area at rest, and is flipped if it is mirrored. Empty without texture coordinates
/// or if a piece has no area in them.
std::vector<glm::vec2> cloth_coordinates(const sim::Garment& garment, std::span<const glm::vec2> corner_uv);

/// Edge finish and seams of a garment. They are drawn, not simulated.
struct GarmentSewing {
  std::vector<renderer::BorderBand> bands;  ///< one per vertex, or none
  std::vector<renderer::VertexPair> seams;
  float stitch_m = 0.004F;
  float rim_radius_m = 0.0005F;  ///< half the thickness at the border
};

/// Finds edge finish and seams of the garment at rest. Openings get hems, the neck a ribbed band; both are narrower on
/// small garments. A grid is plain cloth without them. Seams are edges across which `corner_coordinates`, three texture
/// coordinates per triangle, differ; without coordinates they are long sharp edges.
GarmentSewing make_garment_sewing(const sim::Garment& garment, std::span<const glm::vec2> corner_coordinates = {});

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

/// Returns the colour of a kind of spring. People with any kind of colour vision can distinguish them (Okabe and Ito
/// 2008).
inline renderer::Colour spring_colour(sim::SpringKind kind) {
  constexpr std::array colours = {renderer::rgb(0x0072B2), renderer::rgb(0xE69F00), renderer::rgb(0xCC3377)};
  return colours[static_cast<std::size_t>(kind)];
}

/// Colours of a surface under lines.
inline const renderer::Colour pale_outside = renderer::rgb(0xE8EDF2);
inline const renderer::Colour pale_inside = renderer::rgb(0xF3DFC0);

/// Draws the springs of a garment as lines over its surface.
class SpringLines {
 public:
  /// `width_px`: width of structural and shear springs, in pixels of the picture.
  SpringLines(const sim::Garment& garment, WhichSprings shown, float width_px);

  /// Adds the lines for these positions in metres, one per vertex. They refer to this object and are valid until its
  /// next call.
  void add(std::span<const glm::vec3> positions, renderer::FrameView& frame);

 private:
  struct SewingLines {
    std::vector<sim::Edge> springs;
    renderer::Colour colour;
    float width_px;
    std::vector<glm::vec3> points;
  };

  std::vector<SewingLines> lines_;  ///< ordered as they are drawn
};

/// Returns true if springs of this kind are shown.
bool shows(WhichSprings shown, sim::SpringKind kind);

/// Base colours of a garment's triangles, as in renderer::SurfaceView; empty: the cloth's colours. Texture coordinates
/// also define its seams.
struct DrawnColours {
  std::vector<glm::vec2> corner_coordinates;
  std::vector<renderer::BaseColour> base_colours;
  std::vector<std::uint32_t> base_colour_of_triangle;
  std::vector<std::string> remarks = {};  ///< missing colours or images, a line each
  /// Model that follows the garment and owns these triangles; null: the garment's own triangles.
  std::shared_ptr<const FollowingModel> following = {};
};

/// Returns the colours for picture.texture. An image covers the cloth's colours. By default the model's own colours are
/// used if it has images and the scene sets no outside colour. Throws InputError if the image cannot be read or the
/// garment has no texture coordinates.
DrawnColours drawn_colours(const DrawnScene& scene, const GarmentInScene& loaded);

}  // namespace taut::app
