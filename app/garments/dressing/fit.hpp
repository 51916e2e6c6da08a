#pragma once

#include "app/garments/dressing/dressing.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {

/// Widths of a garment and of a body at one girth.
struct FitRow {
  std::string name;                     ///< name of the girth (body_girths.hpp), "waistband", "hem" or "leg hem"
  double body_m = 0.0;                  ///< tight tape around the body
  double garment_m = 0.0;               ///< length of the cloth at rest
  std::optional<double> height_m = {};  ///< height of a girth of the trunk; empty for others
  std::optional<double> worn_m = {};    ///< length of the cloth at that height once it is worn
  double body_at_height_m = 0.0;        ///< tight tape around the body at that height; 0 if unknown

  double ease_m() const { return garment_m - body_m; }
};

/// Returns "too small", "tight", "fitted" or "loose"; for the shoulder width "narrow", "fitted" or "wide".
const char* fit_word(const FitRow& row);
/// Returns whether the word is "too small" or "narrow".
bool is_too_small(const FitRow& row);

/// Returns "below 4 cm: tight; below 12 cm: fitted; else loose".
std::string fit_thresholds();

/// Measures a garment at rest where the dressed body has its girths: around the trunk, not above the armholes; the neck
/// opening, the armholes and, without sleeves, the width between them; the sleeves, the legs and the hem. Heights
/// belong to the body's stored pose. The garment begins at these positions, in m. Girths that the garment does not
/// cover, or that it does not go all around, are left out. Returns nothing if no body is dressed.
std::vector<FitRow> compute_fit(const LoadedBodies& bodies, const sim::Garment& garment,
                                std::span<const sim::Vec3> start_m);

/// Requires that the garment at its largest stretch goes around the dressed body. Throws InputError with the girths
/// where it does not.
void require_wearable(const Scene& scene, std::span<const FitRow> rows);

/// Returns the line "stretched most: at the seat behind 4.9 %, at the chest in front 3.1 %" for a garment worn at these
/// positions. It names the places that are tight in pictures of stretch.
std::string describe_tightness(const LoadedBodies& bodies, const sim::Garment& garment,
                               std::span<const sim::Vec3> worn_m, std::span<const FitRow> rows);

/// Measures the length of worn cloth at the heights of the rows. Positions are in m.
void measure_worn(const sim::Garment& garment, std::span<const sim::Vec3> worn_m, std::span<FitRow> rows);

/// Returns the line "worn, it measures: chest 104.2 cm (+4.1 %)" for the rows that were measured when worn, or an empty
/// text if there are none.
std::string describe_worn(std::span<const FitRow> rows);

/// Returns "; it does not fit: chest 96.0 cm in a garment of 92.0 cm" for the rows that are too small, or an empty text
/// if there are none.
std::string describe_misfit(std::span<const FitRow> rows);

/// Returns a table for people: a line of column titles, then a line for each row.
std::string describe(std::span<const FitRow> rows);

}  // namespace taut::app
