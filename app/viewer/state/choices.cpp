#include "app/viewer/state/choices.hpp"

#include <algorithm>

#include "app/base/errors.hpp"
#include "app/drawing/drawn_scene_file.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

// "Figure 5, right: the T-shirt" is labelled "5, right".
std::string figure_label(const std::string& title) {
  const std::string figure = "Figure ";
  const std::size_t colon = title.find(':');
  return title.starts_with(figure) && colon != std::string::npos
             ? title.substr(figure.size(), colon - figure.size())
             : "";
}

}  // namespace

std::vector<Choice> scene_choices() {
  std::vector<Choice> choices;
  std::size_t count_without_contact = 0;
  for (const BuiltInScene& scene : built_in_scenes()) {
    try {
      choices.push_back({scene.name, figure_label(read_scene_file(scene.file).title), scene.file});
      count_without_contact += scene.is_of_contact ? 0 : 1;
    } catch (const InputError&) {
      continue;
    }
  }
  std::stable_sort(choices.begin(), choices.begin() + static_cast<std::ptrdiff_t>(count_without_contact),
                   [](const Choice& a, const Choice& b) { return a.label < b.label; });
  return choices;
}

std::vector<Choice> files_in(const std::string& folder, const std::string& ending) {
  std::vector<Choice> choices;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(assets_folder() / folder, error)) {
    if (entry.path().extension() == ending) {
      choices.push_back({entry.path().stem().string(), "", entry.path()});
    }
  }
  std::sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) { return a.name < b.name; });
  return choices;
}

}  // namespace taut::app
