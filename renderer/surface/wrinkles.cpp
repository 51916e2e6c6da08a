#include "renderer/surface/wrinkles.hpp"

namespace taut::renderer {
namespace {

/// Smallest shortening with wrinkles; meshes tremble by less.
constexpr float min_shortening_fraction = 0.003F;
/// Largest cosine between a wave's direction and the surface normal for which it shows.
constexpr float max_normal_cosine = 0.7F;
/// Fraction of the shortening that wrinkles take up; folds of the mesh take the rest.
constexpr float share_of_wrinkles = 0.5F;
/// Rounds of averaging with neighbours.
constexpr int averaging_rounds = 2;

/// Returns the wave directions: the axes of a regular dodecahedron's corners, so that some lie in any surface.
std::array<glm::vec3, 10> directions() {
  const float a = 1.0F / std::sqrt(3.0F), golden = 0.5F * (1.0F + std::sqrt(5.0F));
  const float b = a / golden, c = a * golden;
  return {glm::vec3(a, a, a), {a, a, -a}, {a, -a, a}, {-a, a, a},   {0.0F, b, c},
          {0.0F, b, -c},      {b, c, 0},  {b, -c, 0}, {c, 0.0F, b}, {c, 0.0F, -b}};
}

}  // namespace

Wrinkles::Wrinkles(std::span<const glm::vec3> rest_positions, std::span<const std::uint32_t> triangles,
                   float wavelength)
    : directions_(directions()),
      triangles_(triangles.begin(), triangles.end()),
      weights_(rest_positions.size(), 0.0F),
      wavelength_(wavelength) {
  for (std::size_t i = 0; i + 2 < triangles_.size(); i += 3) {
    const glm::vec3& a = rest_positions[triangles_[i]];
    const glm::vec3 b = rest_positions[triangles_[i + 1]] - a, c = rest_positions[triangles_[i + 2]] - a;
    const glm::vec3 normal = glm::cross(b, c);
    const float squared = glm::dot(normal, normal);
    const float inverse = squared > 0.0F ? 1.0F / squared : 0.0F;
    planes_.push_back({inverse * glm::cross(c, normal), inverse * glm::cross(normal, b), std::sqrt(squared), {}});
    for (std::size_t k = 0; k < waves; ++k) {
      const float into = glm::dot(directions_[k], normal);
      const float along = 1.0F - into * into * inverse;
      planes_.back().along[k] = along < 1.0F - max_normal_cosine * max_normal_cosine ? 0.0F : along;
    }
    for (std::size_t k = 0; k < 3; ++k) weights_[triangles_[i + k]] += planes_.back().area;
  }
  for (const TriangleSide& side : sorted_sides(triangles_)) {
    if (edges_.empty() || edges_.back() != side.ends) edges_.push_back(side.ends);
  }
}

void Wrinkles::refine(std::span<const glm::vec3> fine_rest_positions, std::span<const VertexPair> parents) {
  parents_.assign(parents.begin(), parents.end());
  shapes_.clear();
  const float number = 2.0F * std::numbers::pi_v<float> / wavelength_;
  for (const glm::vec3& p : fine_rest_positions) {
    PerWave& shape = shapes_.emplace_back();
    for (std::size_t k = 0; k < waves; ++k) {
      // Slow bends of the wave fronts, so that no wave is straight.
      const float bend =
          1.4F * std::sin(0.23F * number * glm::dot(directions_[(k + 3) % waves], p)) +
          0.9F * std::sin(0.41F * number * glm::dot(directions_[(k + 7) % waves], p) + static_cast<float>(k));
      shape[k] = std::cos(number * glm::dot(directions_[k], p) + bend + 2.4F * static_cast<float>(k)) / number;
    }
  }
}

// The most shortened wave direction in the triangle gives the slope, and directions near it share it.
Wrinkles::PerWave Wrinkles::squared_slopes(std::size_t t, std::span<const glm::vec3> positions) const {
  const glm::vec3& a = positions[triangles_[3 * t]];
  const glm::vec3 b = positions[triangles_[3 * t + 1]] - a, c = positions[triangles_[3 * t + 2]] - a;
  const RestTriangle& plane = planes_[t];
  PerWave shares{};
  float max_share = 0.0F, sum = 0.0F;
  for (std::size_t k = 0; k < waves; ++k) {
    if (plane.along[k] == 0.0F) continue;
    const glm::vec3 now = glm::dot(plane.side_b, directions_[k]) * b + glm::dot(plane.side_c, directions_[k]) * c;
    const float shortened = 1.0F - std::sqrt(glm::dot(now, now) / plane.along[k]) - min_shortening_fraction;
    shares[k] = std::max(shortened, 0.0F);
    max_share = std::max(max_share, shares[k]);
  }
  for (float& share : shares) {
    const float nearness = max_share > 0.0F ? share / max_share : 0.0F;
    share = nearness * nearness * nearness * nearness;
    sum += share;
  }
  for (float& share : shares) share *= sum > 0.0F ? 4.0F * share_of_wrinkles * max_share / sum : 0.0F;
  return shares;
}

void Wrinkles::spread(std::vector<PerWave>& values) const {
  std::vector<PerWave> sums = values;
  std::vector<float> counts(weights_.size(), 1.0F);
  for (const auto& [a, b] : edges_) {
    for (std::size_t k = 0; k < waves; ++k) {
      sums[a][k] += values[b][k];
      sums[b][k] += values[a][k];
    }
    counts[a] += 1.0F;
    counts[b] += 1.0F;
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    for (std::size_t k = 0; k < waves; ++k) values[v][k] = sums[v][k] / counts[v];
  }
}

std::span<const float> Wrinkles::heights(std::span<const glm::vec3> positions) {
  slopes_.assign(weights_.size(), PerWave{});
  for (std::size_t t = 0; t < planes_.size(); ++t) {
    const PerWave squared = squared_slopes(t, positions);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = triangles_[3 * t + k];
      const float share = planes_[t].area / std::max(weights_[v], 1e-30F);
      for (std::size_t w = 0; w < waves; ++w) slopes_[v][w] += share * squared[w];
    }
  }
  for (int round = 0; round < averaging_rounds; ++round) spread(slopes_);
  for (PerWave& slopes : slopes_) {
    for (float& slope : slopes) slope = std::sqrt(slope);
  }
  heights_.assign(shapes_.size(), 0.0F);
  for (std::size_t v = 0; v < shapes_.size(); ++v) {
    if (v >= weights_.size()) {
      const auto& [a, b] = parents_[v - weights_.size()];
      PerWave mean{};
      for (std::size_t k = 0; k < waves; ++k) mean[k] = 0.5F * (slopes_[a][k] + slopes_[b][k]);
      slopes_.push_back(mean);
    }
    for (std::size_t k = 0; k < waves; ++k) heights_[v] += slopes_[v][k] * shapes_[v][k];
  }
  return heights_;
}

}  // namespace taut::renderer
