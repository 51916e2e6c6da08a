// Sews the T-shirt from its pattern, fits it to a body and writes it at three resolutions.

#include <chrono>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "fit.hpp"
#include "flat_lengths.hpp"
#include "lift.hpp"
#include "model_file.hpp"
#include "quality.hpp"
#include "sew.hpp"
#include "wrap.hpp"

namespace {

using namespace taut::tailor;

constexpr std::size_t model_sizes[] = {10600, 5280, 1028};  // the paper's three models

// What every model is held to before it is written.
constexpr double largest_rms_strain = 0.015;
constexpr double largest_strain = 0.10;
constexpr double smallest_angle_deg = 10.0;
constexpr double largest_area_error = 0.01;

/// A meshing of the pattern and how it is relaxed. Coarse ones find the shape in few steps, fine ones the
/// details.
struct FitLevel {
  std::size_t triangles;
  std::vector<FitPhase> phases;
};

const std::vector<FitLevel> fit_levels = {
    {1500, {{120, 0.10, 20.0}, {60, 0.05, 20.0}}},
    {6000, {{60, 0.10, 20.0}, {60, 0.05, 20.0}}},
    {24000, {{60, 0.10, 20.0}, {60, 0.02, 20.0}}},
};

struct FittedShirt {
  Shirt shirt;
  std::vector<Vec3> positions;
};

[[noreturn]] void refuse(const std::string& what, double found, const char* relation, double limit) {
  throw std::runtime_error(what + " is " + std::to_string(found) + "; expected " + relation + " " +
                           std::to_string(limit));
}

FittedShirt fit_shirt(const std::array<Piece, piece_count>& pieces, const Stance& stance) {
  FittedShirt fitted;
  for (const FitLevel& level : fit_levels) {
    Shirt shirt = sew_shirt(pieces, level.triangles, level.triangles);
    std::vector<Vec3> positions = fitted.positions.empty()
                                      ? wrap_shirt(shirt, stance)
                                      : lift_onto(shirt, fitted.shirt, fitted.positions);
    positions = relax_on_body(shirt, positions, stance, level.phases);
    fitted = {std::move(shirt), std::move(positions)};
    const Strain strain = measure_strain(fitted.shirt, fitted.positions);
    std::printf("fitted %6zu triangles: strain %.2f %% root mean square, %.2f %% at worst\n",
                level.triangles, 100.0 * strain.root_mean_square, 100.0 * strain.worst);
  }
  return fitted;
}

void check_fit(const FittedShirt& fitted) {
  const Strain strain = measure_strain(fitted.shirt, fitted.positions);
  if (strain.root_mean_square > largest_rms_strain) {
    refuse("the strain's root mean square", strain.root_mean_square, "at most", largest_rms_strain);
  }
  if (strain.worst > largest_strain) {
    refuse("the worst strain", strain.worst, "at most", largest_strain);
  }
}

void check_model(const MeshQuality& quality, std::size_t triangles, double fine_area_m2) {
  const auto& topology = quality.topology;
  if (quality.triangles != triangles || topology.components != 1 || topology.boundary_loops != 4 ||
      topology.euler_characteristic != -2 || topology.non_manifold_edges + topology.non_manifold_vertices +
              topology.misoriented_edges != 0) {
    throw std::runtime_error("the model of " + std::to_string(triangles) +
                             " triangles is not one oriented surface with four openings");
  }
  if (quality.smallest_angle_deg < smallest_angle_deg) {
    refuse("the smallest angle", quality.smallest_angle_deg, "at least", smallest_angle_deg);
  }
  const double area_error = quality.area_m2 / fine_area_m2 - 1.0;
  if (std::abs(area_error) > largest_area_error) {
    refuse("the area's error", area_error, "at most", largest_area_error);
  }
  if (quality.volume_m3 <= 0.0 || quality.crossings != 0) {
    refuse("the number of self-intersections", static_cast<double>(quality.crossings), "outside out and", 0);
  }
}

void print_quality(const MeshQuality& q, double fine_area_m2) {
  std::printf("| %zu | %zu | %.1f | %.1f | %.1f | %.1f | %+.2f | %zu |\n", q.triangles, q.vertices,
              q.smallest_angle_deg, 1e3 * q.shortest_edge_m, 1e3 * q.mean_edge_m, 1e3 * q.longest_edge_m,
              100.0 * (q.area_m2 / fine_area_m2 - 1.0), q.crossings);
}

void make_tshirts(const std::filesystem::path& pattern_file, const std::filesystem::path& folder) {
  const Pattern pattern = read_pattern(pattern_file);
  const auto pieces = cut_pieces(pattern);
  const FittedShirt fitted = fit_shirt(pieces, Stance{});
  const double fine_area_m2 = measure_quality(make_model(fitted.shirt, fitted.positions).mesh).area_m2;
  std::filesystem::create_directories(folder);
  std::printf("| triangles | vertices | smallest angle, degrees | shortest, mean, longest edge, mm | area, %% | crossings |\n");
  for (const std::size_t size : model_sizes) {
    const Shirt shirt = sew_shirt(pieces, size, size);
    const Model model = make_model(shirt, lift_onto(shirt, fitted.shirt, fitted.positions));
    const MeshQuality quality = measure_quality(model.mesh);
    print_quality(quality, fine_area_m2);
    write_model(model, folder, "tshirt_" + std::to_string(size),
                "# A T-shirt of " + std::to_string(size) + " triangles, in metres.\n# Sewn from: " +
                    pattern.source + ".\n# Licence of the pattern: " + pattern.licence + ".\n");
    check_model(quality, size, fine_area_m2);
  }
  check_fit(fitted);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    make_tshirts(arguments.at(0), arguments.at(1));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_tshirt: %s\n", error.what());
    return 1;
  }
  return 0;
}
