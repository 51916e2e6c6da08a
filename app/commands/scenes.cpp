#include <fmt/core.h>

#include <algorithm>
#include <sstream>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/commands/options.hpp"
#include "app/drawing/drawn_scene_file.hpp"
#include "app/scene/scene_format.hpp"

namespace taut::app {
namespace {

// A line before the key's; empty for what has no meaning of its own.
std::string meaning_of(const SceneFormat<DrawnScene>& format, const std::string& name) {
  const auto key = std::find_if(format.keys.begin(), format.keys.end(),
                                [&](const Key<DrawnScene>& known) { return known.name == name; });
  if (key == format.keys.end() || key->meaning.empty()) {
    return "";
  }
  const std::string first_sentence = key->meaning.substr(0, key->meaning.find(". "));
  return "# " + first_sentence + (key->unit.empty() ? "" : " (" + key->unit + ")") + '\n';
}

// The file as it stands, which has its own remarks. Paths that lead from it to the program's assets become
// ones that are found from anywhere.
std::string commented(const std::string& text) {
  const SceneFormat<DrawnScene> format = drawn_scene_format();
  std::istringstream lines(text);
  std::string section;
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find(" = ");
    if (line.starts_with('[')) {
      section = line.substr(1, line.find(']') - 1) + '.';
    } else if (equals != std::string::npos && !line.starts_with('#')) {
      result += meaning_of(format, section + line.substr(0, equals));
      for (std::size_t up = line.find("../"); up != std::string::npos; up = line.find("../")) {
        line.erase(up, 3);
      }
    }
    result += line + '\n';
  }
  return result;
}

int show(const std::string& name) {
  const FoundScene found = locate_scene(name);
  if (found.is_garment) {
    throw UsageError(name + ": expected a scene, found a garment file");
  }
  fmt::print(
      "# A scene of taut to start from: taut render FILE.toml draws it, taut help scene lists all keys.\n{}",
      commented(read_text_file(found.file)));
  return 0;
}

}  // namespace

int run(const ScenesOptions& options) {
  if (!options.show.empty()) {
    return show(options.show);
  }
  const std::vector<BuiltInScene> scenes = built_in_scenes();
  if (scenes.empty()) {
    throw InputError("no built-in scenes were found; set TAUT_ASSETS to the folder that holds scenes/");
  }
  std::size_t width = 0;
  for (const BuiltInScene& scene : scenes) {
    width = std::max(width, scene.name.size());
  }
  bool is_of_contact = scenes.front().is_of_contact;
  for (const BuiltInScene& scene : scenes) {
    fmt::print("{}{:<{}}  {}\n", scene.is_of_contact == is_of_contact ? "" : "\n", scene.name, width,
               read_scene_file(scene.file).title);
    is_of_contact = scene.is_of_contact;
  }
  return 0;
}

int run(const HelpOptions& options) {
  fmt::print("{}", options.text);
  return 0;
}

}  // namespace taut::app
