#pragma once

#include "app/drawing/drawn_scene.hpp"
#include "renderer/surface/smooth_surface.hpp"

namespace taut::app {

/// The drawn bodies of a scene. Meshes get a finer surface through their vertices.
class DrawnBodies {
 public:
  explicit DrawnBodies(std::vector<sim::Body> bodies);

  const std::vector<sim::Body>& bodies() const { return bodies_; }

  /// Sets the detail as GarmentSurface::set_detail does.
  void set_detail(float pixels_per_m, std::optional<float> min_edge_px);
  /// Moves the bodies to this time. `clearances_m`: as in renderer::SmoothSurface, for the vertices of all meshes in
  /// order; empty: no cloth is near.
  void move_to(double time_s, std::span<const float> clearances_m);
  /// Returns the drawn surfaces. They are valid until the next call of any other function.
  std::vector<renderer::SurfaceView> views() const;

 private:
  struct ShownMesh {
    std::vector<glm::vec3> rest_positions;
    std::vector<std::uint32_t> triangles;
    float edge_m = 0.0F;
    std::size_t first_clearance = 0;
    int levels = 0;
    std::optional<renderer::SmoothSurface> surface = {};
  };

  std::vector<sim::Body> bodies_;
  bool move_;
  std::map<std::size_t, ShownMesh> meshes_;                 ///< key: body index
  std::vector<std::vector<renderer::TriangleMesh>> round_;  ///< balls and capsules of each body
  std::optional<double> placed_s_;
};

/// Returns arrows of a wind that blows at a garment with these positions in metres: line segments of two points each,
/// beside the garment, on the side of the picture that the wind comes from. Their length is proportional to the speed,
/// up to the size of the garment. There are none without wind. Gusts are not shown.
std::vector<glm::vec3> wind_arrows(const sim::Wind& wind, const std::vector<sim::Vec3>& positions,
                                   const renderer::Camera& camera);

/// Returns the three vertices of each triangle, in one list.
inline std::vector<std::uint32_t> flat(const std::vector<sim::Triangle>& triangles) {
  std::vector<std::uint32_t> indices;
  indices.reserve(triangles.size() * 3);
  for (const sim::Triangle& t : triangles) indices.insert(indices.end(), t.begin(), t.end());
  return indices;
}

struct LoadedGarment;

/// Returns the points in single precision. A coordinate too large for a float becomes the largest float.
std::vector<glm::vec3> to_float(std::span<const sim::Vec3> points);

/// Returns the mean of the points, of which there must be at least one.
glm::vec3 mean_position(std::span<const sim::Vec3> points);

/// Returns the box in metres that the garment is expected to stay in. It contains the modelled shape, each vertex
/// hanging straight below its nearest pin, and the bodies at the start. It depends only on the scene, so all frames
/// have the same camera.
renderer::Box expected_reach(const DrawnScene& scene, const sim::Garment& garment, std::span<const sim::Body> bodies,
                             std::span<const sim::Index> pins);

/// Returns the height in metres of the first level plane among the bodies at this time; empty if there is none.
std::optional<float> level_plane(std::span<const sim::Body> bodies, double time_s);

/// Returns the azimuth in radians that shows the broad side of a box of this size: 0, or a quarter turn if the box is
/// much deeper than wide.
float azimuth_of_broad_side(const glm::vec3& size);

/// Returns the box around a body at this time, in metres; empty for a plane.
std::optional<renderer::Box> bounding_box(const sim::Body& body, double time_s);

/// Returns the direction to look from, for a scene in this box.
renderer::Framing choose_framing(const DrawnScene& scene, const renderer::Box& reach);

/// Turns the camera to the garment's front if its neckline shows where that is and the scene sets no direction.
void face_front(const LoadedGarment& loaded, DrawnScene& scene);

/// Returns a camera at `eye`. Its near plane is close to the eye and its far plane far behind the target.
renderer::Camera camera_at(const glm::vec3& eye, const glm::vec3& target, float vertical_fov_rad);
/// Returns the camera of a scene's pictures. `aspect`: width over height. A garment from a file is viewed from its
/// broad side if the scene sets no direction.
renderer::Camera scene_camera(const DrawnScene& scene, const renderer::Box& reach, float aspect);

/// Returns the height of the floor in metres; empty if there is no floor.
std::optional<float> ground_height(const DrawnScene& scene, std::span<const sim::Body> bodies,
                                   const renderer::Box& reach);

/// Returns true if the camera is fitted to the pictures' content, because the scene sets neither its position nor a
/// box.
bool is_fitted(const DrawnScene& scene);

/// Collects the content of a run's pictures, then places the camera so that the content fills the picture.
class FittedView {
 public:
  /// `scene` and `garment` must outlive this object.
  FittedView(const DrawnScene& scene, const sim::Garment& garment, std::vector<sim::Body> bodies);

  /// Adds the garment at these positions in metres and the bodies at this time. `shown`: positions of the drawn
  /// vertices, which differ if a model follows the garment and may reach farther.
  void add(const std::vector<sim::Vec3>& positions, const std::vector<sim::Vec3>& shown, double time_s);

  /// Sets camera.eye and camera.target, and picture.ground if it is automatic and there is no level plane. The scene
  /// then draws the same pictures for any range of frames. Changes nothing if nothing was added.
  void place_camera(DrawnScene& scene) const;

 private:
  const DrawnScene& scene_;
  std::vector<sim::Body> bodies_;
  const sim::Garment& garment_;
  renderer::Framing framing_;
  float aspect_;
  std::vector<glm::vec3> outermost_;  ///< points of every frame that decide the fit
  float min_height_m_ = INFINITY;
  float max_height_m_ = -INFINITY;
};

}  // namespace taut::app
