#include "renderer/key_decision.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace taut::renderer {

namespace {

constexpr int taps = 24;
// Farther around than this share of the map, taps may step over a shadow: the pixels have to look.
constexpr float widest = 0.05F;
// A surface seen this flat by the light hides itself in the map; sine of the angle.
constexpr float flattest = 0.1F;
// Radius of the narrowest blur of a shadow, texels of its map, and as much again for the lift off the
// surface.
constexpr float sharpest_texels = 4.0F;
// Of the map, as a share of its depth.
constexpr float depth_allowance = 1.5F / 1024.0F;
// Spots on the surface's own plane are not in its way, nor is what bends this much out of it.
constexpr float bend = 0.04F;

// Evenly over the unit disc (Vogel 1979).
std::array<glm::vec2, taps> disc() {
  std::array<glm::vec2, taps> spots;
  for (int i = 0; i < taps; ++i) {
    const float radius = std::sqrt((static_cast<float>(i) + 0.5F) / static_cast<float>(taps));
    const float turn = 2.39996323F * static_cast<float>(i);
    spots[static_cast<std::size_t>(i)] = radius * glm::vec2{std::cos(turn), std::sin(turn)};
  }
  return spots;
}

// For every vertex the length of the longest edge of its triangles.
void longest_edges(const SurfaceView& surface, std::vector<float>& lengths_m) {
  lengths_m.assign(surface.positions.size(), 0.0F);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const std::uint32_t a = surface.triangles[i];
    const std::uint32_t b = surface.triangles[i % 3 == 2 ? i - 2 : i + 1];
    const float length_m = glm::distance(surface.positions[a], surface.positions[b]);
    lengths_m[a] = std::max(lengths_m[a], length_m);
    lengths_m[b] = std::max(lengths_m[b], length_m);
  }
}

}  // namespace

void KeyDecision::look(const DepthMap& casters, const FrameBlock& block) {
  map = &casters;
  const bool any = casters.drawn().lower != casters.drawn().upper;
  side_m = !any || block.shadow.w <= 0.0F ? 0.0F : block.shadow.z;
  world_to_map = block.world_to_shadow;
  towards_key = glm::vec3{block.towards_key};
  softness_m = widest_penumbra_texels * block.shadow.x;
  sharpest_m = sharpest_texels * block.shadow.x;
  tangent = block.shadow.w;
}

void KeyDecision::decide(const SurfaceView& surface, std::vector<float>& decided) {
  decided.assign(surface.positions.size(), 1.0F);
  if (side_m <= 0.0F) return;
  longest_edges(surface, reaches_m);
  for (std::size_t i = 0; i < decided.size(); ++i) {
    decided[i] = decide_vertex(surface.positions[i], surface.normals[i], reaches_m[i]);
  }
}

KeyDecision::Blockers KeyDecision::look_around(const glm::vec3& place, const glm::vec2& slope,
                                               float radius) const {
  static const std::array<glm::vec2, taps> spots = disc();
  const float allowance = (depth_allowance + bend * radius) * (1.0F + 0.5F * glm::length(slope));
  Blockers found;
  for (const glm::vec2& spot : spots) {
    const glm::vec2 offset = radius * spot;
    const float gap = place.z + glm::dot(slope, offset) - map->depth_at(glm::vec2{place} + offset);
    found.count += gap > allowance ? 1 : 0;
    found.widest_gap = std::max(found.widest_gap, gap);
  }
  return found;
}

float KeyDecision::decide_vertex(const glm::vec3& position, const glm::vec3& normal, float reach_m) const {
  const float radius = (softness_m + reach_m) / side_m;
  const glm::vec3 facing = glm::dot(normal, towards_key) >= 0.0F ? normal : -normal;
  const glm::vec3 across = glm::mat3{world_to_map} * facing;
  if (radius > widest || across.z > -flattest * glm::length(across)) return 0.5F;
  const glm::vec3 place{world_to_map * glm::vec4{position, 1.0F}};
  const glm::vec2 slope = -glm::vec2{across} / across.z;
  const Blockers around = look_around(place, slope, radius);
  if (around.count == 0) return 1.0F;
  if (around.count == taps) return 0.0F;
  // What is close in front throws a sharp shadow: only what is near enough to the vertex can reach its
  // triangles.
  const float penumbra_m = std::max(around.widest_gap * side_m * tangent, sharpest_m);
  if (penumbra_m >= softness_m) return 0.5F;
  const Blockers near = look_around(place, slope, (penumbra_m + reach_m) / side_m);
  if (near.count == 0) return 1.0F;
  return near.count == taps ? 0.0F : 0.5F;
}

}  // namespace taut::renderer
