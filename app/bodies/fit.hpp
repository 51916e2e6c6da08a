#pragma once

#include "app/scene/scene.hpp"

namespace taut::app {

/// How wide a garment is where a body has a girth.
struct FitRow {
  std::string name;                     ///< of the girth (body_girths.hpp), "hem" or "leg hem"
  double body_m = 0.0;                  ///< a tight tape around the body
  double garment_m = 0.0;               ///< the length of the cloth at rest
  std::optional<double> height_m = {};  ///< of the girth of a trunk; empty of others
  std::optional<double> worn_m = {};    ///< the length of the cloth there once it is worn
  double held_m = 0.0;                  ///< a tight tape around the body right there; 0: it is not known

  double ease_m() const { return garment_m - body_m; }
};

// Ease in m below which a garment is called so; from the last on it is loose.
inline constexpr double too_small_below_m = 0.0;
inline constexpr double tight_below_m = 0.04;
inline constexpr double fitted_below_m = 0.12;

/// Returns "too small", "tight", "fitted" or "loose"; of the shoulder width "narrow", "fitted" or "wide".
const char* fit_word(const FitRow& row);
/// Returns whether the word says that it does not fit: "too small" or "narrow".
bool is_too_small(const FitRow& row);

/// Returns "below 4 cm: tight; below 12 cm: fitted; else loose".
std::string fit_thresholds();

/// Measures a garment that begins at these positions, in m, where the body that is dressed has its girths: at rest;
/// around its trunk, not above the armholes; its neck opening, armholes and, without sleeves, the width between them;
/// its sleeves, its legs and its hem, where the body is as it was stored. Leaves out what the garment does not cover or
/// what does not go all around. Empty if no body is dressed.
std::vector<FitRow> fit_of(const Scene& scene, const sim::Garment& garment, std::span<const sim::Vec3> start_m);

/// Requires that the garment, stretched as far as it may be, goes around the body that is dressed. Throws InputError
/// with the girths for which it does not.
void require_wearable(const Scene& scene, std::span<const FitRow> rows);

/// Returns a line, "stretched most: at the seat behind 4.9 %, at the chest in front 3.1 %", of what is worn at these
/// positions: the places where it is tight in pictures of stretch.
std::string describe_tightness(const Scene& scene, const sim::Garment& garment, std::span<const sim::Vec3> worn_m,
                               std::span<const FitRow> rows);

/// Measures the length of the cloth at the heights of the rows where it is worn at these positions, in m.
void measure_worn(const sim::Garment& garment, std::span<const sim::Vec3> worn_m, std::span<FitRow> rows);

/// Returns a line, "worn, it measures: chest 104.2 cm (+4.1 %)", of the rows that are measured so; nothing if
/// none is.
std::string describe_worn(std::span<const FitRow> rows);

/// Returns "; it does not fit: chest 96.0 cm in a garment of 92.0 cm" of the rows that are too small; nothing
/// if none is.
std::string describe_misfit(std::span<const FitRow> rows);

/// Returns the table for people, a line for each row under one for the columns.
std::string describe(std::span<const FitRow> rows);

}  // namespace taut::app
