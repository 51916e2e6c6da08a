#include "app/base/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include "app/base/words.hpp"

namespace taut::app {
namespace {

// Columns that lines of text keep beside their indentation. Narrower columns are not readable.
constexpr std::size_t min_text_columns = 20;

/// Returns the column of the line's second column, or of its first word if there is none or it leaves too little room.
std::size_t hanging_indent(std::string_view line, std::size_t columns) {
  const std::size_t word = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t gap = line.find("  ", word);
  const std::size_t second = gap == std::string_view::npos ? word : line.find_first_not_of(' ', gap);
  return second < line.size() && second + min_text_columns <= columns ? second : word;
}

std::string wrap_line(std::string_view line, std::size_t columns) {
  const std::string indent(hanging_indent(line, columns), ' ');
  columns = std::max(columns, indent.size() + min_text_columns);
  std::string wrapped;
  std::string rest(line);
  while (rest.size() > columns) {
    std::size_t end = rest.rfind(' ', columns);
    if (end == std::string::npos || end <= indent.size()) end = rest.find(' ', columns);
    const std::size_t next = rest.find_first_not_of(' ', end);
    if (next == std::string::npos) break;
    wrapped += rest.substr(0, rest.find_last_not_of(' ', end) + 1) + '\n';
    rest = indent + rest.substr(next);
  }
  return wrapped + rest;
}

}  // namespace

std::size_t terminal_columns(int file_descriptor, std::size_t otherwise) {
  const char* const wanted = std::getenv("COLUMNS");
  const auto columns = number_in<std::size_t>(wanted != nullptr ? wanted : "");
  if (columns && *columns > 0) return *columns;
  winsize size{};
  const bool is_known = ::isatty(file_descriptor) != 0 && ::ioctl(file_descriptor, TIOCGWINSZ, &size) == 0;
  return is_known && size.ws_col > 0 ? size.ws_col : otherwise;
}

std::string_view cut_line(std::string_view line, std::size_t bytes) {
  if (line.size() <= bytes) return line;
  // Bytes of this form continue a letter.
  while (bytes > 0 && (line[bytes] & 0xC0) == 0x80) --bytes;
  return line.substr(0, bytes);
}

std::string wrap_lines(std::string_view text, std::size_t columns) {
  std::string wrapped;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    wrapped += wrap_line(text.substr(0, end), columns);
    if (end == text.size()) break;
    wrapped += '\n';
    text.remove_prefix(end + 1);
  }
  return wrapped;
}

}  // namespace taut::app
