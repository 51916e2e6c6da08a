#pragma once

#include "app/scene/scene.hpp"
#include "app/scene/scene_key.hpp"

namespace taut::app {

/// Where a scene's garment is a sewing pattern, sews it on the last body that is read from a file, and lets
/// the scene begin with what was sewn: a file for this pattern, body, fabric and bound in the folder for
/// temporary files, which is sewn once. Leaves other scenes alone. To be called before load_bodies(). Returns
/// what was done, for people. Throws as sew() does, and InputError if there is no body.
std::vector<std::string> sew_garment(Scene& scene, const std::function<void(const std::string&)>& stage = {});

/// sew_garment() and then load_bodies(), of a scene with these overrides. Returns and throws as both do.
std::vector<std::string> sew_and_load_bodies(Scene& scene, std::span<const Override> overrides = {},
                                             const std::function<void(const std::string&)>& stage = {});

}  // namespace taut::app
