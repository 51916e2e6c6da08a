#pragma once

#include <filesystem>

#include "app/runs/csv.hpp"

namespace taut::app {

/// A table read from a file (RFC 4180, without line breaks in cells). Rows and columns count from 0, without the line
/// of names.
class CsvFile {
 public:
  /// Throws InputError that names the file and the line if the columns differ from `columns`, which commas separate, or
  /// if a row has another number of cells.
  CsvFile(const std::filesystem::path& path, const std::string& columns);

  std::size_t rows() const { return rows_.size(); }
  const std::string& text(std::size_t row, std::size_t column) const { return rows_[row][column]; }
  /// Returns the number in a cell. Throws InputError that names file, line and column if the cell is not a finite
  /// number.
  double number(std::size_t row, std::size_t column) const;
  /// Returns the whole number in a cell. Throws as `number` does.
  int whole_number(std::size_t row, std::size_t column) const;
  /// Throws InputError with `what`, the file and the line of the row.
  [[noreturn]] void fail(std::size_t row, const std::string& what) const;
  /// Throws InputError that says what was found in a cell, and what was expected.
  [[noreturn]] void fail_cell(std::size_t row, std::size_t column, const std::string& expected) const;

 private:
  std::string name_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace taut::app
