#pragma once

#include "app/drawing/drawn_scene.hpp"
#include "app/models/inspecting/inspection.hpp"
#include "app/runs/frame_record.hpp"

namespace taut::app {

/// Description of a run for the head of its statistics.
struct RunDescription {
  const DrawnScene& scene;
  const sim::Garment& garment;
  std::size_t pins = 0;
  std::string gl_renderer;   ///< empty: nothing was drawn
  bool is_verified = false;  ///< frames include the number of crossing pairs
};

/// Format of statistics.
enum class StatisticsFormat { json_lines, csv };

/// Returns the format of the file name: CSV for .csv; JSON lines for .jsonl or no ending. Throws UsageError.
StatisticsFormat statistics_format(const std::filesystem::path& file);

// Return complete lines of statistics. JSON lines: the run, each frame, the summary. CSV: the column names, each frame,
// nothing.
std::string statistics_header(StatisticsFormat format, const RunDescription& run);
std::string statistics_line(StatisticsFormat format, const FrameRecord& record);
std::string statistics_end(StatisticsFormat format, const RunSummary& summary);

/// Returns the beginning of a frame's line. No other line begins like this.
std::string statistics_line_start(StatisticsFormat format, int frame);

/// Returns a help text with the columns of the statistics and their units.
std::string statistics_help();

/// Writes the file of --stats line by line, so that it has every measured frame if a run ends early. All functions
/// throw InputError if the file cannot be written; it then ends with a complete line.
class StatisticsFile {
 public:
  /// Begins a new file, or continues an existing one after the line of frame `last_kept` and removes later lines.
  /// Throws InputError if there is no such line, UsageError for a file name with another ending.
  StatisticsFile(const std::filesystem::path& file, const RunDescription& run, std::optional<int> last_kept);

  void add(const FrameRecord& record) { write(statistics_line(format_, record)); }
  void finish(const RunSummary& summary) { write(statistics_end(format_, summary)); }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void write(const std::string& lines);

  std::filesystem::path path_;
  StatisticsFormat format_;
  bool is_plain_;  ///< neither a pipe nor a device
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace taut::app
