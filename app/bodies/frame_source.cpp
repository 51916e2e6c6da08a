#include "app/bodies/frame_source.hpp"

#include "app/base/errors.hpp"
#include "app/verify/crossing_pairs.hpp"

namespace taut::app {
namespace {

/// A step of the simulation needs two frames at its begin and two at its end, and a picture two more.
constexpr std::size_t most_remembered = 6;

}  // namespace

PlacedFrames::PlacedFrames(std::filesystem::path motion, std::unique_ptr<const FrameSource> source,
                           FileVertexPlaces places, double rate_hz, std::size_t first)
    : motion_(std::move(motion)),
      source_(std::move(source)),
      places_(std::move(places)),
      rate_hz_(rate_hz),
      first_(first) {}

void PlacedFrames::positions_in(std::size_t frame, std::span<sim::Vec3> positions_m) const {
  const Positions placed_m = placed(frame);
  std::copy(placed_m->begin(), placed_m->end(), positions_m.begin());
}

// Reading is left unlocked: two threads may read the same frame, and both get the same.
PlacedFrames::Positions PlacedFrames::placed(std::size_t frame) const {
  if (Positions known = remembered(frame)) return known;
  Positions positions_m = read(frame);
  if (const Positions before_m = frame > 0 ? remembered(frame - 1) : nullptr) {
    require_near(frame, before_m, positions_m);
  }
  if (const Positions after_m = remembered(frame + 1)) require_near(frame + 1, positions_m, after_m);
  const std::lock_guard lock(mutex_);
  if (remembered_.size() == most_remembered) remembered_.erase(remembered_.begin());
  remembered_.push_back({frame, positions_m});
  return positions_m;
}

PlacedFrames::Positions PlacedFrames::remembered(std::size_t frame) const {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find(remembered_, frame, &Remembered::frame);
  return found == remembered_.end() ? nullptr : found->positions_m;
}

PlacedFrames::Positions PlacedFrames::read(std::size_t frame) const {
  std::vector<sim::Vec3> in_file(source_->vertices());
  source_->read(first_ + frame, in_file);
  std::vector<sim::Vec3> positions_m;
  positions_m.reserve(places_.file_vertex.size());
  for (const std::size_t v : places_.file_vertex) {
    const sim::Vec3& position_m = positions_m.emplace_back(places_.placement(in_file[v]));
    if (!std::isfinite(position_m.x + position_m.y + position_m.z)) {
      refuse(frame, v, fmt::format("found at {}, expected numbers", describe_point(in_file[v])));
    }
  }
  return std::make_shared<const std::vector<sim::Vec3>>(std::move(positions_m));
}

void PlacedFrames::require_near(std::size_t frame, const Positions& before_m, const Positions& after_m) const {
  for (std::size_t v = 0; v < after_m->size(); ++v) {
    const double moved_m = glm::distance((*before_m)[v], (*after_m)[v]);
    if (!(moved_m <= furthest_in_frame_m)) {
      refuse(frame, places_.file_vertex[v],
             fmt::format("found at {} m, {:.3g} m from where it is in the frame before, expected at most {:g} m",
                         describe_point((*after_m)[v]), moved_m, furthest_in_frame_m));
    }
  }
}

void PlacedFrames::refuse(std::size_t frame, std::size_t vertex, const std::string& reason) const {
  throw InputError("'{}': frame {}, vertex {}: {}", motion_.string(), first_ + frame, vertex, reason);
}

}  // namespace taut::app
