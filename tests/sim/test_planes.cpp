// Planes of near pairs: the kernels give what loops over single pairs give.

#include <gtest/gtest.h>

#include <bit>
#include <glm/geometric.hpp>
#include <random>

#include "sim/solvers/bounded/contact/pair_batch.hpp"
#include "sim/solvers/bounded/contact/plane_gap.hpp"
#include "sim/solvers/bounded/kernels/kernels.hpp"

namespace taut::sim {
namespace {

using namespace bounded;

constexpr float displaced_m = 0.03F;

/// Vertices of pairs whose corners lie within `size_m`, in which numbers often repeat: parallel edges, flat triangles,
/// corners in one place.
struct Vertices {
  explicit Vertices(unsigned seed, float size_m) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> step(-2, 2);
    std::uniform_real_distribution<float> part(-1.0F, 1.0F);
    for (std::size_t row = 0; row < 4 * block_size; ++row) {
      const auto number = [&] {
        return size_m * (row % 8 < 4 ? part(random) : 0.5F * static_cast<float>(step(random)));
      };
      positions.push_back({number(), number(), number(), 0.0F});
      moves.push_back({0.1F * number(), 0.1F * number(), 0.1F * number(), 0.0F});
      normals.push_back({number(), number(), number(), row % 7 == 0 ? 0.0F : 1.0F});
      extents.push_back({0.5F + part(random), 0.01F * (1.0F + part(random)), 0.0F, 0.0F});
    }
  }
  PairRows rows() const { return {positions.data(), moves.data(), normals.data(), extents.data(), displaced_m}; }

  Float4Array positions, moves, normals, extents;
};

struct Heights {
  glm::vec3 normal;
  std::array<float, 4> of;
  float apart;
  float apart_at_end;
};

float lead(Index first_count, const std::array<float, 4>& heights) {
  const auto split = heights.begin() + first_count;
  return *std::min_element(heights.begin(), split) - *std::max_element(split, heights.end());
}

/// The loop over single pairs.
struct SinglePair {
  SinglePair(const Vertices& vertices, const NearPair& near, float thickness_m) : near(near) {
    PairExtent extent = {0.0F, 0.0F, 0.0F, displaced_m};
    for (std::size_t k = 0; k < 4; ++k) {
      const Index row = near.rows[k];
      p[k] = vec(vertices.positions[row]);
      moves[k] = vec(vertices.moves[row]);
      normals[k] = vec(vertices.normals[row]);
      are_normals_known = are_normals_known && vertices.normals[row].fourth > 0.0F;
      extent.from_origin = std::max(extent.from_origin, vertices.extents[row].x);
      extent.moved = std::max(extent.moved, vertices.extents[row].y);
      extent.across = std::max(extent.across, glm::distance(p[k], p[0]));
    }
    error = distance_error_m(extent);
    weights = closest_weights(near, p);
    const glm::vec3 line = between_closest(near, p, weights);
    heights = along(line / glm::length(line));
    if (!(heights.apart > min_resolved_fraction * glm::length(line))) {
      const Heights across = along(normal_across(line));
      heights = across.apart > heights.apart ? across : heights;
    }
    level(thickness_m);
  }

  Heights along(const glm::vec3& normal) const {
    Heights result{normal, {}, 0.0F, 0.0F};
    std::array<float, 4> at_end{};
    for (std::size_t k = 0; k < 4; ++k) {
      result.of[k] = glm::dot(normal, p[k] - p[0]);
      at_end[k] = result.of[k] + glm::dot(normal, moves[k]);
    }
    result.apart = lead(near.first_count, result.of);
    result.apart_at_end = lead(near.first_count, at_end);
    return result;
  }

  glm::vec3 normal_across(const glm::vec3& line) const {
    const glm::vec3 across =
        near.first_count == 2 ? glm::cross(p[1] - p[0], p[3] - p[2]) : glm::cross(p[2] - p[1], p[3] - p[1]);
    return (glm::dot(across, line) < 0.0F ? -1.0F : 1.0F) / glm::length(across) * across;
  }

  void level(float thickness_m) {
    const bool is_far = std::min(heights.apart, heights.apart_at_end) > collision_distance_m(thickness_m);
    if (is_far || !are_normals_known) return;
    const glm::vec3 first = near.first_count == 1 ? normals[0] : normals[0] + normals[1];
    const glm::vec3 second = near.first_count == 1 ? glm::cross(p[2] - p[1], p[3] - p[1]) : normals[2] + normals[3];
    glm::vec3 sum(0.0F);
    for (const glm::vec3& side : {first, second}) {
      sum += (glm::dot(side, heights.normal) < 0.0F ? -1.0F : 1.0F) / glm::length(side) * side;
    }
    const Heights levelled = along(sum / glm::length(sum));
    const auto lack = [&](const Heights& of) { return std::min(of.apart, thickness_m) - of.apart_at_end; };
    if (levelled.apart > 2.0F * planned_gap_m(thickness_m, error) && lack(levelled) < lack(heights)) {
      heights = levelled;
      is_levelled = true;
    }
  }

  NearPair near;
  std::array<glm::vec3, 4> p, moves, normals;
  bool are_normals_known = true;
  bool is_levelled = false;
  ClosestWeights weights;
  Heights heights;
  float error;
};

/// Counts pairs by what became of them.
struct Kinds {
  int levelled = 0;
  int touching = 0;
};

void expect_same(float number, float expected, const char* what) {
  // Both lose their digits alike.
  if (std::isnan(expected)) {
    EXPECT_TRUE(std::isnan(number)) << what;
  } else {
    EXPECT_EQ(number, expected) << what;
  }
}

void compare(const Vertices& vertices, const PairBlock& block, Index first_count, std::size_t i, Kinds& kinds) {
  NearPair near{{}, first_count};
  for (std::size_t k = 0; k < 4; ++k) near.rows[k] = block.at[k][i] / 4;
  const SinglePair single(vertices, near, block.thickness[i]);
  kinds.levelled += single.is_levelled ? 1 : 0;
  if (std::isnan(single.heights.normal.x)) {
    ++kinds.touching;
    EXPECT_FALSE(block.distance[i] > block.error[i]) << "primitives that touch have no plane";
    return;
  }
  for (int axis = 0; axis < 3; ++axis) {
    expect_same(block.normal[static_cast<std::size_t>(axis)][i], single.heights.normal[axis], "normal");
  }
  for (std::size_t k = 0; k < 4; ++k) {
    expect_same(block.heights[k][i], single.heights.of[k], "height");
    expect_same(block.weights[k][i], single.weights[k], "weight");
  }
  expect_same(block.distance[i], single.heights.apart, "distance");
  expect_same(block.error[i], single.error, "error");
}

PairBlock make_block(std::mt19937& random) {
  std::uniform_int_distribution<Index> vertex(0, 4 * block_size - 1);
  PairBlock block;
  for (std::size_t i = 0; i < block_size; ++i) {
    for (std::size_t k = 0; k < 4; ++k) block.at[k][i] = 4 * vertex(random);
    block.thickness[i] = i % 2 == 0 ? 2e-3F : 0.5F;
  }
  return block;
}

class Planes : public testing::TestWithParam<VectorUnit> {};

TEST_P(Planes, AreThoseOfLoopsOverSinglePairs) {
  const ContactKernels& kernels = kernels_for(GetParam()).contact;
  std::mt19937 random(2);
  for (const Index first_count : {Index{1}, Index{2}}) {
    const auto place = first_count == 1 ? kernels.place_triangle_planes : kernels.place_edge_planes;
    const auto measure = first_count == 1 ? kernels.measure_triangle_distances : kernels.measure_edge_distances;
    Kinds kinds;
    for (unsigned seed = 0; seed < 200; ++seed) {
      const Vertices vertices(seed, seed % 2 == 0 ? 0.02F : 1.0F);
      PairBlock block = make_block(random);
      place(vertices.rows(), block);
      for (std::size_t i = 0; i < block_size; ++i) compare(vertices, block, first_count, i, kinds);
      measure(vertices.positions.data(), block);
      for (std::size_t i = 0; i < block_size; ++i) {
        NearPair near{{}, first_count};
        std::array<glm::vec3, 4> p{};
        for (std::size_t k = 0; k < 4; ++k) {
          near.rows[k] = block.at[k][i] / 4;
          p[k] = vec(vertices.positions[near.rows[k]]);
        }
        expect_same(block.distance[i], distance_between(near, p), "shortest distance");
      }
    }
    EXPECT_GT(kinds.levelled, 10);
    EXPECT_GT(kinds.touching, 10);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Planes, testing::ValuesIn(available_vector_units()),
                         [](const auto& param) { return to_name(param.param); });

}  // namespace
}  // namespace taut::sim
