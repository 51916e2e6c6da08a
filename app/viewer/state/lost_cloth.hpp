#pragma once

#include <span>
#include <string>

#include "app/viewer/state/orbit_camera.hpp"
#include "sim/mesh/types.hpp"

namespace taut::app {

/// What to tell a person who sees no cloth: that it has left the picture, or the world that the camera can
/// look at, and what to do. Empty where a triangle may be in the picture.
std::string lost_cloth(std::span<const sim::Vec3> positions, std::span<const sim::Triangle> triangles,
                       const OrbitCamera& camera, const ViewArea& area);

}  // namespace taut::app
