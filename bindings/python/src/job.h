#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include "shell/command.h"
#include "shell/run_context.h"
#include "shell/session.h"

namespace planish::python {

namespace py = pybind11;

/// Runs work of the program for Python: on a thread of its own and without Python's lock. The
/// calling thread alone calls Python: it waits, hands on progress, makes the calls that the work
/// asks for, and looks for Ctrl-C.
class Job {
 public:
  /// @param arguments with --threads, if that was given
  /// @param on_progress called with stage, share and subject; where it returns False or throws, the
  ///   work is cancelled. None for nothing
  Job(const cli::Arguments& arguments, py::object on_progress);

  /// What the work returns.
  /// @param work called with the session, on another thread; must not call Python
  /// @throws what the work or Python throws; Cancelled
  template <class Work>
  auto run(Work&& work) {
    std::optional<std::invoke_result_t<Work, cli::Session&>> result;
    run_on_thread([&](cli::Session& session) { result.emplace(work(session)); });
    return std::move(*result);
  }

  /// For the work, on its thread: has the calling thread do this with Python's lock, and waits.
  /// What Python raises there, run() throws on.
  /// @throws Cancelled where that raised something, or the work was cancelled
  void in_python(const std::function<void()>& call);

  /// What the program said while it worked; warnings are also Python's.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  struct Step {
    std::string stage;
    double share = 0.0;
    std::string subject;
  };

  friend void end_jobs();

  void run_on_thread(const std::function<void(cli::Session&)>& work);
  void wait();
  /// Calls Python, with its lock held.
  void attend(const std::optional<Step>& step);
  void make(const std::function<void()>& call);
  void post(const Progress& progress);
  void take_notes();

  py::object on_progress_;
  std::ostringstream said_;
  std::atomic<bool> cancelled_ = false;
  cli::RunContext context_;
  cli::Session session_;
  std::vector<std::string> notes_;

  std::mutex mutex_;  // of the members below
  std::condition_variable changed_;
  bool done_ = false;
  std::optional<Step> latest_;
  const std::function<void()>* call_ = nullptr;  // that the work waits for
  std::exception_ptr failure_;                   // of the work
  std::exception_ptr of_call_;                   // of a call
  std::optional<py::error_already_set> own_;     // that Python raised in the calling thread
};

/// Cancels all jobs and waits for their threads, for Python's end: behind it no thread gets
/// Python's lock any more. No job can begin from then on.
void end_jobs();

}  // namespace planish::python
