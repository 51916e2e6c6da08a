#pragma once

#include "app/drawing/drawing.hpp"
#include "app/drawing/framing.hpp"
#include "app/drawing/garment_surface.hpp"
#include "renderer/scene_renderer.hpp"
#include "sim/solvers/bounded/contact/clearances.hpp"

namespace taut::app {

/// An OpenGL context without a window, and the scene renderer in it.
class OffscreenRenderer {
 public:
  /// `backend` as in renderer::create_context. Throws renderer::ContextError.
  explicit OffscreenRenderer(const std::string& backend)
      : context_(renderer::create_context(backend)), renderer_(*context_) {}

  renderer::SceneRenderer& renderer() { return renderer_; }
  /// The name OpenGL gives its renderer (GL_RENDERER).
  const std::string& gl_renderer() const { return context_->renderer(); }

 private:
  std::unique_ptr<renderer::Context> context_;
  renderer::SceneRenderer renderer_;
};

/// How far the surface that is drawn of a garment may leave its triangles without meeting another layer or a
/// body where the simulation keeps those apart.
class SurfaceRooms {
 public:
  /// edge_m: mean length of the garment's edges.
  SurfaceRooms(const DrawnScene& scene, const sim::Garment& garment, float edge_m);

  /// Where nothing is near.
  const renderer::SurfaceFreedom& freedom() const { return freedom_; }

  /// Returns the room of each vertex of the garment at these positions, in metres, and then of all bodies
  /// that are meshes: what renderer::SmoothSurface asks for. None if nothing is kept apart. Valid until the
  /// next call.
  std::span<const float> find(const std::vector<sim::Vec3>& positions, double time_s);

 private:
  void keep_off_shapes(double time_s);

  renderer::SurfaceFreedom freedom_;
  float most_clearance_m_;
  std::vector<sim::Body> bodies_;
  std::optional<sim::bounded::Clearances> clearances_;
  std::size_t garment_vertices_;
  std::vector<sim::Vec3> positions_m_;  ///< of the garment and of bodies that are meshes
  std::vector<float> rooms_m_;
};

/// Radius of the balls that show pins, for a scene with this reach.
float pin_radius_m(const renderer::Box& reach);

/// Draws a scene's garment at any positions, with the scene's camera and style. Spans of positions are in
/// metres, per vertex of the garment. A model that follows the garment is drawn in its place, but for looks
/// that show its springs or its stretch.
class GarmentPainter {
 public:
  /// `renderer` must outlive the painter. `scene` and `garment` are copied as far as they are needed.
  GarmentPainter(renderer::SceneRenderer& renderer, const DrawnScene& scene, const sim::Garment& garment,
                 std::span<const sim::Index> pins, DrawnColours colours = {});

  /// Looks from another camera than the scene's, with light that follows it. The surface is finer the nearer
  /// it is; edges shorter than shortest_edge_px in the picture stay, which is faster the longer they are.
  void look_from(const renderer::Camera& camera, float shortest_edge_px = renderer::shortest_split_px);

  /// Returns the picture, with bodies where they are at this time and with a legend if the scene asks for
  /// one.
  renderer::Image draw(const std::vector<sim::Vec3>& positions, double time_s);

  /// The camera of the picture drawn last.
  const renderer::Camera& camera() const { return frame_.camera; }

  /// The frame that `draw` hands to the renderer. It refers to data of the painter and is valid until the
  /// next call.
  const renderer::FrameView& view(const std::vector<sim::Vec3>& positions, double time_s);

 private:
  void add_rest_outline(const sim::Garment& garment);
  void add_wind(const DrawnScene& scene, const sim::Garment& garment);
  void place_bodies(double time_s, std::span<const float> rooms_m);
  renderer::SurfaceView garment_view();

  renderer::SceneRenderer& renderer_;
  PictureStyle style_;
  renderer::Legend legend_;
  sim::Garment measured_;  ///< what the stretch that is shown is measured from, and nothing else
  std::vector<sim::Index> pins_;
  DrawnColours colours_;
  std::vector<sim::Triangle> simulated_;  ///< triangles that a model follows
  std::optional<sim::Garment> model_;     ///< that is drawn in place of the garment
  GarmentSurface surface_;
  SurfaceRooms rooms_;
  std::vector<sim::Edge> structural_edges_;
  float line_width_px_;
  SpringLines spring_lines_;
  DrawnBodies bodies_;
  std::vector<glm::vec3> rest_outline_;
  std::vector<glm::vec3> wind_arrows_;
  std::size_t outlines_ = 0;  ///< lines of frame_ that stay
  renderer::FrameView frame_;
  renderer::Camera camera_;                 ///< at rest; frame_ has the one that follows
  std::optional<glm::vec3> followed_from_;  ///< the mean of the vertices at rest; empty: it stands still
  float pin_radius_m_ = 0.0F;
  // Arrays of the frame at hand.
  std::vector<glm::vec3> positions_;
  std::vector<sim::Edge> wireframe_;
  std::vector<float> stretch_;
  std::vector<glm::vec3> pin_positions_;
};

/// The colour bar of pictures that show stretch. It marks shown_bound().
renderer::Legend stretch_legend(const DrawnScene& scene);

}  // namespace taut::app
