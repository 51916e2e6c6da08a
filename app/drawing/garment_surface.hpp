#pragma once

#include "app/drawing/drawn_scene.hpp"
#include "app/models/garment_loading.hpp"
#include "renderer/surface/lines.hpp"

namespace taut::app {

/// Returns where on its flat piece of cloth each corner of the garment's triangles lies, three each, in
/// metres: v along the warp, u to the right of it seen from outside. Each run of triangles without a seam has
/// the scale that gives its texture coordinates its area at rest, and is turned over if they are mirrored.
/// Returns none without coordinates, or if a run has no area in them.
std::vector<glm::vec2> cloth_coordinates(const sim::Garment& garment, std::span<const glm::vec2> corner_uv);

/// How the edges of a garment are finished and where it has seams. It is drawn, not simulated.
struct GarmentSewing {
  std::vector<renderer::BorderBand> bands;  ///< one per vertex, or none
  std::vector<renderer::VertexPair> seams;
  float stitch_m = 0.004F;
  float rim_radius_m = 0.0005F;  ///< half of the thickness at the border
};

/// Finds it by the garment at rest. Openings get hems, and one around the neck a ribbed band: narrower ones
/// where the garment is small. A grid is plain cloth without any. corner_coordinates: texture coordinates,
/// three for each triangle; they differ at seams. Without them, long sharp edges are seams.
GarmentSewing sewing_of(const sim::Garment& garment, std::span<const glm::vec2> corner_coordinates = {});

/// The surface that is drawn of a garment: finer than what is simulated, and along its vertices. All that
/// is measured stays with the simulated triangles. Its borders are as thick as cloth, with hems and seams.
class GarmentSurface {
 public:
  /// corner_coordinates: three per triangle or none; colour_of_triangle: one per triangle or none. Both are
  /// those of renderer::SurfaceView, of the simulated triangles. Where corner_coordinates differ across an
  /// edge is a seam, and the weave runs along them.
  explicit GarmentSurface(const sim::Garment& garment, std::vector<glm::vec2> corner_coordinates = {},
                          std::vector<std::uint32_t> colour_of_triangle = {});

  /// See renderer::SmoothSurface.
  void set_freedom(const renderer::SurfaceFreedom& freedom) { freedom_ = freedom; }

  /// Draws the wrinkles that cloth has where it is shortened and its mesh cannot show them.
  void set_wrinkled(bool is_wrinkled) { is_wrinkled_ = is_wrinkled; }

  /// Mean length of the simulated edges at rest.
  float edge_m() const { return edge_m_; }

  /// Makes the surface as fine as it shows at so many pixels of the picture for a metre, with what is sewn.
  /// Edges shorter than shortest_edge_px are not halved; none: the simulated triangles alone, without hems.
  /// Takes some milliseconds where something changes.
  void set_detail(float pixels_per_m, std::optional<float> shortest_edge_px);
  /// Whether it is finer than what is simulated.
  bool is_refined() const { return detail_.levels > 0; }
  /// Moves the surface to these positions of the simulated vertices, in metres. `rooms_m` as of
  /// renderer::SmoothSurface.
  void place(std::span<const glm::vec3> positions, std::span<const float> rooms_m = {});
  /// The surface that is drawn, without a style. Valid until the next call of any other function.
  renderer::SurfaceView view() const;
  /// Returns pairs of vertices of view() for pairs of simulated ones: the edges between, along the surface.
  std::vector<sim::Edge> refined_edges(std::span<const sim::Edge> edges) const {
    return surface_->mesh().refined_edges(edges);
  }
  /// Appends to values at the simulated vertices those of all others of view().
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
  float wavelength_m_;  ///< of wrinkles; 0: the mesh shows them
  GarmentSewing sewing_;
  Detail detail_;
  std::optional<renderer::SmoothSurface> surface_;
  std::optional<renderer::Wrinkles> wrinkles_;
  std::vector<glm::vec3> material_coordinates_;
  std::vector<glm::vec2> fine_corner_coordinates_;
  std::vector<std::uint32_t> fine_colour_of_triangle_;
  std::vector<renderer::TrimmedTriangle> trims_;
};

/// The colour of one kind of spring. People with any kind of colour vision can tell them apart (Okabe and Ito
/// 2008).
inline renderer::Colour spring_colour(sim::SpringKind kind) {
  constexpr std::array colours = {renderer::rgb(0x0072B2), renderer::rgb(0xE69F00), renderer::rgb(0xCC3377)};
  return colours[static_cast<std::size_t>(kind)];
}

/// For a surface that lines are drawn over.
inline const renderer::Colour pale_outside = renderer::rgb(0xE8EDF2);
inline const renderer::Colour pale_inside = renderer::rgb(0xF3DFC0);

/// The springs of a garment as lines over its surface.
class SpringLines {
 public:
  /// `width_px` is that of structural and shear springs, in pixels of the picture.
  SpringLines(const sim::Garment& garment, WhichSprings shown, float width_px);

  /// Adds the lines for these positions, in metres, one per vertex. They refer to this object and are valid
  /// until its next call.
  void add(std::span<const glm::vec3> positions, renderer::FrameView& frame);

 private:
  struct Lines {
    std::vector<sim::Edge> springs;
    renderer::Colour colour;
    float width_px;
    std::vector<glm::vec3> points;
  };

  std::vector<Lines> lines_;  ///< in the order in which they are drawn
};

/// Whether springs of this kind are shown.
bool shows(WhichSprings shown, sim::SpringKind kind);

/// Base colours on the triangles of a garment, as renderer::SurfaceView has them. No base colours: those of
/// the cloth. Its texture coordinates, if it has any, say where it is sewn too.
struct DrawnColours {
  std::vector<glm::vec2> corner_coordinates;
  std::vector<renderer::BaseColour> base_colours;
  std::vector<std::uint32_t> base_colour_of_triangle;
  std::vector<std::string> remarks = {};  ///< what of it is missing, one line each
  /// The model whose triangles these are, where it follows the garment; null: they are the garment's own.
  std::shared_ptr<const FollowingModel> following = {};
};

/// Returns what picture.texture asks for: an image over the cloth's colours, or the model's own colours if it
/// names images of them and the scene no outside colour of its own. Throws InputError if the image cannot be
/// read or the garment has no texture coordinates.
DrawnColours drawn_colours(const DrawnScene& scene, const GarmentInScene& loaded);

}  // namespace taut::app
