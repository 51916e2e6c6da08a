#include "sim/solvers/bounded/kernels/thread_pool.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>

namespace taut::sim::bounded {
namespace {

/// Polls of a thread for another loop before it sleeps, and of the caller for the end of a chunk before it yields. They
/// take some tens of microseconds, the time between two loops. Higher values use a processor that others could use.
constexpr int max_polls = 4000;
/// Chunks per thread. Higher values balance threads of different speed better but cost more claims.
constexpr std::size_t chunks_per_thread = 3;
/// Smallest number of triangles for several threads, and the largest default number of threads; see thread_count.
constexpr std::size_t triangles_worth_threads = 8000;
constexpr int max_default_threads = 4;

/// Unit of the loop's number in claim_; the low bits are the next chunk. In them `closed` means that no chunk is left.
constexpr std::uint64_t one_loop = std::uint64_t{1} << 32U;
constexpr std::uint64_t closed = one_loop - 1;

void pause() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

ThreadPool::ThreadPool(int threads) {
  assert(threads > 0);
  for (int member = 1; member < threads; ++member) workers_.emplace_back([this] { work(); });
}

ThreadPool::~ThreadPool() {
  is_over_.store(true, std::memory_order_relaxed);
  claim_.fetch_add(one_loop, std::memory_order_release);
  claim_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::run(Call call, const void* context, std::size_t begin, std::size_t end, std::size_t least) {
  assert(begin <= end);
  assert(least > 0);
  const std::size_t chunks = std::min((end - begin) / least, chunks_per_thread * (workers_.size() + 1));
  const std::uint64_t loop = claim_.load(std::memory_order_relaxed) / one_loop;
  claim_.store(loop * one_loop + closed, std::memory_order_relaxed);
  call_.store(call, std::memory_order_release);
  context_.store(context, std::memory_order_release);
  begin_.store(begin, std::memory_order_release);
  end_.store(end, std::memory_order_release);
  chunk_count_.store(chunks, std::memory_order_release);
  done_.store(0, std::memory_order_relaxed);
  claim_.store((loop + 1) * one_loop, std::memory_order_release);
  claim_.notify_all();
  std::size_t own_chunks = 0;
  while (do_chunk()) ++own_chunks;
  work_.own_chunks += own_chunks;
  work_.others_chunks += chunks - own_chunks;
  if (done_.load(std::memory_order_acquire) != chunks) wait_for(chunks);
}

void ThreadPool::wait_for(std::size_t chunks) {
  const auto began = std::chrono::steady_clock::now();
  for (int looks = 0; done_.load(std::memory_order_acquire) != chunks; ++looks) {
    if (looks < max_polls) {
      pause();
    } else {
      std::this_thread::yield();
    }
  }
  work_.waited_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

void ThreadPool::work() {
  for (;;) {
    const std::uint64_t before = claim_.load(std::memory_order_acquire);
    while (do_chunk()) {
    }
    if (is_over_.load(std::memory_order_relaxed)) return;
    const auto is_same_loop = [&] { return claim_.load(std::memory_order_acquire) / one_loop == before / one_loop; };
    int looks = 0;
    while (looks < max_polls && is_same_loop()) {
      pause();
      ++looks;
    }
    if (const std::uint64_t now = claim_.load(std::memory_order_acquire); now / one_loop == before / one_loop) {
      claim_.wait(now, std::memory_order_acquire);
    }
  }
}

/// Claims and does one chunk. Returns false if no chunk is left.
bool ThreadPool::do_chunk() {
  std::uint64_t claim = claim_.load(std::memory_order_acquire);
  for (;;) {
    const Call call = call_.load(std::memory_order_acquire);
    const void* context = context_.load(std::memory_order_acquire);
    const std::size_t begin = begin_.load(std::memory_order_acquire);
    const std::size_t end = end_.load(std::memory_order_acquire);
    const std::size_t chunks = chunk_count_.load(std::memory_order_acquire);
    const std::size_t chunk = claim % one_loop;
    if (chunk >= chunks) return false;
    // Claims of this loop are closed before any of these values is written for the next loop. So if this
    // exchange succeeds, all values are of this loop.
    if (claim_.compare_exchange_weak(claim, claim + 1, std::memory_order_acq_rel, std::memory_order_acquire)) {
      const std::size_t count = end - begin;
      call(context, begin + count * chunk / chunks, begin + count * (chunk + 1) / chunks);
      done_.fetch_add(1, std::memory_order_release);
      return true;
    }
  }
}

int thread_count(std::optional<int> asked, std::size_t triangles) {
  if (asked) return *asked;
  const int processors = static_cast<int>(std::thread::hardware_concurrency());
  return triangles < triangles_worth_threads ? 1 : std::clamp(processors, 1, max_default_threads);
}

}  // namespace taut::sim::bounded
