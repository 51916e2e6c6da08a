#include "renderer/light/shadow_classifier.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "renderer/light/rasterise_triangle.hpp"

namespace taut::renderer {

namespace {

// Texels of the map from sample to sample. Shadows narrower than that may be missed.
constexpr int stride = 2;
// A surface this steep in the map hides itself; depth for each step across.
constexpr float steepest = 8.0F;
// A surface that is less than this in front is the surface itself; texels of the map, and as many for each unit of
// slope.
constexpr float allowance_texels = 2.0F;
// Radius of the narrowest blur of a shadow and of the lift off the surface, texels of the map.
constexpr float sharpest_texels = 4.0F;
// Rounds in which penumbrae spread from vertex to vertex: more edges than this are in no blur's width, or so
// short that they do not matter.
constexpr int most_rounds = 12;
// A straight line is shorter than the edges along it, by this factor where they meet at right angles.
constexpr float straightness = 0.7F;

constexpr std::uint8_t by_light = 1;
constexpr std::uint8_t by_shadow = 2;

glm::vec2 slope_of(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 across = glm::cross(b - a, c - a);
  return across.z == 0.0F ? glm::vec2{INFINITY} : -glm::vec2{across} / across.z;
}

}  // namespace

void ShadowClassifier::set_shadow_map(const ShadowMap& casters, const FrameBlock& block) {
  map_ = &casters;
  const bool any = casters.drawn().lower != casters.drawn().upper;
  side_m_ = !any || block.shadow.w <= 0.0F ? 0.0F : block.shadow.z;
  world_to_map_ = block.world_to_shadow;
  softness_m_ = block.shadow_blur.x * block.shadow.x;
  sharpest_m_ = sharpest_texels * block.shadow.x;
  tangent_ = block.shadow.w;
}

float ShadowClassifier::penumbra_m(float gap) const {
  return std::clamp(gap * side_m_ * tangent_, std::min(sharpest_m_, softness_m_), softness_m_);
}

ShadowClassifier::Sight ShadowClassifier::sight_of(Corners corners) const {
  const glm::vec3& a = projected_[corners[0]];
  const glm::vec3& b = projected_[corners[1]];
  const glm::vec3& c = projected_[corners[2]];
  const int side_px = map_->side_px();
  const float sample = static_cast<float>(stride) / static_cast<float>(side_px);
  const glm::vec2 slope = slope_of(a, b, c) / sample;
  const float steepness = glm::length(slope);
  Sight sight;
  if (!(steepness < steepest)) return {1, 1, 0.0F};
  const float allowance = allowance_texels * (1.0F + steepness) / static_cast<float>(side_px);
  const auto look_at = [&](float gap) {
    const bool hidden = gap > allowance;
    sight.dark += hidden ? 1 : 0;
    sight.lit += hidden ? 0 : 1;
    sight.widest_gap = std::max(sight.widest_gap, gap);
  };
  const float* depths = map_->depths().data();
  rasterise_triangle(a, b, c, side_px / stride, [&](const TriangleSpan& span) {
    const float* row = depths + static_cast<std::ptrdiff_t>(span.row * stride) * side_px;
    for (int column = span.first; column <= span.last; ++column) {
      look_at(span.depth + span.depth_step * static_cast<float>(column) - row[column * stride]);
    }
  });
  if (sight.lit + sight.dark == 0) {
    const glm::vec3 middle = (a + b + c) / 3.0F;
    look_at(middle.z - map_->depth_at(glm::vec2{middle} * sample));
  }
  return sight;
}

// Every triangle with itself alone.
void ShadowClassifier::compare(const SurfaceView& surface, std::vector<KeyVisibility>& visibility) {
  project_to_map(world_to_map_, map_->side_px() / stride, surface.positions, projected_);
  penumbrae_m_.resize(visibility.size());
  for (std::size_t i = 0; i < visibility.size(); ++i) {
    const Sight sight = sight_of(Corners(&surface.triangles[3 * i], 3));
    const KeyVisibility whole = sight.dark == 0 ? KeyVisibility::lit : KeyVisibility::shadowed;
    visibility[i] = sight.lit > 0 && sight.dark > 0 ? KeyVisibility::partial : whole;
    penumbrae_m_[i] = sight.dark == 0 ? 0.0F : penumbra_m(sight.widest_gap);
  }
}

// Penumbrae start at vertices which both light and shadow touch.
void ShadowClassifier::find_shadow_edges(std::span<const std::uint32_t> triangles,
                                         const std::vector<KeyVisibility>& visibility) {
  std::fill(touched_.begin(), touched_.end(), std::uint8_t{0});
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const KeyVisibility own = visibility[i / 3];
    touched_[triangles[i]] |= own == KeyVisibility::shadowed ? by_shadow
                              : own == KeyVisibility::lit    ? by_light
                                                             : 3;
  }
  std::fill(reaches_m_.begin(), reaches_m_.end(), 0.0F);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t vertex = triangles[i];
    if (touched_[vertex] == (by_light | by_shadow)) {
      reaches_m_[vertex] = std::max(reaches_m_[vertex], penumbrae_m_[i / 3]);
    }
  }
}

void ShadowClassifier::spread(const SurfaceView& surface) {
  bool changed = true;
  const auto pass_on = [&](std::uint32_t from, std::uint32_t to) {
    if (reaches_m_[from] <= reaches_m_[to]) return;
    const float edge_m = glm::distance(surface.positions[from], surface.positions[to]);
    const float left_m = reaches_m_[from] - straightness * edge_m;
    if (left_m <= reaches_m_[to]) return;
    reaches_m_[to] = left_m;
    changed = true;
  };
  for (int round = 0; round < most_rounds && changed; ++round) {
    changed = false;
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
      const std::uint32_t from = surface.triangles[i];
      const std::uint32_t to = surface.triangles[i % 3 == 2 ? i - 2 : i + 1];
      pass_on(from, to);
      pass_on(to, from);
    }
  }
}

void ShadowClassifier::classify(const SurfaceView& surface, std::vector<KeyVisibility>& visibility) {
  visibility.assign(surface.triangles.size() / 3, KeyVisibility::lit);
  if (side_m_ <= 0.0F) return;
  compare(surface, visibility);
  touched_.resize(surface.positions.size());
  reaches_m_.resize(surface.positions.size());
  find_shadow_edges(surface.triangles, visibility);
  spread(surface);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    if (reaches_m_[surface.triangles[i]] > 0.0F) visibility[i / 3] = KeyVisibility::partial;
  }
}

}  // namespace taut::renderer
