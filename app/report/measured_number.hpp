#pragma once

#include <string>

namespace taut::app {

/// A measured value with its name and unit.
struct MeasuredNumber {
  std::string name;
  double value = 0.0;  ///< not finite if the run diverged
  std::string unit;
  int digits = 3;  ///< significant digits in texts
};

/// The number for people: "3.84 %", "6.08 × 10⁻⁷ m", "diverged".
std::string number_text(const MeasuredNumber& number);

// In a sentence, with two digits.
/// A value within a sentence, with two digits.
std::string text_of(double value, const std::string& unit);
/// A fraction as percent, with two digits.
std::string percent_text(double fraction);

/// A fraction as a number in percent.
MeasuredNumber percent_number(std::string name, double fraction);
/// A number without a unit.
MeasuredNumber count_number(std::string name, std::size_t count);

}  // namespace taut::app
