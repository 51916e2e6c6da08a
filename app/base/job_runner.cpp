#include "app/base/job_runner.hpp"

#include <atomic>

#include "app/base/errors.hpp"
#include "app/base/progress.hpp"

namespace taut::app {
namespace {

// Thrown from a job's progress callback after another job has failed; not an error of its own.
struct GivenUp {};

std::vector<std::size_t> most_expensive_first(std::span<const Job> jobs) {
  std::vector<std::size_t> order(jobs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return jobs[a].cost > jobs[b].cost; });
  return order;
}

class JobRunner {
 public:
  explicit JobRunner(std::span<const Job> jobs)
      : jobs_(jobs), order_(most_expensive_first(jobs)), fractions_(jobs.size()) {}

  ~JobRunner() {
    stop_ = true;
    threads_.clear();
  }

  void run(unsigned thread_count, const std::function<void(std::size_t)>& finished) {
    for (unsigned i = 0; i < std::min<std::size_t>(std::max(1U, thread_count), jobs_.size()); ++i) {
      threads_.emplace_back([this] { work(); });
    }
    for (std::size_t handled = 0; handled < jobs_.size(); ++handled) {
      const std::size_t job = next_finished();
      progress_.hide();
      finished(job);
    }
  }

 private:
  void work() {
    for (std::size_t turn = next_++; turn < order_.size() && !stop_; turn = next_++) {
      const std::size_t job = order_[turn];
      try {
        jobs_[job].work([this, job](double fraction) {
          fractions_[job] = fraction;
          if (stop_) throw GivenUp{};
        });
        fractions_[job] = 1.0;
        note([&] { finished_.push_back(job); });
      } catch (const GivenUp&) {
        return;
      } catch (...) {
        note([&] { error_ = error_ ? error_ : std::current_exception(); });
        stop_ = true;
        return;
      }
    }
  }

  template <class Change> void note(const Change& change) {
    {
      const std::lock_guard lock(mutex_);
      change();
    }
    changed_.notify_one();
  }

  std::size_t next_finished() {
    std::unique_lock lock(mutex_);
    while (finished_.empty() && !error_) {
      changed_.wait_for(lock, std::chrono::milliseconds(100));
      throw_if_interrupted();
      show_progress();
    }
    if (error_) std::rethrow_exception(error_);
    const std::size_t job = finished_.front();
    finished_.pop_front();
    return job;
  }

  void show_progress() {
    double done = 0.0, all = 0.0;
    std::string busy;
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const double fraction = fractions_[i];
      done += jobs_[i].cost * fraction;
      all += jobs_[i].cost;
      if (fraction > 0.0 && fraction < 1.0) busy += fmt::format("  {} {:.0f} %", jobs_[i].name, 100.0 * fraction);
    }
    progress_.show(fmt::format("{:.0f} % simulated{}", all > 0.0 ? 100.0 * done / all : 100.0, busy));
  }

  Progress progress_{"figures"};
  std::span<const Job> jobs_;
  std::vector<std::size_t> order_;
  std::vector<std::atomic<double>> fractions_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::size_t> finished_;
  std::exception_ptr error_;
  // Declared last, so that the threads end before the members that they use.
  std::vector<std::jthread> threads_;
};

}  // namespace

void run_jobs(std::span<const Job> jobs, unsigned threads, const std::function<void(std::size_t)>& finished) {
  JobRunner(jobs).run(threads, finished);
}

}  // namespace taut::app
