#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace taut::app {

/// A table as comma-separated values (RFC 4180): a line of names, then one for every row. Numbers are written
/// so that reading them gives the same number again.
class CsvTable {
 public:
  explicit CsvTable(std::vector<std::string> columns);

  /// Throws std::invalid_argument unless there is one cell for each column.
  void add(std::vector<std::string> cells);

  std::string text() const { return text_; }

 private:
  std::size_t width_;
  std::string text_;
};

std::string cell(double value);
std::string cell(const std::string& text);

/// A table read from a file (RFC 4180; no line breaks within cells).
class CsvFile {
 public:
  /// Throws InputError naming the file, and the line where it does not begin with these columns or a row has
  /// not one cell for each.
  CsvFile(const std::filesystem::path& path, const std::vector<std::string>& columns);

  std::size_t rows() const { return rows_.size(); }
  const std::string& text(std::size_t row, std::size_t column) const { return rows_[row][column]; }
  /// Throw InputError naming the file, the line and the column where there is no such number.
  double number(std::size_t row, std::size_t column) const;
  int whole_number(std::size_t row, std::size_t column) const;
  /// Throws InputError naming the file and the row's line.
  [[noreturn]] void fail(std::size_t row, const std::string& what) const;

 private:
  std::string name_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace taut::app
