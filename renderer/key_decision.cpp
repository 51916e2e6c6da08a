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
constexpr float flattest = 0.3F;
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
}

void KeyDecision::decide(const SurfaceView& surface, std::vector<float>& decided) {
  decided.assign(surface.positions.size(), 1.0F);
  if (side_m <= 0.0F) return;
  longest_edges(surface, reaches_m);
  for (std::size_t i = 0; i < decided.size(); ++i) {
    decided[i] = decide_vertex(surface.positions[i], surface.normals[i], reaches_m[i]);
  }
}

float KeyDecision::decide_vertex(const glm::vec3& position, const glm::vec3& normal, float reach_m) const {
  static const std::array<glm::vec2, taps> spots = disc();
  const float radius = (softness_m + reach_m) / side_m;
  const glm::vec3 facing = glm::dot(normal, towards_key) >= 0.0F ? normal : -normal;
  const glm::vec3 across = glm::mat3{world_to_map} * facing;
  if (radius > widest || across.z > -flattest * glm::length(across)) return 0.5F;
  const glm::vec3 place{world_to_map * glm::vec4{position, 1.0F}};
  const glm::vec2 slope = -glm::vec2{across} / across.z;
  const float allowance = depth_allowance + bend * radius;
  int blockers = 0;
  for (const glm::vec2& spot : spots) {
    const glm::vec2 offset = radius * spot;
    const float own_depth = place.z + glm::dot(slope, offset);
    blockers += map->depth_at(glm::vec2{place} + offset) < own_depth - allowance ? 1 : 0;
  }
  if (blockers == 0) return 1.0F;
  return blockers == taps ? 0.0F : 0.5F;
}

}  // namespace taut::renderer
