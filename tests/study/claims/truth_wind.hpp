#pragma once

#include "tests/study/claims/truth_setups.hpp"

/// Setups and numbers of the experiments in wind.
namespace taut::app::truth {

using std::numbers::pi;

struct Flag {
  double length_m;
  double height_m;
  double density_kg_per_m2;
};

inline constexpr Flag standard_flag = {1.0, 0.6, 0.15};
inline constexpr int flag_settling_frames = 60 * 3;
inline constexpr int flag_watched_frames = 60 * 5;
/// Frequency of the standard flag times length over wind: our own number, which stands for "proportional".
inline constexpr double flag_reduced_frequency = 1.64;
/// Smallest amplitude of the standard flag in a stronger wind, over that at 4 m/s and 1 less the tolerance.
inline constexpr double min_amplitude_ratio = 0.75;

/// A square sheet, so heavy that the onset of its flutter follows the wind's pressure and not the speed of its waves.
inline constexpr double sheet_length_m = 0.4;
inline constexpr double sheet_density_kg_per_m2 = 2.0;
/// Frames in the time sqrt(density / rigidity) length^2, and frames of a run that shows the onset or the end.
inline constexpr double sheet_frames_per_unit = 200.0;
inline constexpr int onset_frames = 600, end_frames = 2000;
/// Range of winds for the search of the onset, over theory's wind, and the number of runs.
inline constexpr double min_onset_ratio = 0.8, max_onset_ratio = 1.2;
inline constexpr int onset_runs = 7;
/// Amplitudes at the start over length: small for the onset of flutter, large for its end.
inline constexpr double small_start = 1e-4, large_start = 0.1;
/// Amplitude over length above which a sheet still flutters.
inline constexpr double min_flutter = 0.01;

/// A square plate across the wind: side, mass and the time for which it is let go.
inline constexpr double plate_side_m = 0.4;
inline constexpr double plate_density_kg_per_m2 = 1.0;
inline constexpr double plate_rigidity_n_m = 1e-2;
inline constexpr int plate_frames = 6;
/// Published drag coefficients of a square plate.
inline constexpr double min_plate_drag = 1.1, max_plate_drag = 1.2;

/// Returns a flag on its pole in a steady wind along x.
sim::Simulation hoist_flag(const Size& size, const Flag& flag, double speed_m_per_s, double physics);

}  // namespace taut::app::truth
