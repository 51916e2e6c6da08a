#pragma once

#include "prelude.hpp"

namespace taut::app {

/// Returns a cell with as many digits as the number needs to be read back exactly.
std::string cell(double value);
template <std::integral Number> std::string cell(Number value) { return std::to_string(value); }
/// Returns a cell with the text, in quotes if necessary.
std::string cell(const std::string& text);

/// A table of comma-separated values (RFC 4180): a line with the column names, then one line per row. Numbers read back
/// exactly.
class CsvTable {
 public:
  /// Takes the names of the columns, separated by commas.
  explicit CsvTable(const std::string& columns);

  /// Adds a row of numbers and texts. Throws std::invalid_argument unless there is one for each column.
  template <class... Values> void add(const Values&... values) { add_cells({cell(values)...}); }

  /// Returns the table as text.
  std::string text() const { return text_; }

 private:
  void add_cells(const std::vector<std::string>& cells);

  std::ptrdiff_t width_;
  std::string text_;
};

}  // namespace taut::app
