#pragma once

#include <cstdint>

namespace taut::tailor {

/// SplitMix64 (Steele, Lea and Flood 2014). Our own, because the distributions of <random> differ from one
/// standard library to the next and the garments are reproduced byte for byte.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// In [0, 1), with 53 random bits: exact in a double.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

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
