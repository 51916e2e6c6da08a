#include "tailor/recipe.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "tailor/dressing/fit.hpp"
#include "tailor/dressing/lift.hpp"
#include "tailor/dressing/wrap.hpp"
#include "tailor/sewing/sew.hpp"

namespace taut::tailor {
namespace {

/// A meshing of the pattern and how it is relaxed. Coarse ones find the shape in few steps, fine ones the
/// details.
struct FitLevel {
  std::size_t triangles;
  std::vector<FitPhase> phases;
};

const std::array<FitLevel, 3>& fit_levels() {
  static const std::array<FitLevel, 3> levels = {{
      {1500, {{.frames = 600, .flexural = 0.03, .air_drag_per_s = 5.0}}},
      {6000, {{.frames = 120, .flexural = 0.05, .air_drag_per_s = 10.0}}},
      {24000,
       {{.frames = 30, .flexural = 0.05, .air_drag_per_s = 10.0},
        {.frames = 15, .flexural = 0.02, .air_drag_per_s = 20.0}}},
  }};
  return levels;
}

// A reduced shirt is smaller than the fine one, because its edges are chords. Relaxing for a moment restores
// its size.
constexpr FitPhase settling = {.frames = 10, .flexural = 0.02, .air_drag_per_s = 60.0};

// From the pattern for cisMaleAdult40.
constexpr double male_half_chest_m = 0.29484;
constexpr double male_cuff_m = 0.43096;

constexpr double largest_rms_strain = 0.015;
constexpr double largest_strain = 0.10;
constexpr double smallest_angle_deg = 10.0;
constexpr double largest_area_error = 0.01;

void require(bool kept, const std::string& what, double found, const std::string& expected) {
  if (!kept) {
    throw std::runtime_error(what + " is " + std::to_string(found) + ", expected " + expected);
  }
}

/// Every meshing has its own seed, so that none depends on which others were made before it.
Shirt sew(const std::array<Piece, piece_count>& pieces, std::size_t triangle_count) {
  return sew_shirt(pieces, triangle_count, triangle_count);
}

}  // namespace

Stance stance_of(const Pattern& pattern) {
  Stance stance;
  if (!pattern.wearer.empty()) {
    stance.neck_point_height_m = pattern.neck_point_height_m;
    stance.trunk = pattern.front.side_seam.back().x / male_half_chest_m;
    stance.sleeve = std::abs(pattern.sleeve.cuff.back().x - pattern.sleeve.cuff.front().x) / male_cuff_m;
  }
  return stance;
}

FittedShirt fit_shirt(const std::array<Piece, piece_count>& pieces, const Stance& stance,
                      const FitProgress& progress) {
  FittedShirt fitted;
  for (const FitLevel& level : fit_levels()) {
    FittedShirt next = {sew(pieces, level.triangles), {}};
    next.positions = fitted.positions.empty() ? wrap_shirt(next.shirt, stance)
                                              : lift_onto(next.shirt, fitted.shirt, fitted.positions);
    next.positions = relax_on_body(next.shirt, next.positions, stance, level.phases);
    fitted = std::move(next);
    progress(fitted);
  }
  return fitted;
}

FittedShirt reduce_shirt(const std::array<Piece, piece_count>& pieces, const FittedShirt& fitted,
                         const Stance& stance, std::size_t triangle_count) {
  FittedShirt reduced = {sew(pieces, triangle_count), {}};
  reduced.positions = lift_onto(reduced.shirt, fitted.shirt, fitted.positions);
  reduced.positions = relax_on_body(reduced.shirt, reduced.positions, stance, {settling});
  return reduced;
}

void require_fit(const Strain& strain) {
  require(strain.root_mean_square <= largest_rms_strain, "the strain's root mean square",
          strain.root_mean_square, "at most " + std::to_string(largest_rms_strain));
  require(strain.worst <= largest_strain, "the worst strain", strain.worst,
          "at most " + std::to_string(largest_strain));
}

void require_quality(const MeshQuality& quality, std::size_t triangle_count, double fine_area_m2) {
  const auto number = [](auto count) { return static_cast<double>(count); };
  const sim::Topology& topology = quality.topology;
  require(quality.triangles == triangle_count, "the number of triangles", number(quality.triangles),
          std::to_string(triangle_count));
  require(topology.components == 1, "the number of components", number(topology.components), "1");
  require(topology.boundary_loops == 4, "the number of openings", number(topology.boundary_loops), "4");
  require(topology.euler_characteristic == -2, "the Euler characteristic",
          number(topology.euler_characteristic), "-2");
  const std::size_t faults =
      topology.non_manifold_edges + topology.non_manifold_vertices + topology.misoriented_edges;
  require(faults == 0, "the number of non-manifold or misoriented edges and vertices", number(faults), "0");
  require(quality.volume_m3 > 0.0, "the enclosed volume", quality.volume_m3, "more than 0: outside out");
  require(quality.crossings == 0, "the number of self-intersections", number(quality.crossings), "0");
  require(quality.smallest_angle_deg >= smallest_angle_deg, "the smallest angle", quality.smallest_angle_deg,
          "at least " + std::to_string(smallest_angle_deg) + " degrees");
  const double area_error = quality.area_m2 / fine_area_m2 - 1.0;
  require(std::abs(area_error) <= largest_area_error, "the error of the area", area_error,
          "at most " + std::to_string(largest_area_error));
}

}  // namespace taut::tailor
