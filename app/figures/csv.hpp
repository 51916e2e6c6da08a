#pragma once

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

}  // namespace taut::app
