#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "app/drawing/drawn_scene.hpp"
#include "renderer/camera.hpp"
#include "sim/contact/bodies.hpp"
#include "sim/garment.hpp"

namespace taut::app {

struct LoadedGarment;

/// The points in single precision. A coordinate too large for a float becomes the largest float.
std::vector<glm::vec3> to_float(const std::vector<sim::Vec3>& points);

/// The mean of the points, in single precision. At least one point.
glm::vec3 mean_of(std::span<const sim::Vec3> points);

/// Where the vertices of a body that is a mesh are at this time, in metres.
std::vector<glm::vec3> mesh_positions(const sim::Body& body, double time_s);

/// The box in metres that the garment is expected to stay in. It holds the shape as modelled, each vertex
/// hanging straight below its nearest pin, and bodies where they begin. It depends only on the scene, so all
/// frames have the same camera.
renderer::Box expected_reach(const DrawnScene& scene, const sim::Garment& garment,
                             std::span<const sim::Index> pins);

/// Height in metres of the first level plane among the bodies at this time. Empty if there is none.
std::optional<float> level_plane(std::span<const sim::Body> bodies, double time_s);

/// Height in metres of the lowest point of the bodies that are meshes, when the run begins; empty if there
/// are none or they float above lowest_m, which is that of everything.
std::optional<float> standing_height(std::span<const sim::Body> bodies, float lowest_m);

/// Returns by how much, in radians, a camera goes around what has this size to see its broad side: 0 from +z,
/// a quarter turn where it is far deeper than wide.
float azimuth_of_broad_side(const glm::vec3& size);

/// The box around a body at this time, in metres. Empty for a plane.
std::optional<renderer::Box> box_of(const sim::Body& body, double time_s);

/// Width over height of a picture.
float aspect_of(const renderer::PictureSettings& settings);

/// From where a scene is seen that reaches so far.
renderer::Framing framing_of(const DrawnScene& scene, const renderer::Box& reach);

/// Has the garment seen from its front, where its neckline says where that is and the scene does not say from
/// where.
void face_front(const LoadedGarment& loaded, DrawnScene& scene);

/// Height in metres of a floor a little below what reaches from lowest_m to highest_m.
float ground_below(float lowest_m, float highest_m);

/// The camera of a scene's pictures. `aspect` is width over height. Where the scene does not say from where,
/// a garment from a file is seen from its broad side.
renderer::Camera scene_camera(const DrawnScene& scene, const renderer::Box& reach, float aspect);

/// Height of the floor in metres. Empty if there is no floor.
std::optional<float> ground_height(const DrawnScene& scene, const renderer::Box& reach);

}  // namespace taut::app
