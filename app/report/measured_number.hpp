#pragma once

#include <string>

namespace taut::app {

struct MeasuredNumber {
  std::string name;
  double value = 0.0;  ///< not finite: lost in a run that diverged
  std::string unit;
  int digits = 3;  ///< significant ones, for people
};

/// "3.84 %", "6.08 × 10⁻⁷ m", "diverged".
std::string number_text(const MeasuredNumber& number);

// In a sentence, with two digits.
std::string text_of(double value, const std::string& unit);
std::string percent_text(double fraction);

MeasuredNumber percent_number(std::string name, double fraction);
MeasuredNumber count_number(std::string name, std::size_t count);

}  // namespace taut::app
