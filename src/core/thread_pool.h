#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include <planish/core/context.h>

namespace planish {

/// How many threads a job uses: those asked for, else usable_processors().
unsigned thread_count(const Context& context);

/// A few threads that sleep until a loop is handed to them. Which thread does which part never
/// shows in the result as long as the parts are independent.
class ThreadPool {
 public:
  /// @param threads 0 for usable_processors()
  explicit ThreadPool(unsigned threads);
  /// A pool whose loops end early once the job is cancelled.
  explicit ThreadPool(const Context& context);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  /// Ends the job if it is cancelled: for long work outside loops.
  /// @throws Cancelled
  void stop_if_cancelled() const;

  /// Tells the job how much of its present step is done, 0 to 1. From the thread of the job.
  /// @throws Cancelled
  void report(double share) const;

  unsigned size() const { return static_cast<unsigned>(workers_.size()) + 1; }

  /// Calls body(begin, end) for consecutive parts of [0, count) and returns when all are done. The
  /// caller works too; fewer than two grains of work are done by the caller alone.
  /// What a part throws is thrown on when the parts that have begun are done; the rest is left.
  /// @throws Cancelled
  void for_ranges(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body);

 private:
  void work();
  void run_parts(std::unique_lock<std::mutex>& lock);

  std::function<bool()> is_cancelled_;
  std::function<void(const Progress&)> on_progress_;
  std::vector<std::thread> workers_;
  std::mutex mutex_;
  std::condition_variable wake_, done_;
  const std::function<void(std::size_t, std::size_t)>* body_ = nullptr;
  std::size_t count_ = 0, part_ = 0, next_ = 0, busy_ = 0;
  std::exception_ptr failure_;
  bool stopping_ = false;
};

}  // namespace planish
