#pragma once

#include "prelude.hpp"

namespace taut::app {

/// A table of comma-separated values (RFC 4180): a line with the column names, then one line per row. Numbers read back
/// exactly.
class CsvTable {
 public:
  explicit CsvTable(std::vector<std::string> columns);

  /// Adds a row. Throws std::invalid_argument unless there is one cell for each column.
  void add(std::vector<std::string> cells);

  /// Returns the table as text.
  std::string text() const { return text_; }

 private:
  std::size_t width_;
  std::string text_;
};

/// Returns a cell with as many digits as the number needs to be read back exactly.
std::string cell(double value);
/// Returns a cell with the text, in quotes if necessary.
std::string cell(const std::string& text);

}  // namespace taut::app
