#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace taut::app {

/// File names with the number of the frame in them: "frames/frame_{frame:04}.png".
class OutputPattern {
 public:
  /// Throws UsageError unless the text holds at most one field, {frame} or {frame:0N}, and ends in
  /// `extension` (".png").
  OutputPattern(const std::string& text, const std::string& extension);

  /// Throws UsageError where several frames would all get the same name.
  void require_distinct_names(std::size_t frame_count) const;

  /// Whether frames have names of their own.
  bool has_field() const { return has_field_; }

  std::filesystem::path path_of(int frame) const;

 private:
  std::string before_;
  std::string after_;
  bool has_field_ = false;
  int width_ = 0;
  std::string text_;
};

/// "wrote a.png", or for several the first and the last.
std::string describe_written(const OutputPattern& pattern, std::span<const int> frames);

}  // namespace taut::app
