#include "renderer/light/shadow_map.hpp"

#include "renderer/light/surface_buffers.hpp"

namespace taut::renderer {
namespace {

// Texels of the map from sample to sample. Shadows narrower than that may be missed.
constexpr int stride = 2;
// A surface this steep in the map hides itself; depth for each step across.
constexpr float steepest = 8.0F;
// A surface that is less than this in front is the surface itself; texels of the map, and as many for each
// unit of slope.
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

void project_to_map(const glm::mat4& world_to_map, int side_px, std::span<const glm::vec3> positions,
                    std::vector<glm::vec3>& projected) {
  const auto scale = static_cast<float>(side_px);
  projected.resize(positions.size());
  std::ranges::transform(positions, projected.begin(), [&](const glm::vec3& position) {
    const glm::vec3 place{world_to_map * glm::vec4{position, 1.0F}};
    return glm::vec3{place.x * scale, place.y * scale, place.z};
  });
}

void ShadowMap::resize(int side_px) {
  if (side_px == side_) return;
  side_ = side_px;
  drawn_ = {};
  texels_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), 1.0F);
}

void ShadowMap::clear() {
  for (int y = drawn_.lower.y; y < drawn_.upper.y; ++y) {
    const auto row = texels_.begin() + static_cast<std::ptrdiff_t>(y) * side_;
    std::fill(row + drawn_.lower.x, row + drawn_.upper.x, 1.0F);
  }
  drawn_ = {};
}

void ShadowMap::include(const std::vector<glm::vec3>& points) {
  glm::vec2 lower{INFINITY};
  glm::vec2 upper{-INFINITY};
  for (const glm::vec3& point : points) {
    lower = glm::min(lower, glm::vec2{point});
    upper = glm::max(upper, glm::vec2{point});
  }
  if (!(lower.x <= upper.x && lower.y <= upper.y)) return;
  const MapArea own{{whole_within(lower.x - 1.0F, 0, side_), whole_within(lower.y - 1.0F, 0, side_)},
                    {whole_within(upper.x + 2.0F, 0, side_), whole_within(upper.y + 2.0F, 0, side_)}};
  const bool first = drawn_.lower == drawn_.upper;
  drawn_ = first ? own : MapArea{glm::min(drawn_.lower, own.lower), glm::max(drawn_.upper, own.upper)};
}

void ShadowMap::draw(const glm::mat4& world_to_map, std::span<const glm::vec3> positions,
                     std::span<const std::uint32_t> triangles) {
  project_to_map(world_to_map, side_, positions, projected_);
  include(projected_);
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const glm::vec3& a = projected_[triangles[i]];
    const glm::vec3& b = projected_[triangles[i + 1]];
    const glm::vec3& c = projected_[triangles[i + 2]];
    const float least = std::min({a.z, b.z, c.z});
    rasterise_triangle(a, b, c, side_, [&](const TriangleSpan& span) {
      float* row = texels_.data() + static_cast<std::ptrdiff_t>(span.row) * side_;
      for (int column = span.first; column <= span.last; ++column) {
        // On a needle's edge the slope may lead astray.
        const float depth = std::max(span.depth + span.depth_step * static_cast<float>(column), least);
        row[column] = std::min(row[column], depth);
      }
    });
  }
}

float ShadowMap::depth_at(const glm::vec2& place) const {
  const glm::vec2 texel = place * static_cast<float>(side_);
  const auto highest = static_cast<float>(side_);
  if (!(texel.x >= 0.0F && texel.y >= 0.0F && texel.x < highest && texel.y < highest)) return 1.0F;
  return texels_[static_cast<std::size_t>(static_cast<int>(texel.y) * side_ + static_cast<int>(texel.x))];
}

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
  std::ranges::fill(touched_, std::uint8_t{0});
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const KeyVisibility own = visibility[i / 3];
    touched_[triangles[i]] |= own == KeyVisibility::shadowed ? by_shadow : own == KeyVisibility::lit ? by_light : 3;
  }
  std::ranges::fill(reaches_m_, 0.0F);
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
