#pragma once

#include "app/drawing/drawing.hpp"
#include "app/drawing/framing.hpp"
#include "app/drawing/garment_colours.hpp"
#include "app/drawing/garment_surface.hpp"
#include "app/drawing/spring_lines.hpp"
#include "renderer/scene_renderer.hpp"
#include "sim/solvers/bounded/contact/clearances.hpp"

namespace taut::app {

/// A scene renderer with an OpenGL context that needs no window.
class OffscreenRenderer {
 public:
  /// `backend`: see renderer::create_context. Throws renderer::ContextError.
  explicit OffscreenRenderer(const std::string& backend)
      : context_(renderer::create_context(backend)), renderer_(*context_) {}

  renderer::SceneRenderer& renderer() { return renderer_; }
  /// Returns OpenGL's name of its renderer (GL_RENDERER).
  const std::string& gl_renderer() const { return context_->renderer(); }

 private:
  std::unique_ptr<renderer::Context> context_;
  renderer::SceneRenderer renderer_;
};

/// Computes how far the drawn surface may leave its triangles without touching another layer or a body that the
/// simulation keeps apart.
class SurfaceClearances {
 public:
  /// `edge_m`: mean edge length of the garment. `rim_radius_m`: of the lip along its borders.
  SurfaceClearances(const DrawnScene& scene, const sim::Garment& garment, std::vector<sim::Body> bodies, float edge_m,
                    float rim_radius_m);

  /// Returns the limits for cloth that nothing is near.
  const renderer::SurfaceFreedom& freedom() const { return freedom_; }

  /// Returns the distance in metres that each vertex may use (see renderer::SmoothSurface), first of the garment at
  /// these positions, then of all mesh bodies. Empty if the simulation keeps nothing apart. Valid until the next call.
  std::span<const float> find(const std::vector<sim::Vec3>& positions, double time_s);

 private:
  void keep_off_shapes(double time_s);

  renderer::SurfaceFreedom freedom_;
  float max_clearance_m_;
  std::vector<sim::Body> bodies_;
  std::optional<sim::bounded::Clearances> clearances_;
  std::size_t garment_vertices_;
  std::vector<sim::Vec3> positions_m_;  ///< garment first, then the mesh bodies
  std::vector<float> vertex_clearances_m_;
};

/// Returns the radius of the balls that show pins, for a scene in this box.
float pin_radius_m(const renderer::Box& reach);

/// Draws a scene's garment at any positions, with the scene's camera and style. Positions are in metres, per vertex of
/// the garment. A model that follows the garment is drawn instead, except by styles that show springs or stretch.
class GarmentPainter {
 public:
  /// `renderer` must outlive the painter. The needed data of `scene` and `garment` is copied.
  GarmentPainter(renderer::SceneRenderer& renderer, const DrawnScene& scene, const sim::Garment& garment,
                 const std::vector<sim::Body>& bodies, std::span<const sim::Index> pins, DrawnColours colours = {});

  /// Replaces the scene's camera; the light follows it. A nearer camera gets a finer surface. Edges shorter than
  /// `min_edge_px` in the picture are not halved: a larger value is faster.
  void look_from(const renderer::Camera& camera, float min_edge_px = renderer::min_split_px);

  /// Returns the picture, with the bodies at this time, and with a legend if the scene asks for one. `shown_m` is the
  /// shape of a model that follows (GarmentInScene::shown_m()); it is computed if it is empty.
  renderer::Image draw(const std::vector<sim::Vec3>& positions, double time_s,
                       const std::vector<sim::Vec3>& shown_m = {});

  /// Returns the camera of the last picture.
  const renderer::Camera& camera() const { return frame_.camera; }

  /// Returns the frame that `draw` passes to the renderer. It refers to the painter's data and is valid until the next
  /// call.
  const renderer::FrameView& view(const std::vector<sim::Vec3>& positions, double time_s,
                                  const std::vector<sim::Vec3>& shown_m = {});

 private:
  void add_rest_outline(const sim::Garment& garment);
  void add_wind(const DrawnScene& scene, const sim::Garment& garment);
  void place_bodies(double time_s, std::span<const float> clearances_m);
  renderer::SurfaceView garment_view();

  renderer::SceneRenderer& renderer_;
  PictureStyle style_;
  renderer::Legend legend_;
  sim::Garment stretch_source_;  ///< garment with only the data that the shown stretch needs
  std::vector<sim::Index> pins_;
  DrawnColours colours_;
  std::vector<sim::Triangle> simulated_;  ///< triangles of the simulated mesh that a model follows
  std::optional<sim::Garment> model_;     ///< following model that is drawn instead of the garment
  GarmentSurface surface_;
  SurfaceClearances surface_clearances_;
  std::vector<sim::Edge> structural_edges_;
  float line_width_px_;
  SpringLines spring_lines_;
  DrawnBodies bodies_;
  std::vector<glm::vec3> rest_outline_;
  std::vector<glm::vec3> wind_arrows_;
  std::size_t fixed_line_count_ = 0;  ///< number of lines of frame_ that every picture keeps
  renderer::FrameView frame_;
  renderer::Camera camera_;                 ///< before it follows the garment; frame_ has the moved camera
  std::optional<glm::vec3> rest_centre_m_;  ///< mean of the vertices at rest; empty: the camera stands still
  float pin_radius_m_ = 0.0F;
  // Data of the current frame.
  std::vector<glm::vec3> positions_;
  std::vector<sim::Edge> wireframe_;
  std::vector<float> stretch_;
  std::vector<glm::vec3> pin_positions_;
};

/// Returns the colour bar of pictures that show stretch. It marks shown_bound().
renderer::Legend stretch_legend(const DrawnScene& scene);

}  // namespace taut::app
