#include "renderer/light/key_decision.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "renderer/light/triangle_spans.hpp"

namespace taut::renderer {

namespace {

// Texels of the map from sample to sample. Shadows narrower than that may be missed.
constexpr int stride = 2;
// A surface this steep in the map hides itself; depth for each step across.
constexpr float steepest = 8.0F;
// What is less than this in front is the surface itself; texels of the map, and as many for each unit of
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

void KeyDecision::look(const DepthMap& casters, const FrameBlock& block) {
  map = &casters;
  const bool any = casters.drawn().lower != casters.drawn().upper;
  side_m = !any || block.shadow.w <= 0.0F ? 0.0F : block.shadow.z;
  world_to_map = block.world_to_shadow;
  softness_m = block.shadow_blur.x * block.shadow.x;
  sharpest_m = sharpest_texels * block.shadow.x;
  tangent = block.shadow.w;
}

float KeyDecision::penumbra_m(float gap) const {
  return std::clamp(gap * side_m * tangent, std::min(sharpest_m, softness_m), softness_m);
}

KeyDecision::Sight KeyDecision::sight_of(Corners corners) const {
  const glm::vec3& a = projected[corners[0]];
  const glm::vec3& b = projected[corners[1]];
  const glm::vec3& c = projected[corners[2]];
  const int side_px = map->side_px();
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
  const float* depths = map->depths().data();
  triangle_spans(a, b, c, side_px / stride, [&](const TriangleSpan& span) {
    const float* row = depths + static_cast<std::ptrdiff_t>(span.row * stride) * side_px;
    for (int column = span.first; column <= span.last; ++column) {
      look_at(span.depth + span.depth_step * static_cast<float>(column) - row[column * stride]);
    }
  });
  if (sight.lit + sight.dark == 0) {
    const glm::vec3 middle = (a + b + c) / 3.0F;
    look_at(middle.z - map->depth_at(glm::vec2{middle} * sample));
  }
  return sight;
}

// Every triangle with itself alone.
void KeyDecision::compare(const SurfaceView& surface, std::vector<KeyLight>& decided) {
  project_to_map(world_to_map, map->side_px() / stride, surface.positions, projected);
  penumbrae_m.resize(decided.size());
  for (std::size_t i = 0; i < decided.size(); ++i) {
    const Sight sight = sight_of(Corners(&surface.triangles[3 * i], 3));
    const KeyLight whole = sight.dark == 0 ? KeyLight::light : KeyLight::shadow;
    decided[i] = sight.lit > 0 && sight.dark > 0 ? KeyLight::open : whole;
    penumbrae_m[i] = sight.dark == 0 ? 0.0F : penumbra_m(sight.widest_gap);
  }
}

// Penumbrae start at vertices which both light and shadow touch.
void KeyDecision::find_edges(std::span<const std::uint32_t> triangles, const std::vector<KeyLight>& decided) {
  std::fill(touched.begin(), touched.end(), std::uint8_t{0});
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const KeyLight own = decided[i / 3];
    touched[triangles[i]] |= own == KeyLight::shadow ? by_shadow : own == KeyLight::light ? by_light : 3;
  }
  std::fill(reaches_m.begin(), reaches_m.end(), 0.0F);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t vertex = triangles[i];
    if (touched[vertex] == (by_light | by_shadow)) {
      reaches_m[vertex] = std::max(reaches_m[vertex], penumbrae_m[i / 3]);
    }
  }
}

void KeyDecision::spread(const SurfaceView& surface) {
  bool changed = true;
  const auto pass_on = [&](std::uint32_t from, std::uint32_t to) {
    if (reaches_m[from] <= reaches_m[to]) return;
    const float edge_m = glm::distance(surface.positions[from], surface.positions[to]);
    const float left_m = reaches_m[from] - straightness * edge_m;
    if (left_m <= reaches_m[to]) return;
    reaches_m[to] = left_m;
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

void KeyDecision::decide(const SurfaceView& surface, std::vector<KeyLight>& decided) {
  decided.assign(surface.triangles.size() / 3, KeyLight::light);
  if (side_m <= 0.0F) return;
  compare(surface, decided);
  touched.resize(surface.positions.size());
  reaches_m.resize(surface.positions.size());
  find_edges(surface.triangles, decided);
  spread(surface);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    if (reaches_m[surface.triangles[i]] > 0.0F) decided[i / 3] = KeyLight::open;
  }
}

}  // namespace taut::renderer
