#include "app/output/output_pattern.hpp"

#include <regex>

#include "app/base/errors.hpp"
#include "app/base/words.hpp"

namespace taut::app {
namespace {

constexpr const char* one_field = "expected one field {frame} or {frame:04}, as in frames/frame_{frame:04}.png";

int parse_frame(const std::string& word, int last_frame, const std::string& text) {
  if (word == "last") return last_frame;
  const std::optional<int> frame = number_in<int>(word);
  if (!frame || *frame < 0 || *frame > max_frame) {
    throw UsageError("--frames {}: found '{}', expected a frame from 0 to {} or last, as in 0:120, 30:, :30 or last",
                     text, word, max_frame);
  }
  return *frame;
}

}  // namespace

OutputPattern::OutputPattern(const std::string& text, const std::string& extension) : text_(text) {
  const std::filesystem::path name = text;
  if (name.extension() != extension || name.stem().empty()) {
    throw UsageError("output '" + text + "': expected a file name that ends in " + extension);
  }
  // The width of a number may be 1 to 20 digits.
  static const std::regex form(R"(([^{}]*)(\{frame(?::0([1-9]|1\d|20)d?)?\}([^{}]*))?)");
  std::smatch parts;
  if (!std::regex_match(text, parts, form)) {
    throw UsageError("output '" + text + "': found braces that are no field, " + one_field);
  }
  before_ = parts[1];
  has_field_ = parts[2].matched;
  width_ = parts[3].matched ? std::stoi(parts[3]) : 0;
  after_ = parts[4];
}

void OutputPattern::require_distinct_names(std::size_t frame_count) const {
  if (!has_field_ && frame_count > 1) {
    throw UsageError("output '{}': {} frames need different names; {}", text_, frame_count, one_field);
  }
}

std::filesystem::path OutputPattern::path_of(int frame) const {
  return has_field_ ? fmt::format("{}{:0{}}{}", before_, frame, width_, after_) : before_;
}

std::string describe_written(const OutputPattern& pattern, std::span<const int> frames) {
  if (frames.empty()) return "wrote nothing";
  const std::string first = pattern.path_of(frames.front()).string();
  return frames.size() == 1
             ? "wrote " + first
             : fmt::format("wrote {} files, {} to {}", frames.size(), first, pattern.path_of(frames.back()).string());
}

FrameRange frame_range(const std::string& text, int last_frame, NumberMeans number) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) {
    const int frame = parse_frame(text, last_frame, text);
    if (number == NumberMeans::frame || text == "last") return {frame, frame};
    if (frame == 0) throw UsageError("--frames 0: expected at least one frame of a video or a clip");
    return {0, frame - 1};
  }
  const std::string first_word = text.substr(0, colon);
  const std::string last_word = text.substr(colon + 1);
  const FrameRange range = {first_word.empty() ? 0 : parse_frame(first_word, last_frame, text),
                            last_word.empty() ? last_frame : parse_frame(last_word, last_frame, text)};
  if (range.last < range.first) {
    throw UsageError("--frames {}: the last frame, {}, comes before the first, {}", text, range.last, range.first);
  }
  return range;
}

void require_not_before_start(int start_frame, int frame) {
  if (frame < start_frame) {
    throw UsageError("--frames: found frame {}, expected none before {}, which the run begins with", frame,
                     start_frame);
  }
}

}  // namespace taut::app
