#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "app/figures/experiments/recording.hpp"

namespace taut::app {

/// One row for every moment of the recordings, lettered from a: the scene and what was measured.
std::string moments_csv(std::span<const Recording* const> recordings);

/// One row for every vertex of every moment: where it was, in metres.
std::string shapes_csv(std::span<const Recording* const> recordings);

/// The moments of one scene from FIGURE.csv and FIGURE_shapes.csv in a folder. DrawnScene and garment are as
/// they are now, and what is measured is measured again on the shapes; `largest_stretch` is of these moments
/// alone. Throws InputError naming the file and the line: broken, without a moment of that scene, or with
/// shapes that have not as many vertices as the garment.
Recording read_recording(const std::filesystem::path& folder, const std::string& figure,
                         const std::string& scene_name);

}  // namespace taut::app
