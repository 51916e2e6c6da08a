// Lemma 3 of sim/solvers/bounded/bounded.md: the distance of kinematic vertices from the chord of their path.

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "check.hpp"
#include "numbers.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim {
namespace {

RigidMotion some_motion(Numbers& some) {
  RigidMotion motion;
  if (some.is_so()) {
    motion.shift = {some.vector(2.0), some.between(-0.2, 0.2), some.between(0.0, 0.4)};
  }
  if (some.is_so()) {
    motion.spin = {some.vector(0.5), glm::normalize(some.vector(1.0)), some.between(-3.0, 3.0),
                   some.between(-0.2, 0.2), some.between(0.0, 0.4)};
  }
  double time_s = some.between(-0.1, 0.1);
  for (int k = 0; some.is_so() && k < 5; ++k) {
    motion.path.push_back({time_s, some.vector(0.1)});
    time_s += some.between(0.005, 0.1);
  }
  return motion;
}

TimeSpan some_span(Numbers& some) {
  const double from_s = some.between(0.0, 0.2);
  return {from_s, from_s + some.between(1e-4, 0.1)};
}

class ShakenFrames : public BodyFrames {
 public:
  ShakenFrames(Numbers& some, std::size_t vertices) : rate_hz_(some.between(5.0, 100.0)) {
    for (std::size_t frame = 0; frame < 12; ++frame) {
      for (std::size_t v = 0; v < vertices; ++v) {
        positions_m_.push_back(some.vector(0.2));
      }
    }
    vertices_ = vertices;
  }
  std::size_t count() const override { return positions_m_.size() / vertices_; }
  double rate_hz() const override { return rate_hz_; }
  double first_s() const override { return -0.01; }
  void positions_in(std::size_t frame, std::span<Vec3> positions_m) const override {
    std::copy_n(positions_m_.begin() + static_cast<std::ptrdiff_t>(frame * vertices_), vertices_,
                positions_m.begin());
  }

 private:
  double rate_hz_;
  std::size_t vertices_ = 0;
  std::vector<Vec3> positions_m_;
};

/// Returns the largest distance of points from their chords at 200 times.
template <typename PositionsAt>
double max_deviation_m(const PositionsAt& positions_at, const TimeSpan& time) {
  const std::vector<Vec3> begin_m = positions_at(time.from_s);
  const std::vector<Vec3> end_m = positions_at(time.to_s);
  constexpr int count = 200;
  double off_m = 0.0;
  for (int k = 1; k < count; ++k) {
    const double part = static_cast<double>(k) / count;
    const std::vector<Vec3> at_m = positions_at(time.from_s + part * (time.to_s - time.from_s));
    for (std::size_t v = 0; v < at_m.size(); ++v) {
      off_m = std::max(off_m, glm::distance(at_m[v], glm::mix(begin_m[v], end_m[v], part)));
    }
  }
  return off_m;
}

constexpr double rounding_m = 1e-12;

TEST(Lemma, BodiesAreNoFurtherOffTheirChordsThanIsSaid) {
  std::size_t off = 0;
  ASSERT_TRUE(holds("bodies", [&] {
    Numbers some(*rc::gen::arbitrary<unsigned>());
    Body body;
    auto data = std::make_shared<BodyMeshData>();
    for (int v = 0; v < 4; ++v) {
      data->positions_m.push_back(some.vector(0.3));
    }
    body.shape = BodyMesh{data, some.is_so() ? std::make_shared<const ShakenFrames>(some, 4) : nullptr};
    body.motion = some_motion(some);
    const TimeSpan time = some_span(some);
    const double found_m = max_deviation_m(
        [&](double time_s) {
          std::vector<Vec3> positions_m(4);
          positions_at(body, time_s, positions_m);
          return positions_m;
        },
        time);
    RC_ASSERT(found_m <= off_chord_m(body, time) + rounding_m);
    off += found_m > 1e-5 ? 1 : 0;
  }));
  EXPECT_GT(off, 50U);
}

TEST(Lemma, LimbsAreNoFurtherOffTheirChordsThanIsSaid) {
  ASSERT_TRUE(holds("limbs", [] {
    Numbers some(*rc::gen::arbitrary<unsigned>());
    const Capsule limb{some.vector(0.3), some.vector(0.3), 0.1, 0.05};
    const Body body = {.shape = limb, .motion = some_motion(some)};
    const Body ball = {.shape = Sphere{limb.start_m, 0.1}, .motion = body.motion};
    const TimeSpan time = some_span(some);
    const auto ends_at = [&](double time_s) {
      const auto moved = std::get<Capsule>(shape_at(body, time_s));
      return std::vector<Vec3>{moved.start_m, moved.end_m};
    };
    const auto centre_at = [&](double time_s) {
      return std::vector<Vec3>{std::get<Sphere>(shape_at(ball, time_s)).centre_m};
    };
    RC_ASSERT(max_deviation_m(ends_at, time) <= off_chord_m(body, time) + rounding_m);
    RC_ASSERT(max_deviation_m(centre_at, time) <= off_chord_m(ball, time) + rounding_m);
  }));
}

TEST(Lemma, PinsAreNoFurtherOffTheirChordsThanIsSaid) {
  ASSERT_TRUE(holds("pins", [] {
    Numbers some(*rc::gen::arbitrary<unsigned>());
    const std::vector<Index> pins = {0, 1, 2, 3, 4};
    std::vector<Vec3> at_m;
    for (std::size_t k = 0; k < pins.size(); ++k) {
      at_m.push_back(some.vector(0.5));
    }
    Surroundings surroundings;
    if (some.is_so()) {
      surroundings.pin_motion = {some.vector(0.1), some.between(0.0, 60.0)};
    }
    if (some.is_so()) {
      surroundings.moving_pins = {{{1, 2}, some_motion(some)}};
    }
    if (some.is_so()) {
      const double from_s = some.between(0.0, 0.2);
      surroundings.prescribed_pins = {{3}, {some.vector(0.1)}, from_s, from_s + some.between(0.01, 0.1)};
    }
    const TimeSpan time = some_span(some);
    const double at_s = some.between(0.0, time.from_s);
    const auto positions_at = [&](double time_s) {
      std::vector<Vec3> moved_m = pin_displacements(surroundings, pins, at_m, {at_s, time_s});
      for (std::size_t k = 0; k < moved_m.size(); ++k) {
        moved_m[k] += at_m[k];
      }
      return moved_m;
    };
    RC_ASSERT(max_deviation_m(positions_at, time) <=
              pins_off_chord_m(surroundings, pins, at_m, at_s, time) + rounding_m);
  }));
}

// A span of whole periods has its middle at the same place as its ends, so that the middle alone proves nothing.
TEST(Chords, ABodyThatGoesThereAndBackIsNotStraight) {
  const Body body = {.shape = Sphere{{1.0, 0.0, 0.0}, 0.1}, .motion = {.spin = {{}, {0, 1, 0}, 20.0}}};
  EXPECT_GE(off_chord_m(body, {0.0, 0.1}), 2.0);
  Surroundings swinging;
  swinging.pin_motion = {{0.1, 0.0, 0.0}, 20.0};
  EXPECT_GE(pins_off_chord_m(swinging, std::vector<Index>{0}, std::vector<Vec3>(1), 0.0, {0.0, 0.1}), 0.1);
}

// Too wide a bound would end regions after a single time step.
TEST(Chords, ABodyThatTurnsSlowlyIsNearlyAsFarOffAsIsSaid) {
  const Body body = {.shape = Sphere{{1.0, 0.0, 0.0}, 0.1}, .motion = {.spin = {{}, {0, 1, 0}, 0.1}}};
  const double angle = 6.283185307179586 * 0.1 * 0.05;
  EXPECT_NEAR(off_chord_m(body, {1.0, 1.05}), 1.0 - std::cos(0.5 * angle), 1e-7);
  const Body still = {.shape = Sphere{}, .motion = {.spin = {{}, {0, 1, 0}, 1.0}}};
  EXPECT_EQ(off_chord_m(still, {0.0, 1.0}), 0.0) << "about its own centre";
  const Body pushed = {.shape = Plane{}, .motion = {.shift = {{1, 0, 0}, 0.5, 1.0}}};
  EXPECT_EQ(off_chord_m(pushed, {0.5, 1.0}), 0.0) << "it begins and ends as the span does";
  const Body tilting = {.shape = Plane{}, .motion = {.spin = {{}, {1, 0, 0}, 0.1}}};
  EXPECT_GT(off_chord_m(tilting, {0.0, 0.1}), 1.0);
}

}  // namespace
}  // namespace taut::sim
