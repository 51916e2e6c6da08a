#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "app/drawing/drawn_scene.hpp"
#include "renderer/frame_view.hpp"
#include "renderer/page/image.hpp"
#include "renderer/page/legend.hpp"
#include "renderer/primitives.hpp"
#include "renderer/scene_renderer.hpp"
#include "sim/garment.hpp"

namespace taut::app {

/// Of the balls that show pins, where the scene reaches so far.
float pin_radius_m(const renderer::Box& reach);

/// Draws a scene's garment, wherever it is, with the scene's camera and style.
class GarmentPainter {
 public:
  /// `renderer` has to outlive the painter.
  GarmentPainter(renderer::SceneRenderer& renderer, const DrawnScene& scene, const sim::Garment& garment,
                 std::span<const sim::Index> pins);

  /// The picture, with the legend the scene asks for.
  renderer::Image draw(const std::vector<sim::Vec3>& positions);

  /// What `draw` hands to the renderer. It looks into the painter: valid until the next call.
  const renderer::FrameView& view(const std::vector<sim::Vec3>& positions);

 private:
  void make_fixed_parts(const DrawnScene& scene, const sim::Garment& garment);
  renderer::SurfaceView garment_view() const;

  renderer::SceneRenderer& renderer_;
  PictureStyle style_;
  renderer::Legend legend_;
  sim::Springs springs_;
  std::vector<sim::Index> pins_;
  std::vector<std::uint32_t> triangles_;
  std::vector<glm::vec3> rest_positions_;
  std::vector<std::uint32_t> structural_edges_;
  std::vector<renderer::TriangleMesh> obstacles_;
  std::vector<glm::vec3> rest_outline_;
  renderer::FrameView frame_;
  float pin_radius_m_ = 0.0F;
  float line_width_px_ = 1.0F;
  // Of the frame at hand.
  std::vector<glm::vec3> positions_;
  std::vector<glm::vec3> normals_;
  std::vector<float> stretch_;
  std::vector<glm::vec3> pin_positions_;
};

/// The colour bar of pictures that show the stretch, with the bound marked that the solver means to keep.
renderer::Legend stretch_legend(const DrawnScene& scene);

}  // namespace taut::app
