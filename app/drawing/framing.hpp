#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "app/drawing/drawn_scene.hpp"
#include "renderer/camera.hpp"
#include "sim/garment.hpp"

namespace taut::app {

/// What is too far for a float stays as far as one can say.
std::vector<glm::vec3> to_float(const std::vector<sim::Vec3>& points);

/// What a garment is expected to reach: its shape as modelled, each vertex hung straight below the nearest
/// pin, and what colliders are near. It depends on the scene alone, so every frame gets the same camera.
renderer::Box expected_reach(const DrawnScene& scene, const sim::Garment& garment,
                             std::span<const sim::Index> pins);

/// The camera of a scene's pictures.
renderer::Camera scene_camera(const DrawnScene& scene, const renderer::Box& reach, float aspect);

/// The height of the floor, if there is to be one.
std::optional<float> ground_height(const DrawnScene& scene, const renderer::Box& reach);

}  // namespace taut::app
