#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/drawing/drawn_scene.hpp"
#include "app/models/inspection.hpp"
#include "app/output/frame_record.hpp"
#include "sim/garment.hpp"

namespace taut::app {

/// What the statistics of a run are made of.
struct RunStatistics {
  const DrawnScene& scene;
  const sim::Garment& garment;
  std::size_t pins = 0;
  std::string gl_renderer;  ///< empty where nothing was drawn
  const std::vector<FrameRecord>& records;
};

/// Makes the folder of the file, where one is named, and tries it. Throws UsageError where its name says
/// neither JSON nor CSV, and InputError.
void prepare_statistics(const std::filesystem::path& file);

/// What --stats writes: CSV where the name ends so, and else JSON. Throws InputError.
void write_statistics(const std::filesystem::path& file, const RunStatistics& run);

/// One object.
std::string statistics_json(const RunStatistics& run);

/// A line of names, then one for every frame.
std::string statistics_csv(const std::vector<FrameRecord>& records);

/// What stands in them, with units, for people.
std::string statistics_help();

/// The same as `describe` (inspection.hpp), for programs.
std::string inspection_json(const Inspection& inspection);

}  // namespace taut::app
