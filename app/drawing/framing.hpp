#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "app/drawing/drawn_scene.hpp"
#include "renderer/camera.hpp"
#include "sim/garment.hpp"

namespace taut::app {

/// The points in single precision. A coordinate too large for a float becomes the largest float.
std::vector<glm::vec3> to_float(const std::vector<sim::Vec3>& points);

/// The box in metres that the garment is expected to stay in. It holds the shape as modelled, each vertex
/// hanging straight below its nearest pin, and bodies that are near. It depends only on the scene, so all
/// frames have the same camera.
renderer::Box expected_reach(const DrawnScene& scene, const sim::Garment& garment,
                             std::span<const sim::Index> pins);

/// The camera of a scene's pictures. `aspect` is width over height.
renderer::Camera scene_camera(const DrawnScene& scene, const renderer::Box& reach, float aspect);

/// Height of the floor in metres. Empty if there is no floor.
std::optional<float> ground_height(const DrawnScene& scene, const renderer::Box& reach);

}  // namespace taut::app
