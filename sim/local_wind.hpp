#pragma once

#include "sim/surroundings.hpp"

namespace taut::sim {

/// Fraction of the wind's velocity that is left in the lee of a closed wall across it. Its square is the fraction of
/// the pressure. Larger values shelter less.
inline constexpr double lee_velocity_fraction = 0.55;
/// Size in m of the cells in which shelter is found. Smaller cells tell nearer layers apart and cost more.
inline constexpr double shelter_cell_m = 0.015;
/// Distance in cells from a wall to its lee. Smaller values shelter nearer layers; below 2, cloth that stands at an
/// angle shelters itself.
inline constexpr double lee_begins_cells = 2.0;
/// Cloth whose normal is at a smaller cosine to the wind shelters nothing, and fully from the larger one on. The air
/// follows a flag along the wind and meets all of it. Smaller values shelter more of it.
inline constexpr double min_blocking_cosine = 0.5;
inline constexpr double max_blocking_cosine = 0.9;
/// Largest number of parts of an edge. Larger values fill the lee of triangles of more than 2 m.
inline constexpr double max_parts_of_edge = 128.0;
/// Largest number of cells. Larger cells are used beyond it.
inline constexpr double max_shelter_cells = 262144.0;

/// Returns the velocity of the air, as a fraction of turned_wind_velocity(), that each triangle of the garment meets:
/// gusts (GustField) times shelter. Empty without wind. Positions are in m, one per vertex, at the time `time_s`.
///
/// Shelter: cloth and bodies upwind, except planes, block a part of the cross-section of each cell along the wind, and
/// all parts add up, to at most 1. A triangle meets the fraction 1 - (1 - lee_velocity_fraction) * blocked. All is
/// interpolated, so that fractions change little while shapes do. The wakes of blunt bodies are longer than any garment
/// (some ten widths), and the wind shadow of Keckeisen, Kimmerle, Thomaszewski and Wacker (2004) has no end either.
std::vector<float> find_wind_fractions(const Garment& garment, std::span<const Vec3> positions_m,
                                       const Surroundings& surroundings, double time_s);

/// Load of the wind on a garment.
struct WindLoad {
  Vec3 force_n = Vec3(0.0);  ///< sum over all triangles
  double power_w = 0.0;      ///< force times velocity, summed over all vertices; negative where air brakes the cloth
};

/// Measures the wind on the present shape, with the fractions of find_wind_fractions(). Zero without wind, though still
/// air too brakes moving cloth.
WindLoad measure_wind(const Garment& garment, const State& state, const Wind& wind, std::span<const float> fractions);

}  // namespace taut::sim
