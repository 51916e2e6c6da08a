#include "sim/solvers/bounded/contact/closest_points.hpp"

namespace taut::sim::bounded {
namespace {

float clamped_ratio(float part, float whole) { return whole > 0.0F ? std::clamp(part / whole, 0.0F, 1.0F) : 0.0F; }

}  // namespace

// Tests the Voronoi regions of corners, edges and face in turn (Ericson 2005, 5.1.5).
ClosestWeights closest_vertex_triangle(const std::array<glm::vec3, 4>& p) {
  const glm::vec3 ab = p[2] - p[1];
  const glm::vec3 ac = p[3] - p[1];
  const glm::vec3 ap = p[0] - p[1];
  const float d1 = glm::dot(ab, ap);
  const float d2 = glm::dot(ac, ap);
  if (d1 <= 0.0F && d2 <= 0.0F) return {1.0F, 1.0F, 0.0F, 0.0F};
  const glm::vec3 bp = p[0] - p[2];
  const float d3 = glm::dot(ab, bp);
  const float d4 = glm::dot(ac, bp);
  if (d3 >= 0.0F && d4 <= d3) return {1.0F, 0.0F, 1.0F, 0.0F};
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0F && d1 >= 0.0F && d3 <= 0.0F) {
    const float v = clamped_ratio(d1, d1 - d3);
    return {1.0F, 1.0F - v, v, 0.0F};
  }
  const glm::vec3 cp = p[0] - p[3];
  const float d5 = glm::dot(ab, cp);
  const float d6 = glm::dot(ac, cp);
  if (d6 >= 0.0F && d5 <= d6) return {1.0F, 0.0F, 0.0F, 1.0F};
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0F && d2 >= 0.0F && d6 <= 0.0F) {
    const float w = clamped_ratio(d2, d2 - d6);
    return {1.0F, 1.0F - w, 0.0F, w};
  }
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0.0F && d4 - d3 >= 0.0F && d5 - d6 >= 0.0F) {
    const float w = clamped_ratio(d4 - d3, (d4 - d3) + (d5 - d6));
    return {1.0F, 0.0F, 1.0F - w, w};
  }
  const float sum = va + vb + vc;
  const float v = vb / sum;
  const float w = vc / sum;
  return {1.0F, 1.0F - v - w, v, w};
}

// Closest points of two lines, clamped to one segment and then to the other (Ericson 2005, 5.1.9).
ClosestWeights closest_edges(const std::array<glm::vec3, 4>& p) {
  const glm::vec3 d1 = p[1] - p[0];
  const glm::vec3 d2 = p[3] - p[2];
  const glm::vec3 r = p[0] - p[2];
  const float a = glm::dot(d1, d1);
  const float e = glm::dot(d2, d2);
  const float f = glm::dot(d2, r);
  const float c = glm::dot(d1, r);
  const float b = glm::dot(d1, d2);
  float s = clamped_ratio(b * f - c * e, a * e - b * b);
  const float t = clamped_ratio(b * s + f, e);
  s = clamped_ratio(b * t - c, a);
  return {1.0F - s, s, 1.0F - t, t};
}

}  // namespace taut::sim::bounded
