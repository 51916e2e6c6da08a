#include "app/bodies/looping.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "app/base/errors.hpp"
#include "app/base/interruption.hpp"
#include "app/bodies/placed_frames.hpp"

namespace taut::app {
namespace {

constexpr double meets_within_m = 1e-3;
constexpr double longest_lead_in_s = 2.0;

/// More frames than any run shows, and few enough to be told apart in double precision.
constexpr std::size_t endless = std::size_t{1} << 40U;

double furthest_m(const std::vector<sim::Vec3>& from_m, const std::vector<sim::Vec3>& to_m) {
  double furthest = 0.0;
  for (std::size_t v = 0; v < from_m.size(); ++v) {
    furthest = std::max(furthest, glm::distance(from_m[v], to_m[v]));
  }
  return furthest;
}

class LoopedFrames final : public sim::BodyFrames {
 public:
  LoopedFrames(std::shared_ptr<const sim::BodyFrames> motion, const LoopBegin& begin, std::size_t first)
      : motion_(std::move(motion)),
        begin_(begin.frame),
        period_(motion_->count() - (begin.meets ? begin.frame + 1 : 0)),
        first_(first) {}

  std::size_t count() const override { return endless; }
  double rate_hz() const override { return motion_->rate_hz(); }
  void positions_in(std::size_t frame, std::span<sim::Vec3> positions_m) const override {
    const std::size_t at = first_ + frame;
    motion_->positions_in(at < motion_->count() ? at : begin_ + (at - begin_) % period_, positions_m);
  }

 private:
  std::shared_ptr<const sim::BodyFrames> motion_;
  std::size_t begin_;
  std::size_t period_;
  std::size_t first_;
};

}  // namespace

LoopBegin find_loop_begin(const sim::BodyFrames& motion, std::size_t vertices) {
  std::vector<sim::Vec3> last_m(vertices);
  std::vector<sim::Vec3> frame_m(vertices);
  motion.positions_in(motion.count() - 1, last_m);
  const auto lead_in = static_cast<std::size_t>(longest_lead_in_s * motion.rate_hz());
  const std::size_t latest = std::min((motion.count() - 1) / 2, lead_in);
  LoopBegin first;
  for (std::size_t frame = 0; frame <= latest; ++frame) {
    throw_if_interrupted();
    motion.positions_in(frame, frame_m);
    const double apart_m = furthest_m(frame_m, last_m);
    if (apart_m <= meets_within_m) {
      return {frame, apart_m, motion.count() > 1};
    }
    first = frame == 0 ? LoopBegin{0, apart_m, false} : first;
  }
  return first;
}

std::string describe(const LoopBegin& begin) {
  return begin.meets
             ? fmt::format("repeated, its motion goes on from frame {}, which its last is again", begin.frame)
             : fmt::format(
                   "repeated, its motion goes on from its first frame, from which its last is up to {:.3g} m "
                   "away",
                   begin.furthest_m);
}

std::shared_ptr<const sim::BodyFrames> looped(std::shared_ptr<const sim::BodyFrames> motion,
                                              const LoopBegin& begin, std::size_t first) {
  if (begin.furthest_m > furthest_in_frame_m) {
    throw InputError(
        fmt::format("found a motion to be repeated (loop, --body-loop) whose last frame is up to "
                    "{:.3g} m from its first, expected at most {:g} m",
                    begin.furthest_m, furthest_in_frame_m));
  }
  return std::make_shared<const LoopedFrames>(std::move(motion), begin, first);
}

}  // namespace taut::app
