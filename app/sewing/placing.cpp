#include "app/sewing/placing.hpp"

#include <fmt/core.h>

#include "app/base/errors.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/bodies/wearing.hpp"
#include "app/sewing/parting.hpp"

namespace taut::app {
namespace {

using sim::Index;
using sim::Vec3;

constexpr double gathered = 1.05;  ///< times as long as what it is sewn to

/// Pushes panels together that are longer than what they are sewn to, along that seam: the bound allows for
/// it, and cloth folds by itself when it is let go.
void push_ease_together(const SewingPattern& pattern, CutPieces& pieces) {
  const std::vector<Vec3> placed_m = pieces.placed_m;
  const std::vector<sim::Extent> boxes = panel_boxes(pieces);
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    Vec3 along(0.0);
    double own_m = 0.0, other_m = 0.0;
    for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
      for (const bool is_second : {false, true}) {
        const auto& [first, second] = pattern.stitches[s];
        const PanelEdge &own = is_second ? second : first, &other = is_second ? first : second;
        const double length_m = length_of(pattern.line_of(own));
        if (own.panel != p || other.panel == p || length_m < gathered * length_of(pattern.line_of(other))) continue;
        const auto& [begin, end] = std::pair(pieces.seams[s].front(), pieces.seams[s].back());
        const Vec3 way =
            is_second ? placed_m[end.second] - placed_m[begin.second] : placed_m[end.first] - placed_m[begin.first];
        along += glm::dot(along, way) < 0.0 ? -way : way;
        own_m += length_m;
        other_m += length_of(pattern.line_of(other));
      }
    }
    if (!(glm::length(along) > 0.0)) continue;
    along = glm::normalize(along);
    for (std::size_t v = 0; v < placed_m.size(); ++v) {
      if (pieces.panel_of[v] == p) {
        pieces.placed_m[v] -= (1.0 - other_m / own_m) * glm::dot(placed_m[v] - boxes[p].middle(), along) * along;
      }
    }
  }
}

void require_placed(const SewingPattern& pattern) {
  const PatternPanel& first = pattern.panels.front();
  const bool is_any_placed = std::ranges::any_of(pattern.panels, [&](const PatternPanel& panel) {
    return panel.translation_m != first.translation_m || panel.rotation != first.rotation;
  });
  if (pattern.panels.size() > 1 && !is_any_placed) {
    throw InputError(
        "found all {} panels of the pattern at {} m, turned alike; expected translations and rotations that place them "
        "about a body",
        pattern.panels.size(), describe_point(first.translation_m));
  }
}

/// A body that goes evenly from one shape to another.
class FramesBetween final : public sim::BodyFrames {
 public:
  FramesBetween(std::vector<Vec3> from_m, std::vector<Vec3> to_m, double frame_rate_hz)
      : from_m_(std::move(from_m)), to_m_(std::move(to_m)), rate_hz_(frame_rate_hz) {}

  std::size_t count() const override { return frames_to_own_shape + 1; }
  double rate_hz() const override { return rate_hz_; }
  void positions_in(std::size_t frame, std::span<Vec3> positions_m) const override {
    const double share = static_cast<double>(frame) / frames_to_own_shape;
    for (std::size_t v = 0; v < positions_m.size(); ++v) {
      positions_m[v] = share == 1.0 ? to_m_[v] : glm::mix(from_m_[v], to_m_[v], share);
    }
  }

 private:
  std::vector<Vec3> from_m_, to_m_;
  double rate_hz_;
};

/// Where the vertices of a body are that leaves no room for cloth.
std::vector<Vec3> own_shape_m(BodySource source, const ShownTime& shown) {
  source.dress = 0;
  return read_body(source, shown).mesh.data->positions_m;
}

const Wearer& wearer_of(const Scene& scene) {
  const Dressed dressed = dressed_body(scene);
  if (dressed.wearer == nullptr) {
    throw InputError("found no body that is dressed, expected someone to sew the pattern on");
  }
  return *dressed.wearer;
}

}  // namespace

double thin_time_s(const Scene& scene) {
  const Dressed dressed = dressed_body(scene);
  return std::get<sim::BodyMesh>(scene.surroundings.bodies[dressed.body].shape).frames->first_s() - 1000.0;
}

std::vector<std::string> bring_to_body(const SewingPattern& pattern, const Scene& scene, CutPieces& pieces) {
  const Wearer& wearer = wearer_of(scene);
  require_placed(pattern);
  std::vector<std::string> said;
  const Vec3 shift = move_to_height(pattern, wearer, pieces, said);
  push_ease_together(pattern, pieces);
  turn_sleeves(pattern, shift, wearer, pieces);
  return said;
}

std::vector<std::string> place_pieces(CutPieces& pieces, Scene& scene) {
  Wearer wearer = wearer_of(scene);
  const std::size_t b = dressed_body(scene).body;
  sim::Body& body = scene.surroundings.bodies[b];
  const double frame_rate_hz = scene.simulation.frame_rate_hz;
  wearer.motion = std::make_shared<const FramesBetween>(
      wearer.full_m, own_shape_m(scene.body_sources[b], {1.0, frame_rate_hz}), frame_rate_hz);
  wearer.rate_hz = frame_rate_hz;
  std::size_t moved = 0;
  // Pieces that were moved take the limbs with them that belong into them.
  for (std::size_t last = 1; last > 0;) {
    // Limbs turn while they are thin: sleeves are cut for arms that hang, and pull at shoulders otherwise.
    std::vector<RigPose> poses = turning_back(*wearer.rig, wearer.pose, turned_limbs(wearer, pieces));
    poses.insert(poses.end(), poses.size(), wearer.pose);
    std::get<sim::BodyMesh>(body.shape).frames = growing(wearer, poses);
    last = moved == 0 ? part_and_draw_in(body, thin_time_s(scene), *wearer.measures.neck_m, pieces) : 0;
    moved += last;
  }
  if (moved == 0) return {};
  return {fmt::format("{} of its {} pieces crossed another or the body where they were placed: moved apart", moved,
                      pieces.panel_count())};
}

}  // namespace taut::app
