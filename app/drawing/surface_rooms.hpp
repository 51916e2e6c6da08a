#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/drawing/drawn_scene.hpp"
#include "renderer/surface/smooth_surface.hpp"
#include "sim/garment.hpp"
#include "sim/solvers/bounded/contact/clearances.hpp"

namespace taut::app {

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

}  // namespace taut::app
