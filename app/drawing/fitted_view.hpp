#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "app/drawing/drawn_scene.hpp"
#include "sim/garment.hpp"

namespace taut::app {

/// Whether the camera of the scene's pictures is fitted to what they show: neither its place nor a box is
/// given, and camera.fit asks for it.
bool is_fitted(const DrawnScene& scene);

/// Gathers what a run's pictures show, then places the camera so that all of it fills the picture.
class FittedView {
 public:
  /// `scene` and `garment` must outlive this object.
  FittedView(const DrawnScene& scene, const sim::Garment& garment);

  /// Adds the garment at these positions, in metres, and the bodies at this time.
  void add(const std::vector<sim::Vec3>& positions, double time_s);

  /// Sets camera.eye and camera.target, and picture.ground where it is automatic and no level plane is there:
  /// the same scene then draws the same pictures, alone or in another range of frames. Changes nothing if
  /// nothing was added.
  void place_camera(DrawnScene& scene) const;

 private:
  const DrawnScene& scene_;
  const sim::Garment& garment_;
  renderer::Framing framing_;
  float aspect_;
  std::vector<glm::vec3> outermost_;  ///< of every frame the points that decide the fit
  float lowest_m_ = INFINITY;
  float highest_m_ = -INFINITY;
};

/// Share of the garment's vertices that the camera sees within the picture, 0 to 1.
float share_in_picture(const renderer::Camera& camera, float aspect, std::span<const sim::Vec3> positions);

}  // namespace taut::app
