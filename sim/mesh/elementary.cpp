#include "sim/mesh/elementary.hpp"

namespace taut::sim {
namespace {

constexpr double two_pi = 6.283185307179586;
/// ln 2 as the sum of two numbers. The first has so few digits that its products with small integers are exact (Cody
/// and Waite 1980).
constexpr double ln2_high = 0x1.62e42fee00000p-1;
constexpr double ln2_low = 0x1.a39ef35793c76p-33;
constexpr double per_ln2 = 1.4426950408889634;

}  // namespace

// Taylor's series, evaluated from its last term. On a quarter of a turn the terms after x^21 / 21! are below
// 1e-17.
double sine_of_turns(double turns) {
  assert(!std::isnan(turns));
  double part = turns - std::floor(turns + 0.5);
  if (std::abs(part) > 0.25) part = std::copysign(0.5, part) - part;
  const double x = two_pi * part;
  double sum = 1.0;
  for (int n = 21; n > 1; n -= 2) sum = 1.0 - sum * (x * x) / (n * (n - 1));
  return x * sum;
}

// The whole turns are dropped first: added to many turns, the quarter would be rounded off.
double cosine_of_turns(double turns) { return sine_of_turns(0.25 - std::abs(turns - std::floor(turns + 0.5))); }

// A guess within the first quarter has an error of up to 0.005 radians; the series of the arc sine corrects it.
double atan2_turns(double y, double x) {
  const double length = std::sqrt(x * x + y * y);
  if (!(length > 0.0)) return 0.0;
  const double cosine = std::abs(x) / length;
  const double sine = std::abs(y) / length;
  const double slope = std::min(cosine, sine) / std::max(cosine, sine);
  const double guess = slope * (0.125 + 0.0434 * (1.0 - slope));
  double turns = sine > cosine ? 0.25 - guess : guess;
  const double left = sine * cosine_of_turns(turns) - cosine * sine_of_turns(turns);
  const double squared = left * left;
  turns += left * (1.0 + squared * (1.0 / 6.0 + squared * (3.0 / 40.0))) / two_pi;
  return std::copysign(x < 0.0 ? 0.5 - turns : turns, y);
}

double exponential(double x) {
  assert(!std::isnan(x));
  const double doublings = std::floor(x * per_ln2 + 0.5);
  const double part = (x - doublings * ln2_high) - doublings * ln2_low;
  double sum = 1.0;
  for (int n = 14; n > 0; --n) sum = 1.0 + sum * part / n;
  return std::ldexp(sum, static_cast<int>(doublings));
}

}  // namespace taut::sim
