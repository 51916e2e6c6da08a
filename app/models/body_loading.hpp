#pragma once

#include "app/scene/scene.hpp"

namespace taut::app {

/// Reads the meshes of the scene's bodies and their frames; those that were read already are left alone.
/// Vertices at equal positions are welded, and triangles are turned to face outwards. Throws InputError that
/// names the body, the file and the place:
/// - on a mesh that is not closed: an edge with one triangle or with more than two, or a surface with one
/// side;
/// - on a triangle without area or given twice, and on a position that is not a number;
/// - on frames of another number of vertices, or in which a vertex jumps by more than a metre.
void load_bodies(Scene& scene);

}  // namespace taut::app
