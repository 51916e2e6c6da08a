#include "tests/study/claims/csv_file.hpp"

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/words.hpp"

namespace taut::app {
namespace {

std::vector<std::string> split_cells(const std::string& line) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool is_doubled = is_quoted && line[i] == '"' && i + 1 < line.size() && line[i + 1] == '"';
    if (is_doubled) {
      cells.back() += line[++i];
    } else if (line[i] == '"') {
      is_quoted = !is_quoted;
    } else if (line[i] == ',' && !is_quoted) {
      cells.emplace_back();
    } else if (line[i] != '\r') {
      cells.back() += line[i];
    }
  }
  return cells;
}

}  // namespace

CsvFile::CsvFile(const std::filesystem::path& path, const std::string& columns)
    : name_(path.string()), columns_(split_cells(columns)) {
  std::istringstream lines(read_text_file(path));
  std::string line;
  std::getline(lines, line);
  if (split_cells(line) != columns_) throw InputError("{}:1: found the columns {}, expected {}", name_, line, columns);
  while (std::getline(lines, line)) {
    rows_.push_back(split_cells(line));
    if (rows_.back().size() != columns_.size()) {
      fail(rows_.size() - 1, fmt::format("found {} cells, expected {}", rows_.back().size(), columns_.size()));
    }
  }
  if (rows_.empty()) throw InputError(name_ + ": found no rows, expected at least one");
}

double CsvFile::number(std::size_t row, std::size_t column) const {
  const std::optional<double> number = number_in<double>(text(row, column));
  if (!number || !std::isfinite(*number)) fail_cell(row, column, "a number");
  return *number;
}

int CsvFile::whole_number(std::size_t row, std::size_t column) const {
  const std::optional<int> number = number_in<int>(text(row, column));
  if (!number) fail_cell(row, column, "a whole number");
  return *number;
}

void CsvFile::fail(std::size_t row, const std::string& what) const {
  throw InputError("{}:{}: {}", name_, row + 2, what);
}

void CsvFile::fail_cell(std::size_t row, std::size_t column, const std::string& expected) const {
  fail(row, fmt::format("{}: found '{}', expected {}", columns_[column], text(row, column), expected));
}

}  // namespace taut::app
