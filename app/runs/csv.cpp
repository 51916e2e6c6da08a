#include "app/runs/csv.hpp"

#include "app/base/words.hpp"

namespace taut::app {

CsvTable::CsvTable(const std::string& columns) : width_(std::ranges::count(columns, ',') + 1), text_(columns + '\n') {}

void CsvTable::add_cells(const std::vector<std::string>& cells) {
  if (std::ssize(cells) != width_) {
    throw std::invalid_argument(fmt::format("a row of {} cells in a table of {} columns", cells.size(), width_));
  }
  text_ += join(cells, ",") + '\n';
}

std::string cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) {
    quoted += letter;
    if (letter == '"') quoted += '"';
  }
  return quoted + '"';
}

}  // namespace taut::app
