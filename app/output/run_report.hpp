#pragma once

#include "app/drawing/drawn_scene.hpp"
#include "app/models/inspection.hpp"
#include "app/output/frame_record.hpp"

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

/// Writes the file of --stats line by line. If a run ends early, the file holds every frame that was
/// measured. All functions throw InputError if the file cannot be written; it then ends with a complete line.
class StatisticsFile {
 public:
  /// Begins a new file, or continues an existing one after the line of frame `last_kept`; later lines are
  /// removed. Throws InputError if there is no such line, UsageError if the file name has another ending.
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
  bool is_plain_;  ///< no pipe and no device
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace taut::app
