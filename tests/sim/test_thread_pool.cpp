#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

#include "sim/solvers/bounded/kernels/thread_pool.hpp"
#include "sim/solvers/bounded/thread_choice.hpp"

namespace taut::sim::bounded {
namespace {

TEST(ThreadPool, EveryElementIsWorkedOnOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    ThreadPool pool(threads);
    for (int loop = 0; loop < 2000; ++loop) {
      const std::size_t begin = static_cast<std::size_t>(loop % 7);
      const std::size_t end = begin + static_cast<std::size_t>(loop * 37 % 501);
      std::vector<int> touched(600, 0);
      pool.split(begin, end, 5, [&](std::size_t b, std::size_t e) {
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

TEST(ThreadPool, ChunksAreNotSmallerThanAskedFor) {
  ThreadPool pool(4);
  std::vector<std::size_t> size_of_chunk_at(1000, 0);
  pool.split(0, 1000, 90, [&](std::size_t b, std::size_t e) { size_of_chunk_at[b] = e - b; });
  std::size_t total = 0;
  for (const std::size_t size : size_of_chunk_at) {
    EXPECT_TRUE(size == 0 || size >= 90) << size;
    total += size;
  }
  EXPECT_EQ(total, 1000u);
}

TEST(ThreadPool, SmallGarmentsGetOneThreadUnlessAskedOtherwise) {
  EXPECT_EQ(thread_count({}, 1000), 1);
  EXPECT_EQ(thread_count(3, 1000), 3);
  EXPECT_GE(thread_count({}, 100000), 1);
  EXPECT_LE(thread_count({}, 100000), 4);
}

TEST(ThreadPool, ReportsWhoDidTheWork) {
  for (const int threads : {1, 2, 4}) {
    ThreadPool pool(threads);
    std::atomic<std::size_t> chunks = 0;
    for (int loop = 0; loop < 500; ++loop) {
      pool.split(0, 400, 10, [&](std::size_t, std::size_t) { ++chunks; });
    }
    const PoolWork work = pool.take_work();
    EXPECT_EQ(work.own_chunks + work.others_chunks, threads > 1 ? chunks.load() : 0u);
    EXPECT_GE(work.waited_s, 0.0);
    EXPECT_EQ(pool.take_work().own_chunks, 0u) << "it was taken";
    pool.share(false);
    pool.split(0, 400, 10, [&](std::size_t, std::size_t) { ++chunks; });
    EXPECT_EQ(pool.take_work().own_chunks, 0u);
  }
}

/// Returns the mean duration of frames of one second of work, in parts of the caller's time alone. The other threads do
/// as much as the caller, which then waits for them that long.
double part_of_alone(int frames, const std::function<double(int frame)>& waited_s) {
  ThreadChoice choice;
  double sum = 0.0;
  for (int frame = 0; frame < frames; ++frame) {
    if (choice.is_shared()) {
      const double took = 0.5 + waited_s(frame);
      sum += took;
      choice.frame_took(took, {10, 10, waited_s(frame)});
    } else {
      sum += 1.0;
      choice.frame_took(1.0, {});
    }
  }
  return sum / frames;
}

TEST(ThreadChoice, SharesIfThatIsFaster) {
  EXPECT_NEAR(part_of_alone(300, [](int) { return 0.1; }), 0.6, 1e-9);
  EXPECT_NEAR(part_of_alone(300, [](int) { return 0.4; }), 0.9, 1e-9);
}

TEST(ThreadChoice, NeverTakesATenthLongerThanAlone) {
  for (const double waited_s : {0.6, 1.5, 3.0}) {
    EXPECT_LT(part_of_alone(100, [=](int) { return waited_s; }), 1.1) << waited_s;
    EXPECT_LT(part_of_alone(3000, [=](int) { return waited_s; }), 1.03) << waited_s;
  }
}

TEST(ThreadChoice, FollowsAMachineThatGetsBusyAndIdleAgain) {
  const auto waited_s = [](int frame) { return frame >= 200 && frame < 600 ? 2.0 : 0.1; };
  EXPECT_LT(part_of_alone(600, waited_s), (200 * 0.6 + 400 * 1.1) / 600);
  EXPECT_LT(part_of_alone(3000, waited_s), (2600 * 0.7 + 400 * 1.1) / 3000) << "it tries again";
}

TEST(ThreadChoice, GoesOnSharingOnAMachineThatIsSometimesBusy) {
  EXPECT_LT(part_of_alone(3000, [](int frame) { return frame % 10 == 0 ? 2.0 : 0.1; }), 1.1);
}

}  // namespace
}  // namespace taut::sim::bounded
