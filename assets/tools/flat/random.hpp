#pragma once

#include <cstdint>

namespace taut::tailor {

/// The random number generator SplitMix64 (Steele, Lea and Flood 2014). It is not from <random>, because the
/// distributions there differ between standard libraries, and the garments have to be the same byte for byte.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// In [0, 1), with 53 random bits.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

  /// In [low, high).
  double between(double low, double high) { return low + (high - low) * uniform(); }

 private:
  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace taut::tailor
