#pragma once

#include "prelude.hpp"

namespace taut::app {

/// Writes a table as comma-separated values (RFC 4180): a line with the column names, then one line per row.
/// Reading the numbers gives exactly the same numbers.
class CsvTable {
 public:
  explicit CsvTable(std::vector<std::string> columns);

  /// Adds a row. Throws std::invalid_argument unless there is one cell for each column.
  void add(std::vector<std::string> cells);

  /// The table as text.
  std::string text() const { return text_; }

 private:
  std::size_t width_;
  std::string text_;
};

/// A number as cell, with as many digits as reading it back exactly needs.
std::string cell(double value);
/// A text as cell, in quotes if it needs them.
std::string cell(const std::string& text);

}  // namespace taut::app
