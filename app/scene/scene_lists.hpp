#pragma once

#include "app/scene/scene.hpp"
#include "app/scene/scene_key.hpp"

namespace taut::app {

// Keys of scenes whose values are neither one number nor one name.

Key<Scene> pins_key();
Key<Scene> weld_key();
Key<Scene> gravity_path_key();
Key<Scene> forces_key();
Key<Scene> bodies_key();
Key<Scene> moving_pins_key();

/// A key for the direction of a model that is up.
template <class T, class Access>
Key<T> up_key(std::string name, Access access, std::string meaning) {
  std::vector<std::pair<std::string, std::optional<ModelAxis>>> choices = {{"auto", std::nullopt}};
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    choices.emplace_back(axis_names[i], static_cast<ModelAxis>(i));
  }
  Key<T> key = choice_key<T>(std::move(name), choices, access, std::move(meaning));
  key.expected = "\"auto\" or \"x\", \"-x\", \"y\", \"-y\", \"z\", \"-z\"";
  return key;
}

}  // namespace taut::app
