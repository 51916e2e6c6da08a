#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/base/errors.hpp"
#include "app/bodies/body_loading.hpp"
#include "temporary_folder.hpp"

namespace taut::app {

/// A scene's only body, with the messages about it.
struct LoadedBody {
  sim::Body body;
  std::vector<std::string> remarks;

  const sim::BodyMesh& mesh() const { return std::get<sim::BodyMesh>(body.shape); }
  std::vector<sim::Vec3> positions_m(double time_s) const {
    std::vector<sim::Vec3> places_m(mesh().data->positions_m.size());
    sim::positions_at(body, time_s, places_m);
    return places_m;
  }
  /// All messages as one text.
  std::string said() const {
    std::string text;
    for (const std::string& remark : remarks) {
      text += remark + '\n';
    }
    return text;
  }
};

inline LoadedBody load(const BodySource& source) {
  Scene scene;
  scene.bodies.push_back({.body = {.name = "avatar", .shape = sim::BodyMesh{}}, .source = source});
  const LoadedBodies bodies = load_bodies(scene);
  LoadedBody loaded;
  loaded.remarks = bodies.remarks;
  loaded.body = bodies.all.front();
  return loaded;
}

inline std::string error_text(const BodySource& source) {
  return test::error_message<InputError>([&] { load(source); });
}

}  // namespace taut::app
