// Any text as a scene file. Only InputError may be thrown, and a scene that is written and read again is the same.
#include <cstdlib>
#include <string>

#include "app/base/errors.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "fuzz.hpp"

using namespace taut::app;

void taut::test::fuzz_scene(const std::uint8_t* data, std::size_t size) {
  try {
    DrawnScene scene = read_scene_text({reinterpret_cast<const char*>(data), size}, "fuzzed.toml");
    // A record names its garment relative to the assets; a scene file looks for it elsewhere.
    if (scene.garment.file.empty()) {
      const std::string text = scene_text(scene);
      if (scene_text(read_scene_text(text, "again.toml")) != text) {
        std::abort();
      }
    }
  } catch (const InputError&) {
  }
}
