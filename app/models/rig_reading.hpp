#pragma once

#include "app/models/rig.hpp"

struct aiScene;

namespace taut::app {

/// Returns what moves the vertices of a scene of the assimp library; empty if nothing does. Vertices are in
/// the order in which a walk down the tree of nodes meets them. Throws InputError with the reason, without
/// the file's name, if bones or animations mean a name that several nodes have.
///
/// `knows_mixture` is false for FBX: of a shape that a file mixes in by less, or not at all, assimp says all
/// the same that all of it is. None is then mixed in by itself.
Rig read_rig(const aiScene& scene, bool knows_mixture);

}  // namespace taut::app
