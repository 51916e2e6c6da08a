#pragma once

#include "app/scene/scene.hpp"
#include "app/scene/scene_key.hpp"

namespace taut::app {

// Keys of scenes whose values are neither one number nor one name.

Key<Scene> file_key();
Key<Scene> start_key();
Key<Scene> checkpoint_key();
Key<Scene> pins_key();
Key<Scene> weld_key();
Key<Scene> forces_key();

/// The choices for the direction of a model that is up.
std::vector<std::pair<std::string, std::optional<ModelAxis>>> up_choices();

template <class T, class Access>
Key<T> up_key(std::string name, Access access, std::string meaning) {
  Key<T> key = choice_key<T>(std::move(name), up_choices(), access, std::move(meaning));
  key.expected = "\"auto\" or \"x\", \"-x\", \"y\", \"-y\", \"z\", \"-z\"";
  return key;
}

/// The pins that a name or a list means; empty for anything else. And the same as a list.
std::optional<std::vector<PinSelector>> pins_in(const toml::node& value);
Json json_of(const std::vector<PinSelector>& pins);

}  // namespace taut::app
