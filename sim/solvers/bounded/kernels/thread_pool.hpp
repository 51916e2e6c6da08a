#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace taut::sim::bounded {

/// Division of the work of shared loops.
struct PoolWork {
  std::size_t own_chunks = 0;  ///< chunks done by the caller
  /// Chunks done by other threads.
  std::size_t others_chunks = 0;
  /// Time that the caller waited for chunks of other threads.
  double waited_s = 0.0;
};

/// Threads that share one loop at a time. A loop is cut into chunks, and every free thread takes the next one. A chunk
/// must not touch what other chunks write, so the number of threads changes nothing but the time.
///
/// A loop lasts some microseconds and a frame has thousands of them, so the caller never waits for a thread to begin:
/// if a thread gets no processor, the others do its chunks. The caller does wait for a thread that loses its processor
/// in the middle of a chunk (see ThreadChoice).
class ThreadPool {
 public:
  /// Starts `threads` - 1 threads: the caller is one of them.
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  /// Sets whether loops are shared from now on. If not, the caller does them alone.
  void share(bool is_shared) { is_shared_ = is_shared; }

  /// Returns the work since the last call of this function.
  PoolWork take_work() { return std::exchange(work_, {}); }

  /// Calls part(b, e) for chunks that together cover [begin, end) and returns when all are done. Each chunk
  /// has at least `least` elements, which must be above 0. `part` must not throw.
  template <typename Part> void split(std::size_t begin, std::size_t end, std::size_t least, const Part& part) {
    if (workers_.empty() || !is_shared_ || end - begin < 2 * least) {
      part(begin, end);
      return;
    }
    run([](const void* context, std::size_t b, std::size_t e) { (*static_cast<const Part*>(context))(b, e); }, &part,
        begin, end, least);
  }

 private:
  using Call = void (*)(const void* context, std::size_t begin, std::size_t end);

  void run(Call call, const void* context, std::size_t begin, std::size_t end, std::size_t least);
  void wait_for(std::size_t chunks);
  void work();
  bool do_chunk();

  /// Current loop. A late thread may read it while the next loop is being written, but then it fails to claim a chunk.
  std::atomic<Call> call_{nullptr};
  std::atomic<const void*> context_{nullptr};
  std::atomic<std::size_t> begin_{0};
  std::atomic<std::size_t> end_{0};
  std::atomic<std::size_t> chunk_count_{0};

  /// Number of the loop; the low 32 bits are the next chunk to take.
  std::atomic<std::uint64_t> claim_{0};
  std::atomic<std::size_t> done_{0};  ///< chunks that are finished
  std::atomic<bool> is_over_{false};
  // Used by the caller only.
  bool is_shared_ = true;
  PoolWork work_;
  std::vector<std::thread> workers_;
};

/// Returns the number of threads: `asked` if given. Otherwise 1 below 8000 triangles, where a thread's part of a loop
/// is done before another thread wakes up, and above that as many as the processor has, up to 4: more would only wait
/// for memory.
int thread_count(std::optional<int> asked, std::size_t triangles);

}  // namespace taut::sim::bounded
