#include "sim/self_collision.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "sim/strong_constraint.hpp"

namespace taut::sim {
namespace {

/// The skin as a multiple of the thickness: more means longer lists, made less often.
constexpr double skin_per_thickness = 1.0;

using Cell = std::array<std::int64_t, 3>;

Cell cell_of(const Vec3& position, double cell_m) {
  return {static_cast<std::int64_t>(std::floor(position.x / cell_m)),
          static_cast<std::int64_t>(std::floor(position.y / cell_m)),
          static_cast<std::int64_t>(std::floor(position.z / cell_m))};
}

std::size_t bucket_of(const Cell& cell, std::size_t bucket_count) {
  std::uint64_t h = 0;
  for (const std::int64_t c : cell) {
    h = (h ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15ULL;
    h ^= h >> 29;
  }
  return h % bucket_count;
}

double squared_distance(const Vec3& a, const Vec3& b) {
  return glm::dot(a - b, a - b);
}

}  // namespace

bool NeighbourList::is_current(std::span<const Vec3> positions, double thickness_m) const {
  if (made_for_thickness_m_ != thickness_m || made_at_.size() != positions.size()) {
    return false;
  }
  const double far_m = skin_per_thickness * thickness_m / 2.0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!(squared_distance(positions[v], made_at_[v]) < far_m * far_m)) {
      return false;
    }
  }
  return true;
}

void NeighbourList::sort_into_cells(std::span<const Vec3> positions, double cell_m) {
  const std::size_t bucket_count = 2 * positions.size() + 1;
  bucket_begin_.assign(bucket_count + 1, 0);
  sorted_.resize(positions.size());
  for (const Vec3& p : positions) {
    ++bucket_begin_[bucket_of(cell_of(p, cell_m), bucket_count) + 1];
  }
  for (std::size_t b = 0; b < bucket_count; ++b) {
    bucket_begin_[b + 1] += bucket_begin_[b];
  }
  std::vector<Index> next(bucket_begin_.begin(), bucket_begin_.end() - 1);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    sorted_[next[bucket_of(cell_of(positions[v], cell_m), bucket_count)]++] = static_cast<Index>(v);
  }
}

void NeighbourList::collect_pairs(std::span<const Vec3> rest_positions, double thickness_m, double reach_m) {
  pairs_.clear();
  const std::size_t bucket_count = bucket_begin_.size() - 1;
  const double cloth_neighbour_m = 2.0 * thickness_m;
  for (Index v = 0; v < made_at_.size(); ++v) {
    const std::size_t first_of_v = pairs_.size();
    const Cell centre = cell_of(made_at_[v], reach_m);
    for (int neighbour = 0; neighbour < 27; ++neighbour) {
      const std::size_t b = bucket_of(
          {centre[0] + neighbour % 3 - 1, centre[1] + neighbour / 3 % 3 - 1, centre[2] + neighbour / 9 - 1},
          bucket_count);
      for (Index k = bucket_begin_[b]; k < bucket_begin_[b + 1]; ++k) {
        const Index other = sorted_[k];
        if (other > v && squared_distance(made_at_[v], made_at_[other]) < reach_m * reach_m &&
            squared_distance(rest_positions[v], rest_positions[other]) >
                cloth_neighbour_m * cloth_neighbour_m) {
          pairs_.push_back({v, other});
        }
      }
    }
    // Two of the 27 cells can share a bucket.
    std::sort(pairs_.begin() + static_cast<std::ptrdiff_t>(first_of_v), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin() + static_cast<std::ptrdiff_t>(first_of_v), pairs_.end()),
                 pairs_.end());
  }
}

void NeighbourList::update(std::span<const Vec3> rest_positions, std::span<const Vec3> positions,
                           double thickness_m) {
  if (is_current(positions, thickness_m)) {
    return;
  }
  const double reach_m = (1.0 + skin_per_thickness) * thickness_m;
  made_at_.assign(positions.begin(), positions.end());
  made_for_thickness_m_ = thickness_m;
  sort_into_cells(positions, reach_m);
  collect_pairs(rest_positions, thickness_m, reach_m);
}

void push_layers_apart(std::span<const Edge> pairs, double thickness_m,
                       std::span<const double> inverse_masses_per_kg, std::span<Vec3> predicted) {
  for (const Edge& pair : pairs) {
    const Vec3 between = predicted[pair[0]] - predicted[pair[1]];
    const double squared_m = glm::dot(between, between);
    if (squared_m < thickness_m * thickness_m) {
      const double distance_m = std::sqrt(squared_m);
      compensate_spring(pair, between, distance_m, distance_m - thickness_m, inverse_masses_per_kg,
                        predicted);
    }
  }
}

}  // namespace taut::sim
