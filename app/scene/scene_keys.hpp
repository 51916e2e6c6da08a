#pragma once

#include <vector>

#include "app/scene/scene.hpp"
#include "app/scene/scene_key.hpp"

namespace taut::app {

/// All keys that the simulation needs. Scene files, `--set` and `taut help scene` all use this table.
std::vector<Key<Scene>> scene_keys();

/// The keys of an entry of [[forces]].
std::vector<Key<sim::PointForce>> force_keys();

}  // namespace taut::app
