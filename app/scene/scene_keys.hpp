#pragma once

#include <vector>

#include "app/scene/scene.hpp"
#include "app/scene/scene_key.hpp"

namespace taut::app {

/// Everything a scene file can say: the one table behind reading, `--set` and `taut help scene`.
std::vector<Key<Scene>> scene_keys();

/// What an entry of [[colliders]] can say, by its shape ("plane", "sphere" or "capsule").
std::vector<Key<sim::Collider>> collider_keys(const std::string& shape);

/// What an entry of [[forces]] can say.
std::vector<Key<sim::PointForce>> force_keys();

}  // namespace taut::app
