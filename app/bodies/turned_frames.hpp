#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/bodies/body_mesh.hpp"
#include "app/bodies/frame_source.hpp"

namespace taut::app {

/// Returns a motion of vertices in the axes of its body's file. Programs write caches in axes of their own:
/// Blender MDD with z up beside OBJ with y up, LightWave MDD in a left-handed system. Of such systems the one
/// is taken in which the first frame is nearest to the body, if that is clearly nearer; it is said in
/// `remarks`. A motion of joints is returned as it is. Requires a frame source with the vertices of the
/// body's file.
std::unique_ptr<const FrameSource> in_axes_of(const LoadedMesh& body,
                                              std::unique_ptr<const FrameSource> motion,
                                              std::vector<std::string>& remarks);

}  // namespace taut::app
