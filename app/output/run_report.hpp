#pragma once

#include <filesystem>
#include <string>

#include "app/drawing/drawn_scene.hpp"
#include "app/models/inspection.hpp"
#include "app/output/frame_record.hpp"
#include "sim/garment.hpp"

namespace taut::app {

/// Statistics of a run as a whole.
struct RunDescription {
  const DrawnScene& scene;
  const sim::Garment& garment;
  std::size_t pins = 0;
  std::string gl_renderer;   ///< empty if nothing was drawn
  bool is_verified = false;  ///< frames say how many pairs of triangles cross
};

/// How statistics are written.
enum class StatisticsFormat { json_lines, csv };

/// The format by the file name: CSV for .csv; JSON lines for .jsonl or no ending. Throws UsageError.
StatisticsFormat statistics_format(const std::filesystem::path& file);

// Whole lines of statistics. JSON lines: the run; every frame; the summary. CSV: the names of
// the columns; every frame; nothing.
std::string statistics_header(StatisticsFormat format, const RunDescription& run);
std::string statistics_line(StatisticsFormat format, const FrameRecord& record);
std::string statistics_end(StatisticsFormat format, const RunSummary& summary);

/// The beginning of a frame's line. No other line begins like this.
std::string statistics_line_start(StatisticsFormat format, int frame);

/// The columns of the statistics with their units, as text for people.
std::string statistics_help();

/// The text of `describe` (inspection.hpp), as JSON.
std::string inspection_json(const Inspection& inspection);

}  // namespace taut::app
