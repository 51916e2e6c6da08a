// Random keys, pointer movements, drops and resizes into the viewer without a window.
//   view_fuzz SECONDS SEED
// Fails by a crash, by an exception that no person should meet, or by memory that keeps growing. It saves the input
// as view_fuzz.session, for `taut view --headless --script`.

#include <fmt/core.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <random>

#include "app/drawing/drawn_scene.hpp"
#include "app/viewer/headless_viewer.hpp"
#include "app/viewer/state/viewer_state.hpp"

namespace {

using namespace taut;
using namespace taut::app;
namespace fs = std::filesystem;

constexpr double growth_limit = 1.3;
// The timeline of the largest scene fills up, and libraries keep pools.
constexpr double slack_mb = 200.0;

double resident_mb() {
  std::ifstream file("/proc/self/statm");
  double total_pages = 0.0;
  double resident_pages = 0.0;
  file >> total_pages >> resident_pages;
  return resident_pages * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

class RandomInput {
 public:
  RandomInput(unsigned seed, const fs::path& folder) : random_(seed) {
    std::ofstream(folder / "empty.obj");
    std::ofstream(folder / "notes.obj") << "Buy milk.\n";
    std::ofstream(folder / "points.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    std::ofstream(folder / "broken.toml") << "[garment.grid\n";
    std::ofstream(folder / "huge.obj") << "v 1e300 0 0\nv 0 1e300 0\nv 0 0 1e300\nf 1 2 3\n";
    drops_ = {(folder / "empty.obj").string(),
              (folder / "notes.obj").string(),
              (folder / "points.obj").string(),
              (folder / "broken.toml").string(),
              (folder / "huge.obj").string(),
              folder.string(),
              "/dev/null",
              "no such file",
              "",
              std::string(TAUT_TESTS_FOLDER) + "/golden/scenes/obstacles.toml"};
  }

  SessionFrame frame(const ViewerState& state) {
    SessionFrame frame;
    const int count = below(4);
    for (int i = 0; i < count; ++i) {
      frame.events.push_back(event(state));
    }
    frame.elapsed_s = below(20) == 0 ? 0.5 : 1.0 / 60.0;
    return frame;
  }

 private:
  int below(int limit) { return std::uniform_int_distribution<int>(0, limit - 1)(random_); }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  SessionEvent event(const ViewerState& state) {
    const int choice = below(100);
    if (choice < 30) {
      return at_something(state);
    }
    if (choice < 45) {
      return renderer::WindowEvent(renderer::PointerMoved{between(-50, 1400), between(-50, 900)});
    }
    if (choice < 75) {
      return renderer::WindowEvent(
          renderer::ButtonChanged{static_cast<renderer::PointerButton>(below(3)), below(2) == 0});
    }
    if (choice < 90) {
      return renderer::WindowEvent(renderer::KeyChanged{key(), below(2) == 0});
    }
    if (choice < 94) {
      return renderer::WindowEvent(renderer::WheelTurned{between(-2, 2), between(-3, 3)});
    }
    return rare_event();
  }

  SessionEvent at_something(const ViewerState& state) {
    if (state.places.empty()) {
      return renderer::WindowEvent(renderer::PointerMoved{between(0, 1280), between(0, 720)});
    }
    auto place = state.places.begin();
    std::advance(place, below(static_cast<int>(state.places.size())));
    const glm::vec2 lower = place->second.lower_px;
    const glm::vec2 upper = place->second.upper_px;
    return renderer::WindowEvent(renderer::PointerMoved{between(lower.x, std::max(lower.x + 1.0F, upper.x)),
                                                        between(lower.y, std::max(lower.y + 1.0F, upper.y))});
  }

  SessionEvent rare_event() {
    switch (below(12)) {
      case 0:
      case 1:
        return renderer::WindowEvent(
            renderer::FileDropped{drops_[static_cast<std::size_t>(below(static_cast<int>(drops_.size())))]});
      case 2:
        return renderer::WindowEvent(renderer::Resized{1, 1});
      case 3:
        return renderer::WindowEvent(renderer::Resized{0, 0});
      case 4:
      case 5:
      case 6:
        return renderer::WindowEvent(renderer::Resized{1 + below(900), 1 + below(600)});
      case 7:
        return renderer::WindowEvent(renderer::ScaleChanged{between(0.5, 3.0)});
      default:
        return renderer::WindowEvent(renderer::TextTyped{static_cast<char32_t>('0' + below(12))});
    }
  }

  int key() {
    const auto bindings = key_bindings();
    const int bound = bindings[static_cast<std::size_t>(below(static_cast<int>(bindings.size())))].key;
    return below(4) == 0 ? below(renderer::keys::last + 1) : bound;
  }

  std::mt19937 random_;
  std::vector<std::string> drops_;
};

int fuzz(double seconds, unsigned seed) {
  const fs::path folder = fs::absolute("view_fuzz_files");
  fs::remove_all(folder);
  fs::create_directories(folder / "kept");
  SessionStart start;
  start.scene = "pinned-9x9-5";
  start.size = {640, 400};
  HeadlessViewer viewer(find_scene(start.scene, {}), start, folder / "kept", "auto");
  SessionRecorder recorder("view_fuzz.session", start);
  RandomInput input(seed, folder);
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed_s = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  double settled_mb = 0.0;
  int frames = 0;
  for (; elapsed_s() < seconds; ++frames) {
    const SessionFrame frame = input.frame(viewer.viewer().state());
    recorder.add(frame);
    viewer.play(frame);
    if (frames % 4 == 0) {
      viewer.draw();
    }
    if (frames % 500 == 0) {
      fs::remove_all(folder / "kept");
      fs::create_directories(folder / "kept");
    }
    if (settled_mb == 0.0 && elapsed_s() > 0.4 * seconds) {
      settled_mb = resident_mb();
    }
  }
  viewer.viewer().finish_recording();
  const double final_mb = resident_mb();
  fmt::print("{} frames, {:.0f} MB after 40 % of the time, {:.0f} MB at the end\n", frames, settled_mb,
             final_mb);
  return final_mb > growth_limit * settled_mb + slack_mb ? 1 : 0;
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 3) {
    fmt::print(stderr, "usage: view_fuzz SECONDS SEED\n");
    return 2;
  }
  try {
    return fuzz(std::atof(arguments[1]), static_cast<unsigned>(std::atoi(arguments[2])));
  } catch (const std::exception& error) {
    fmt::print(stderr, "view_fuzz: {}\n", error.what());
    return 1;
  }
}
