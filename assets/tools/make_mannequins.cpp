// Makes the mannequins from published measurements: closed surfaces with joints and weights.

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "app/base/files.hpp"
#include "tailor/mannequin/details.hpp"
#include "tailor/mannequin/glb.hpp"

namespace {

using namespace taut::tailor;

constexpr const char* usage =
    "Usage: make_mannequins [RECIPES [FOLDER]]\n"
    "\n"
    "Makes mannequin_SIZE.glb, skinned, for the sizes male_40, female_34 and female_42. The same\n"
    "recipes give the same files, byte for byte.\n"
    "\n"
    "  RECIPES  folder of measurements.toml, male.toml and female.toml\n"
    "           (default: assets/bodies/mannequin)\n"
    "  FOLDER   where the bodies go                  (default: assets/bodies)\n"
    "  --help   show this text\n"
    "\n"
    "Exit codes: 0 done, 1 a recipe could not be used or a girth not be met, 2 wrong usage.\n";

constexpr const char* origin =
    "Taut, MIT licence; girths: FreeSewing, @freesewing/models 4.10.2, MIT licence";

void make_mannequin(const std::filesystem::path& recipes, const std::filesystem::path& folder,
                    const std::string& size) {
  const ShapeRecipe shape = read_shape(recipes / (size.substr(0, size.find('_')) + ".toml"));
  const std::filesystem::path measurements = recipes / "measurements.toml";
  Body body = make_body(shape, read_measurements(measurements, shape.reference),
                        read_measurements(measurements, size));
  FittedBody fitted = fit(body);
  std::vector<VertexWeights> weights = make_weights(body, fitted);
  add_details(body.shape, fitted, weights);
  const std::string name = "mannequin_" + size;
  const auto bytes = make_glb(name, origin, body, fitted.whole, weights);
  taut::app::write_file(folder / (name + ".glb"), bytes);
  std::printf("%s.glb: %zu triangles, %zu kB, girths to %.2f mm\n", name.c_str(),
              fitted.whole.triangles.size(), bytes.size() / 1000, 1e3 * fitted.worst_error_m);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (!arguments.empty() && (arguments[0] == "--help" || arguments[0] == "-h")) {
    std::fputs(usage, stdout);
    return 0;
  }
  if (arguments.size() > 2 || (!arguments.empty() && arguments[0].starts_with("-"))) {
    std::fputs(usage, stderr);
    return 2;
  }
  try {
    for (const char* size : {"male_40", "female_34", "female_42"}) {
      make_mannequin(!arguments.empty() ? arguments[0] : "assets/bodies/mannequin",
                     arguments.size() > 1 ? arguments[1] : "assets/bodies", size);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_mannequins: %s\n", error.what());
    return 1;
  }
  return 0;
}
