#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <random>
#include <vector>

#include "sim/solvers/bounded/team.hpp"
#include "sim/solvers/bounded/thread_choice.hpp"

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

/// What frames cost, alone and shared, over what they would cost alone; `cost` of a frame's number.
double part_of_alone(int frames, const std::function<double(int frame, bool shared)>& cost) {
  ThreadChoice choice;
  double sum = 0.0, alone = 0.0;
  for (int frame = 0; frame < frames; ++frame) {
    const double took = cost(frame, choice.is_shared());
    sum += took;
    alone += cost(frame, false);
    choice.frame_took(took);
  }
  return sum / alone;
}

TEST(ThreadChoice, SharesWhereThatIsFaster) {
  EXPECT_LT(part_of_alone(300, [](int, bool shared) { return shared ? 0.6 : 1.0; }), 0.62);
}

TEST(ThreadChoice, NeverTakesATenthLongerThanAlone) {
  EXPECT_LT(part_of_alone(100, [](int, bool shared) { return shared ? 2.0 : 1.0; }), 1.06);
  EXPECT_LT(part_of_alone(1000, [](int, bool shared) { return shared ? 5.0 : 1.0; }), 1.1);
}

TEST(ThreadChoice, FollowsAMachineThatGetsBusyAndIdleAgain) {
  const auto is_busy = [](int frame) { return frame >= 200 && frame < 600; };
  const auto cost = [&](int frame, bool shared) { return shared ? (is_busy(frame) ? 3.0 : 0.6) : 1.0; };
  EXPECT_LT(part_of_alone(600, cost), (200 * 0.6 + 400 * 1.1) / 600);
  EXPECT_LT(part_of_alone(3000, cost), (2600 * 0.7 + 400 * 1.1) / 3000) << "it tries again";
}

TEST(ThreadChoice, IsNotLedAstrayByNoise) {
  std::minstd_rand random(7);
  std::uniform_real_distribution<double> noise(1.0, 1.5);
  EXPECT_LT(part_of_alone(1000, [&](int, bool shared) { return (shared ? 0.6 : 1.0) * noise(random); }),
            0.68);
  EXPECT_LT(part_of_alone(1000, [&](int, bool shared) { return (shared ? 1.6 : 1.0) * noise(random); }), 1.1);
}

}  // namespace
}  // namespace taut::sim::bounded
