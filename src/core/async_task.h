#pragma once

#include <future>
#include <system_error>
#include <type_traits>

#include "platform/processors.h"

namespace planish {

/// Starts a task on a thread of its own; an invalid future where the system has no thread to give,
/// or one processor: where threads are missing altogether, as in a browser, std::async() of libc++
/// would wait for ever.
template <class Task>
std::future<std::invoke_result_t<Task>> run_async(const Task& task) {
  if (usable_processors() < 2) return {};
  try {
    return std::async(std::launch::async, task);
  } catch (const std::system_error&) {
    return {};
  }
}

/// A result of a task that is worked on at the same time where there are threads for it, or else
/// when it is asked for. The task's data must outlive this.
template <class Task>
class AsyncTask {
 public:
  AsyncTask(bool at_once, const Task& task) : task_(task) {
    if (at_once) future_ = run_async(task);
  }

  /// To be asked for once. Throws what the task throws.
  std::invoke_result_t<Task> result() { return future_.valid() ? future_.get() : task_(); }

 private:
  Task task_;
  std::future<std::invoke_result_t<Task>> future_;
};

}  // namespace planish
