#pragma once

#include "app/drawing/drawn_scene.hpp"
#include "renderer/surface/smooth_surface.hpp"

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

/// Three vertices for each triangle.
inline std::vector<std::uint32_t> flat(const std::vector<sim::Triangle>& triangles) {
  std::vector<std::uint32_t> indices;
  indices.reserve(triangles.size() * 3);
  for (const sim::Triangle& t : triangles) indices.insert(indices.end(), t.begin(), t.end());
  return indices;
}

struct LoadedGarment;

/// The points in single precision. A coordinate too large for a float becomes the largest float.
std::vector<glm::vec3> to_float(const std::vector<sim::Vec3>& points);

/// The mean of the points, in single precision. At least one point.
glm::vec3 mean_of(std::span<const sim::Vec3> points);

/// The box in metres that the garment is expected to stay in. It holds the shape as modelled, each vertex
/// hanging straight below its nearest pin, and bodies where they begin. It depends only on the scene, so all
/// frames have the same camera.
renderer::Box expected_reach(const DrawnScene& scene, const sim::Garment& garment, std::span<const sim::Index> pins);

/// Height in metres of the first level plane among the bodies at this time. Empty if there is none.
std::optional<float> level_plane(std::span<const sim::Body> bodies, double time_s);

/// Returns by how much, in radians, a camera goes around what has this size to see its broad side: 0 from +z,
/// a quarter turn where it is far deeper than wide.
float azimuth_of_broad_side(const glm::vec3& size);

/// The box around a body at this time, in metres. Empty for a plane.
std::optional<renderer::Box> box_of(const sim::Body& body, double time_s);

/// From where a scene is seen that reaches so far.
renderer::Framing framing_of(const DrawnScene& scene, const renderer::Box& reach);

/// Has the garment seen from its front, where its neckline says where that is and the scene does not say from
/// where.
void face_front(const LoadedGarment& loaded, DrawnScene& scene);

/// A camera at a place of its own, which sees from near by to far behind the target.
renderer::Camera camera_at(const glm::vec3& eye, const glm::vec3& target, float vertical_fov_rad);
/// The camera of a scene's pictures. `aspect` is width over height. Where the scene does not say from where,
/// a garment from a file is seen from its broad side.
renderer::Camera scene_camera(const DrawnScene& scene, const renderer::Box& reach, float aspect);

/// Height of the floor in metres. Empty if there is no floor.
std::optional<float> ground_height(const DrawnScene& scene, const renderer::Box& reach);

/// Whether the camera of the scene's pictures is fitted to what they show: neither its place nor a box is
/// given.
bool is_fitted(const DrawnScene& scene);

/// Gathers what a run's pictures show, then places the camera so that all of it fills the picture.
class FittedView {
 public:
  /// `scene` and `garment` must outlive this object.
  FittedView(const DrawnScene& scene, const sim::Garment& garment);

  /// Adds the garment at these positions, in metres, and the bodies at this time. `shown` are those that are
  /// drawn, of a model that follows: it may reach farther.
  void add(const std::vector<sim::Vec3>& positions, const std::vector<sim::Vec3>& shown, double time_s);

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

}  // namespace taut::app
