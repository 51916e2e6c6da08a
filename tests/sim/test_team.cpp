#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "sim/solvers/bounded/team.hpp"

namespace taut::sim::bounded {
namespace {

TEST(Team, EveryElementIsWorkedOnOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    Team team(threads);
    for (int loop = 0; loop < 2000; ++loop) {
      const std::size_t begin = static_cast<std::size_t>(loop % 7);
      const std::size_t end = begin + static_cast<std::size_t>(loop * 37 % 501);
      std::vector<int> touched(600, 0);
      team.split(begin, end, 5, [&](std::size_t b, std::size_t e) {
        for (std::size_t k = b; k < e; ++k) {
          ++touched[k];
        }
      });
      for (std::size_t k = 0; k < touched.size(); ++k) {
        ASSERT_EQ(touched[k], k >= begin && k < end ? 1 : 0) << threads << ' ' << loop << ' ' << k;
      }
    }
  }
}

TEST(Team, ChunksAreNotSmallerThanAskedFor) {
  Team team(4);
  std::vector<std::size_t> size_of_chunk_at(1000, 0);
  team.split(0, 1000, 90, [&](std::size_t b, std::size_t e) { size_of_chunk_at[b] = e - b; });
  std::size_t total = 0;
  for (const std::size_t size : size_of_chunk_at) {
    EXPECT_TRUE(size == 0 || size >= 90) << size;
    total += size;
  }
  EXPECT_EQ(total, 1000u);
}

TEST(Team, SmallGarmentsGetOneThreadUnlessAskedOtherwise) {
  EXPECT_EQ(thread_count(0, 1000), 1);
  EXPECT_EQ(thread_count(3, 1000), 3);
  EXPECT_GE(thread_count(0, 100000), 1);
  EXPECT_LE(thread_count(0, 100000), 4);
}

}  // namespace
}  // namespace taut::sim::bounded
