#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace planish {

/// What threads hand to the one that takes it. There is room for all from the beginning: handing on
/// must not fail, as the one that takes would wait for ever.
template <class Item>
class Handover {
 public:
  explicit Handover(std::size_t count) { items_.reserve(count); }

  void put(Item item) {
    const std::lock_guard lock(mutex_);
    items_.push_back(std::move(item));
    arrived_.notify_one();
  }
  Item take() {
    std::unique_lock lock(mutex_);
    arrived_.wait(lock, [&] { return taken_ < items_.size(); });
    return std::move(items_[taken_++]);
  }

 private:
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::vector<Item> items_;
  std::size_t taken_ = 0;
};

/// Threads that are waited for also where the one that started them fails; then with less to do.
class Workers {
 public:
  /// @param abandoned set when this ends; threads see it and end
  explicit Workers(std::atomic<bool>& abandoned) : abandoned_(abandoned) {}
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers() {
    abandoned_ = true;  // by now all is done, or nothing of the rest is taken
    for (std::thread& worker : threads_)
      worker.join();
  }

  /// Starts so many, or fewer where the system has no more to give.
  template <class Work>
  void start(std::size_t count, const Work& work) {
    threads_.reserve(count);
    try {
      while (threads_.size() < count)
        threads_.emplace_back(work);
    } catch (const std::system_error&) {
      // Those that there are do the work.
    } catch (const std::bad_alloc&) {
      // There is no memory for one more.
    }
  }
  bool empty() const { return threads_.empty(); }

 private:
  std::atomic<bool>& abandoned_;
  std::vector<std::thread> threads_;
};

}  // namespace planish
