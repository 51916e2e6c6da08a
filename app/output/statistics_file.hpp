#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/output/run_report.hpp"

namespace taut::app {

/// Writes the file of --stats line by line. If a run ends early, the file holds every frame that was
/// measured. All functions throw InputError if the file cannot be written; it then ends with a complete line.
class StatisticsFile {
 public:
  /// Begins a new file, or continues an existing one after the line of frame `last_kept`; later lines are
  /// removed. Throws InputError if there is no such line, UsageError if the file name has another ending.
  StatisticsFile(const std::filesystem::path& file, const RunDescription& run, std::optional<int> last_kept);

  void add(const FrameRecord& record);
  void finish(const RunSummary& summary);

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
