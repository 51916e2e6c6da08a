#pragma once

#include "renderer/frame_view.hpp"
#include "renderer/primitives.hpp"

namespace taut::renderer {

/// Returns the spheres of one group as one mesh.
TriangleMesh merged_spheres(const SphereView& spheres);

/// Returns the mesh as a surface with the group's colour. The mesh must outlive the view.
SurfaceView view_of(const TriangleMesh& mesh, const SphereView& spheres);

}  // namespace taut::renderer
