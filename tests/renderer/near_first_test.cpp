#include "renderer/near_first.hpp"

#include <gtest/gtest.h>

#include <array>

namespace taut::renderer {
namespace {

constexpr std::array<glm::vec3, 9> three{{{0, 0, -5},
                                          {1, 0, -5},
                                          {0, 1, -5},
                                          {0, 0, 2},
                                          {1, 0, 2},
                                          {0, 1, 2},
                                          {0, 0, -5},
                                          {1, 0, -5},
                                          {0, 1, -5}}};
constexpr std::array<std::uint32_t, 9> indices{0, 1, 2, 3, 4, 5, 6, 7, 8};

TEST(NearFirst, TheNearestComesFirstAndEqualsKeepTheirOrder) {
  std::vector<std::uint32_t> ordered;
  near_first(three, indices, {0, 0, 9}, ordered);
  EXPECT_EQ(ordered, (std::vector<std::uint32_t>{3, 4, 5, 0, 1, 2, 6, 7, 8}));
  near_first(three, indices, {0, 0, -9}, ordered);
  EXPECT_EQ(ordered, (std::vector<std::uint32_t>{0, 1, 2, 6, 7, 8, 3, 4, 5}));
}

TEST(NearFirst, NothingStaysNothing) {
  std::vector<std::uint32_t> ordered{7};
  near_first({}, {}, {}, ordered);
  EXPECT_TRUE(ordered.empty());
}

}  // namespace
}  // namespace taut::renderer
