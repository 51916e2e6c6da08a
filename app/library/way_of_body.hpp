#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "sim/contact/bodies.hpp"

namespace taut::library {

/// A body that goes from one shape to another within one frame, each vertex in a straight line.
class WayOfBody final : public sim::BodyFrames {
 public:
  WayOfBody(std::vector<sim::Vec3> from_m, std::vector<sim::Vec3> to_m, double from_s, double rate_hz)
      : shapes_m_{std::move(from_m), std::move(to_m)}, from_s_(from_s), rate_hz_(rate_hz) {}

  std::size_t count() const override { return 2; }
  double rate_hz() const override { return rate_hz_; }
  double first_s() const override { return from_s_; }
  void positions_in(std::size_t frame, std::span<sim::Vec3> positions_m) const override {
    std::copy(shapes_m_[frame].begin(), shapes_m_[frame].end(), positions_m.begin());
  }

 private:
  std::vector<sim::Vec3> shapes_m_[2];
  double from_s_;
  double rate_hz_;
};

}  // namespace taut::library
