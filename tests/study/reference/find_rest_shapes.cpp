#include <cstdio>

#include "tests/study/reference/cases.hpp"

// find_rest_shapes GARMENTS FOLDER: writes the shapes at rest that the tests and the report compare with.

namespace reference {
namespace {

bool write(const std::filesystem::path& file, const Rest& rest) {
  std::FILE* out = std::fopen(file.c_str(), "w");
  if (out == nullptr) return false;
  std::fputs("# Written by find_rest_shapes: vertices at rest, in metres, and a ball's middle.\n", out);
  for (Eigen::Index k = 0; k < rest.x.size(); k += 3) {
    std::fprintf(out, "v %.10f %.10f %.10f\n", rest.x[k], rest.x[k + 1], rest.x[k + 2]);
  }
  return std::fclose(out) == 0;
}

int find_all(const std::filesystem::path& garments, const std::filesystem::path& folder) {
  for (const RestCase& what : kept_cases(garments)) {
    const Potential potential(what.cloth);
    const Rest rest = minimise(potential, flatten(what.start_m), {.max_force = 1e-5, .max_steps = 300});
    std::printf("%s: %d steps, force %.2g of a vertex' weight, %s, %.7f J\n", what.name.c_str(), rest.steps,
                rest.max_force, rest.is_stable ? "stable" : "not stable", potential.energies(rest.x).sum());
    if (!write(folder / (what.name + ".obj"), rest)) {
      std::fprintf(stderr, "cannot write to %s\n", folder.c_str());
      return 1;
    }
  }
  return 0;
}

}  // namespace
}  // namespace reference

int main(int argument_count, char** arguments) {
  if (argument_count != 3) {
    std::fputs("usage: find_rest_shapes GARMENTS FOLDER\n", stderr);
    return 2;
  }
  try {
    return reference::find_all(arguments[1], arguments[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "find_rest_shapes: error: %s\n", error.what());
    return 1;
  }
}
