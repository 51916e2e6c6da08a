#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "app/figures/experiments/recording.hpp"

namespace taut::app {

/// A table with one row per moment: its letter (from a), the scene and what was measured.
std::string moments_csv(std::span<const Recording* const> recordings);

/// A table with one row per vertex of each moment: its position in metres.
std::string shapes_csv(std::span<const Recording* const> recordings);

/// Reads the moments of one scene from FIGURE.csv and FIGURE_shapes.csv in the folder. Scene and garment are
/// taken from their files as they are now. What the tables hold of stretch is measured again from the shapes,
/// and the largest numbers cover only these moments. Throws InputError that names the file and the line.
/// Reasons are a broken table, no moment of this scene, or another number of vertices than the garment has.
Recording read_recording(const std::filesystem::path& folder, const std::string& figure,
                         const std::string& scene_name);

}  // namespace taut::app
