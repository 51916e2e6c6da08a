#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/drawing/drawn_scene.hpp"
#include "app/viewer/simulation/simulation_host.hpp"
#include "app/viewer/viewer.hpp"

namespace taut::test {

/// A person at the window, frame by frame.
struct Person {
  app::SimulationHost simulation;
  app::Viewer viewer;

  /// Opens the scene in a window that saves files in `folder`.
  explicit Person(const std::string& scene, const std::vector<app::Override>& overrides = {},
                  const std::filesystem::path& folder = ".")
      : simulation(app::find_scene(scene, overrides), app::SimulationHost::Runs::when_asked),
        viewer(simulation, {{1280, 720}, 1.0, folder, {}, false}) {
    wait(2);
  }
  void wait(int frames) {
    for (int i = 0; i < frames; ++i) {
      viewer.update({});
    }
  }
  void act(const std::vector<app::SessionEvent>& events) {
    app::SessionFrame frame;
    frame.events = events;
    viewer.update(frame);
  }
  void act(const app::SessionEvent& event) { act(std::vector{event}); }
  void press(int key) {
    act(renderer::WindowEvent(renderer::KeyChanged{key, true}));
    act(renderer::WindowEvent(renderer::KeyChanged{key, false}));
  }
  void point_at(const std::string& item) { act(app::PointAt{item}); }
  void click(const std::string& item) {
    point_at(item);
    act(renderer::WindowEvent(renderer::ButtonChanged{renderer::PointerButton::left, true}));
    act(renderer::WindowEvent(renderer::ButtonChanged{renderer::PointerButton::left, false}));
    wait(2);
  }
  bool shows(const std::string& item) const { return viewer.state().places.contains(item); }
};

}  // namespace taut::test
