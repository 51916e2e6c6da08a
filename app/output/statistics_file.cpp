#include "app/output/statistics_file.hpp"

#include <cerrno>
#include <system_error>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_to_write(const fs::path& path, int error_number) {
  throw InputError("cannot write '" + path.string() + "': " + std::generic_category().message(error_number));
}

// How many bytes there are up to the end of that frame's line.
std::uintmax_t end_of_frame(const fs::path& path, StatisticsFormat format, const RunDescription& run,
                            int frame) {
  if (!fs::exists(path)) {
    throw InputError("cannot go on with '" + path.string() +
                     "': there is no such file; the run goes on in the statistics of its first part, so name "
                     "that file, or none");
  }
  const std::string text = read_text_file(path);
  const std::string names = statistics_header(StatisticsFormat::csv, run);
  if (format == StatisticsFormat::csv && !text.starts_with(names)) {
    throw InputError("cannot go on with '" + path.string() + "': found the columns " +
                     text.substr(0, text.find('\n')) + ", expected " + names.substr(0, names.size() - 1));
  }
  const std::string start = '\n' + statistics_line_start(format, frame);
  const std::size_t line = text.find(start);
  const std::size_t end = line == std::string::npos ? line : text.find('\n', line + start.size());
  if (end == std::string::npos) {
    throw InputError("cannot go on with '" + path.string() + "': it has no line of frame " +
                     std::to_string(frame) + ", after which the run goes on");
  }
  return end + 1;
}

}  // namespace

StatisticsFile::StatisticsFile(const fs::path& file, const RunDescription& run, std::optional<int> last_kept)
    : path_(file), format_(statistics_format(file)) {
  if (last_kept) {
    fs::resize_file(file, end_of_frame(file, format_, run, *last_kept));
  }
  is_plain_ = !fs::exists(file) || fs::is_regular_file(file);
  file_.reset(std::fopen(file.c_str(), last_kept || !is_plain_ ? "ab" : "wb"));
  if (!file_) {
    fail_to_write(path_, errno);
  }
  if (!last_kept) {
    write(statistics_header(format_, run));
  }
}

void StatisticsFile::add(const FrameRecord& record) {
  write(statistics_line(format_, record));
}

void StatisticsFile::finish(const RunSummary& summary) {
  write(statistics_end(format_, summary));
}

void StatisticsFile::write(const std::string& lines) {
  std::error_code ignored;
  const std::uintmax_t whole = is_plain_ ? fs::file_size(path_, ignored) : 0;
  if (std::fwrite(lines.data(), 1, lines.size(), file_.get()) == lines.size() &&
      std::fflush(file_.get()) == 0) {
    return;
  }
  const int reason = errno;
  if (is_plain_ && whole > 0) {
    fs::resize_file(path_, whole, ignored);
  } else if (is_plain_) {
    fs::remove(path_, ignored);
  }
  fail_to_write(path_, reason);
}

}  // namespace taut::app
