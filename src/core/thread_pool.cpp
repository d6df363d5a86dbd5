#include "core/thread_pool.h"

#include <algorithm>
#include <new>
#include <system_error>
#include <utility>

#include "platform/processors.h"

namespace planish {

unsigned thread_count(const Context& context) {
  return context.threads == 0 ? usable_processors() : context.threads;
}

ThreadPool::ThreadPool(unsigned threads) {
  if (threads == 0) threads = usable_processors();
  workers_.reserve(threads - 1);
  try {
    for (unsigned i = 1; i < threads; ++i)
      workers_.emplace_back([this] { work(); });
  } catch (const std::system_error&) {
    // The system gives no more threads: those at hand do the same work.
  } catch (const std::bad_alloc&) {
    // Nor has it the memory for them.
  }
}

ThreadPool::ThreadPool(const Context& context) : ThreadPool(context.threads) {
  is_cancelled_ = context.is_cancelled;
  on_progress_ = context.on_progress;
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_all();
  for (std::thread& worker : workers_)
    worker.join();
}

void ThreadPool::for_ranges(std::size_t count, std::size_t grain,
                            const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  stop_if_cancelled();
  if (count < 2 * grain) return body(0, count);
  std::unique_lock lock(mutex_);
  body_ = &body;
  count_ = count;
  next_ = 0;
  // Some parts a thread, so that none waits long for the last one.
  part_ = std::max(grain, count / (16 * size()));
  wake_.notify_all();
  run_parts(lock);
  done_.wait(lock, [this] { return busy_ == 0; });
  body_ = nullptr;
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void ThreadPool::stop_if_cancelled() const {
  if (is_cancelled_ && is_cancelled_()) throw Cancelled();
}

void ThreadPool::report(double share) const {
  if (on_progress_) on_progress_({{}, share});
  stop_if_cancelled();
}

void ThreadPool::run_parts(std::unique_lock<std::mutex>& lock) {
  ++busy_;
  while (next_ < count_) {
    const std::size_t begin = next_;
    const std::size_t end = next_ = std::min(count_, begin + part_);
    lock.unlock();
    std::exception_ptr failure;
    try {
      stop_if_cancelled();
      (*body_)(begin, end);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    if (!failure) continue;
    if (!failure_) failure_ = failure;
    next_ = count_;  // what has not begun is left
  }
  if (--busy_ == 0) done_.notify_one();
}

void ThreadPool::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    wake_.wait(lock, [this] { return stopping_ || (body_ != nullptr && next_ < count_); });
    if (stopping_) return;
    run_parts(lock);
  }
}

}  // namespace planish
