#pragma once

#include <span>
#include <string>

#include "app/viewer/state/orbit_camera.hpp"
#include "sim/mesh/types.hpp"

namespace taut::app {

/// Tells a user who sees no cloth that it left the picture, or the range of the camera, and what to do. Empty
/// if some triangle may be visible. `positions` are in metres, per vertex.
std::string lost_cloth(std::span<const sim::Vec3> positions, std::span<const sim::Triangle> triangles,
                       const OrbitCamera& camera, const ViewArea& area);

}  // namespace taut::app
