#pragma once

#include "renderer/frame_view.hpp"
#include "renderer/primitives.hpp"

namespace taut::renderer {

/// All balls of one group in one mesh.
TriangleMesh merged_spheres(const SphereView& spheres);

/// The mesh as a surface with the looks of the group; the mesh has to outlive it.
SurfaceView view_of(const TriangleMesh& mesh, const SphereView& spheres);

}  // namespace taut::renderer
