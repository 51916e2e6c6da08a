#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace taut::sim::bounded {

/// Who did what of the loops that were shared.
struct PoolWork {
  std::size_t own_chunks = 0;  ///< of the caller
  std::size_t others_chunks = 0;
  double waited_s = 0.0;  ///< by the caller, for chunks that others had begun
};

/// Threads that share one loop at a time. A loop is cut into chunks, which whoever is free takes; only loops
/// belong here whose chunks do not touch what others write, so that the number of threads changes nothing but
/// the time.
///
/// A loop lasts some microseconds and thousands of them make a frame. So the caller never waits for a thread
/// to begin: one that does not get a processor leaves its chunks to the others. It does wait for one that
/// loses its processor in the middle of a chunk (see ThreadChoice).
class ThreadPool {
 public:
  /// The caller is one of the threads: 1 starts none.
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  /// Whether loops are shared from now on, or the caller does them alone.
  void share(bool is_shared) { is_shared_ = is_shared; }

  /// Since the last call of this.
  PoolWork take_work() { return std::exchange(work_, {}); }

  /// Calls part(b, e) for chunks that cover [begin, end), of at least `least` each, and returns when all are
  /// done. `part` must not throw.
  template <typename Part>
  void split(std::size_t begin, std::size_t end, std::size_t least, const Part& part) {
    if (workers_.empty() || !is_shared_ || end - begin < 2 * least) {
      part(begin, end);
      return;
    }
    run([](const void* context, std::size_t b, std::size_t e) { (*static_cast<const Part*>(context))(b, e); },
        &part, begin, end, least);
  }

 private:
  using Call = void (*)(const void* context, std::size_t begin, std::size_t end);

  void run(Call call, const void* context, std::size_t begin, std::size_t end, std::size_t least);
  void wait_for(std::size_t chunks);
  void work();
  bool do_chunk();

  /// The loop now being run. A thread that is late may read it while the next is written, but then its claim
  /// of a chunk fails.
  std::atomic<Call> call_{nullptr};
  std::atomic<const void*> context_{nullptr};
  std::atomic<std::size_t> begin_{0};
  std::atomic<std::size_t> end_{0};
  std::atomic<std::size_t> chunk_count_{0};

  std::atomic<std::uint64_t> claim_{0};  ///< the loop's number, and in the low 32 bits the next chunk to take
  std::atomic<std::size_t> done_{0};     ///< chunks
  std::atomic<bool> is_over_{false};
  // The caller's own.
  bool is_shared_ = true;
  PoolWork work_;
  std::vector<std::thread> workers_;
};

/// As asked for, or else as many as pay: one below some 20 000 triangles, where a thread's share of a loop
/// is gone before another has woken, and no more than 4, as loops wait for memory then.
int thread_count(std::optional<int> asked, std::size_t triangles);

}  // namespace taut::sim::bounded
