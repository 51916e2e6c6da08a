// Sews the T-shirt from its pattern, fits it to a body and writes it at three resolutions.

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "tailor/recipe.hpp"

namespace {

using namespace taut::tailor;

constexpr const char* usage =
    "Usage: make_tshirt [PATTERN [FOLDER]]\n"
    "\n"
    "Sews the T-shirt of a pattern file, fits it to a body, reduces it to 10600, 5280 and\n"
    "1028 triangles and writes tshirt_N.obj and tshirt_N.landmarks.toml. Of a pattern that\n"
    "names its wearer it is tshirt_NAME.obj, of 5280 triangles. The same pattern gives the\n"
    "same files, byte for byte.\n"
    "\n"
    "  PATTERN  outlines to sew            (default: assets/patterns/tshirt/teagan.toml)\n"
    "  FOLDER   where the garments go      (default: assets/garments)\n"
    "  --help   show this text\n"
    "\n"
    "Exit codes: 0 done, 1 the pattern could not be used or a garment failed its checks,\n"
    "2 wrong usage.\n";

void print_strain(const FittedShirt& shirt) {
  const Strain strain = measure_strain(shirt.shirt, shirt.positions);
  std::printf("%6zu triangles: strain %.2f %% root mean square, %.2f %% at worst\n",
              shirt.shirt.triangles().size(), 100.0 * strain.root_mean_square, 100.0 * strain.worst);
}

/// One row of the table in assets/README.md.
void print_quality(const MeshQuality& q, const Strain& strain, double fine_area_m2) {
  std::printf("| %zu | %zu | %.1f | %.1f / %.1f / %.1f | %+.2f | %.2f / %.2f |\n", q.triangles, q.vertices,
              q.smallest_angle_deg, 1e3 * q.shortest_edge_m, 1e3 * q.mean_edge_m, 1e3 * q.longest_edge_m,
              100.0 * (q.area_m2 / fine_area_m2 - 1.0), 100.0 * strain.root_mean_square,
              100.0 * strain.worst);
}

std::string header(const Pattern& pattern, std::size_t triangle_count) {
  return "# A T-shirt of " + std::to_string(triangle_count) +
         " triangles, in metres, y up, worn facing +z with the feet on y = 0.\n# Made by make_tshirt from " +
         pattern.source + ".\n# Licence of the pattern: " + pattern.licence + ".\n";
}

void make_tshirts(const std::filesystem::path& pattern_file, const std::filesystem::path& folder) {
  const Pattern pattern = read_pattern(pattern_file);
  const auto pieces = cut_pieces(pattern);
  const Stance stance = stance_of(pattern);
  std::printf("Fitted to the body:\n");
  const FittedShirt fitted = fit_shirt(pieces, stance, print_strain);
  require_fit(measure_strain(fitted.shirt, fitted.positions));
  const double fine_area_m2 = measure_quality(make_model(fitted.shirt, fitted.positions).mesh).area_m2;

  std::filesystem::create_directories(folder);
  std::printf(
      "\n| triangles | vertices | smallest angle, degrees | shortest / mean / longest edge, mm "
      "| area, %% | strain, %% |\n");
  const bool is_first = pattern.wearer.empty();
  for (const std::size_t size :
       is_first ? std::vector(model_sizes.begin(), model_sizes.end()) : std::vector{other_size}) {
    const FittedShirt reduced = reduce_shirt(pieces, fitted, stance, size);
    const Model model = make_model(reduced.shirt, reduced.positions);
    const MeshQuality quality = measure_quality(model.mesh);
    const Strain strain = measure_strain(reduced.shirt, reduced.positions);
    print_quality(quality, strain, fine_area_m2);
    require_quality(quality, size, fine_area_m2);
    require_fit(strain);
    write_model(model, folder, "tshirt_" + (is_first ? std::to_string(size) : pattern.wearer),
                header(pattern, size));
  }
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
    make_tshirts(!arguments.empty() ? arguments[0] : "assets/patterns/tshirt/teagan.toml",
                 arguments.size() > 1 ? arguments[1] : "assets/garments");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_tshirt: %s\n", error.what());
    return 1;
  }
  return 0;
}
