#pragma once

#include <random>

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Random numbers of one case.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool is_so() { return between(0.0, 1.0) < 0.5; }
  Vec3 vector(double size) {
    const double x = between(-size, size);
    const double y = between(-size, size);
    return {x, y, between(-size, size)};
  }

 private:
  std::mt19937 random_;
};

}  // namespace taut::sim
