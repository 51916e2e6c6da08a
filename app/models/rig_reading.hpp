#pragma once

#include "app/models/rig.hpp"

struct aiScene;

namespace taut::app {

/// Returns what moves the vertices of a scene of the assimp library; empty if nothing does. Vertices are in
/// the order in which a walk down the tree of nodes meets them. Throws InputError with the reason, without
/// the file's name, if bones or animations mean a name that several nodes have.
Rig read_rig(const aiScene& scene);

}  // namespace taut::app
