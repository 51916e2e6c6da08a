#pragma once

#include <filesystem>
#include <string>

#include "app/drawing/drawn_scene.hpp"
#include "app/models/inspection.hpp"
#include "app/output/frame_record.hpp"
#include "sim/garment.hpp"

namespace taut::app {

/// What the statistics of a run begin with.
struct RunDescription {
  const DrawnScene& scene;
  const sim::Garment& garment;
  std::size_t pins = 0;
  std::string gl_renderer;  ///< empty where nothing was drawn
};

enum class StatisticsFormat { json_lines, csv };

/// CSV where the name ends in .csv, JSON lines where it ends in .jsonl or has no ending. Throws UsageError.
StatisticsFormat statistics_format(const std::filesystem::path& file);

// What statistics are made of, whole lines. JSON lines: the run; every frame; the summary. CSV: the names of
// the columns; every frame; nothing.
std::string statistics_header(StatisticsFormat format, const RunDescription& run);
std::string statistics_line(StatisticsFormat format, const FrameRecord& record);
std::string statistics_end(StatisticsFormat format, const RunSummary& summary);

/// How the line of a frame begins, and no other line.
std::string statistics_line_start(StatisticsFormat format, int frame);

/// What stands in them, with units, for people.
std::string statistics_help();

/// The same as `describe` (inspection.hpp), for programs.
std::string inspection_json(const Inspection& inspection);

}  // namespace taut::app
