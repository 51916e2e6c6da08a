#pragma once

#include "renderer/frame_view.hpp"
#include "renderer/surface/smooth_surface.hpp"
#include "sim/contact/bodies.hpp"
#include "sim/forces.hpp"

namespace taut::app {

/// The bodies of a scene as they are drawn: meshes with a finer surface along their vertices.
class DrawnBodies {
 public:
  explicit DrawnBodies(std::vector<sim::Body> bodies);

  const std::vector<sim::Body>& bodies() const { return bodies_; }

  /// As of GarmentSurface.
  void set_detail(float pixels_per_m, std::optional<float> shortest_edge_px);
  /// Moves them to where they are at this time. `rooms_m` as of renderer::SmoothSurface, for the vertices of
  /// all meshes, one after the other; none: no cloth is near.
  void place(double time_s, std::span<const float> rooms_m);
  /// Their surfaces, as they are drawn. Valid until the next call of any other function.
  std::vector<renderer::SurfaceView> views() const;

 private:
  struct Mesh {
    std::vector<glm::vec3> rest_positions;
    std::vector<std::uint32_t> triangles;
    float edge_m = 0.0F;
    std::size_t first_room = 0;
    int levels = 0;
    std::optional<renderer::SmoothSurface> surface = {};
  };

  std::vector<sim::Body> bodies_;
  bool move_;
  std::map<std::size_t, Mesh> meshes_;                      ///< by body
  std::vector<std::vector<renderer::TriangleMesh>> round_;  ///< of each body: its balls and capsules
  std::optional<double> placed_s_;
};

/// Arrows of a wind that blows at a garment with these positions, in metres: line segments, two points each,
/// on the side it comes from. Twice as long for twice the speed, up to the size of the garment. Without wind
/// there are none. Gusts are not shown.
std::vector<glm::vec3> wind_arrows(const sim::Wind& wind, const std::vector<sim::Vec3>& positions);

}  // namespace taut::app
