#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/output/run_report.hpp"

namespace taut::app {

/// What --stats writes, line by line as it comes: of a run that ends before its time every frame is there
/// that was measured. Everything throws InputError where the file cannot be written; it ends with a whole
/// line then.
class StatisticsFile {
 public:
  /// Begins a new file, or goes on behind the line of frame `last_kept`: what came after it is cut off.
  /// Throws InputError where it has no such line, UsageError where the name has another ending.
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
