#include "job.h"

#include <chrono>
#include <set>
#include <thread>

namespace planish::python {

namespace {

/// How often Python is asked for anything. Taking its lock may make another thread wait.
constexpr auto k_interval = std::chrono::milliseconds(50);

/// The jobs of all threads that are at work. Read and written with Python's lock held.
struct AtWork {
  std::set<Job*> jobs;
  bool may_begin = true;
};

AtWork& at_work() {
  static AtWork all;
  return all;
}

/// Python's False, and NumPy's.
bool is_false(const py::object& answer) {
  if (answer.is(py::bool_(false))) return true;
  return py::getattr(py::getattr(answer, "dtype", py::none()), "kind", py::none())
             .equal(py::str("b")) &&
         !answer.cast<bool>();
}

/// Names a job among those at work.
class Entry {
 public:
  explicit Entry(Job& job) : job_(job) {
    if (!at_work().may_begin) throw Cancelled();
    at_work().jobs.insert(&job_);
  }
  ~Entry() { at_work().jobs.erase(&job_); }
  Entry(const Entry&) = delete;
  Entry& operator=(const Entry&) = delete;

 private:
  Job& job_;
};

}  // namespace

void end_jobs() {
  at_work().may_begin = false;
  while (!at_work().jobs.empty()) {
    for (Job* const job : at_work().jobs)
      job->cancelled_ = true;
    const py::gil_scoped_release no_python;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

Job::Job(const cli::Arguments& arguments, py::object on_progress)
    : on_progress_(std::move(on_progress)),
      context_{.interrupted = &cancelled_,
               .on_progress = [this](const Progress& progress) { post(progress); }},
      session_(arguments, said_, context_) {
  if (!on_progress_.is_none() && !PyCallable_Check(on_progress_.ptr()))
    throw py::type_error("progress must be a function, or None");
}

void Job::post(const Progress& progress) {
  const std::scoped_lock lock(mutex_);
  latest_ = Step{std::string(progress.stage), progress.share, std::string(progress.subject)};
  changed_.notify_all();
}

void Job::attend(const std::optional<Step>& step) {
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!step || on_progress_.is_none()) return;
    const py::object answer = on_progress_(step->stage, step->share, step->subject);
    if (is_false(answer)) cancelled_ = true;
  } catch (py::error_already_set& error) {
    own_.emplace(std::move(error));
    cancelled_ = true;
  }
}

void Job::in_python(const std::function<void()>& call) {
  std::unique_lock lock(mutex_);
  call_ = &call;
  changed_.notify_all();
  changed_.wait(lock, [&] { return call_ == nullptr; });
  if (cancelled_) throw Cancelled();
}

void Job::make(const std::function<void()>& call) {
  try {
    call();
  } catch (py::error_already_set& error) {
    own_.emplace(std::move(error));
    cancelled_ = true;
  } catch (...) {
    of_call_ = std::current_exception();
    cancelled_ = true;
  }
}

void Job::wait() {
  auto next = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  while (!done_) {
    changed_.wait_for(lock, k_interval, [&] {
      return done_ || call_ != nullptr || (latest_ && std::chrono::steady_clock::now() >= next);
    });
    const std::optional<Step> step = std::exchange(latest_, std::nullopt);
    if (cancelled_ || (done_ && !step)) {
      call_ = nullptr;
      changed_.notify_all();
      continue;
    }
    const std::function<void()>* const call = call_;
    lock.unlock();
    {
      const py::gil_scoped_acquire python;
      attend(step);
      if (call != nullptr && !cancelled_) make(*call);
    }
    next = std::chrono::steady_clock::now() + k_interval;
    lock.lock();
    if (call == nullptr) continue;
    call_ = nullptr;
    changed_.notify_all();
  }
}

void Job::run_on_thread(const std::function<void(cli::Session&)>& work) {
  const Entry entry(*this);
  done_ = false;
  latest_.reset();
  of_call_ = nullptr;
  {
    const py::gil_scoped_release no_python;
    std::thread worker([&] {
      try {
        work(session_);
      } catch (...) {
        failure_ = std::current_exception();
      }
      const std::scoped_lock lock(mutex_);
      done_ = true;
      changed_.notify_all();
    });
    wait();
    worker.join();
  }
  if (own_) throw py::error_already_set(std::move(*own_));
  if (of_call_) std::rethrow_exception(std::exchange(of_call_, nullptr));
  if (cancelled_) throw Cancelled();
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  take_notes();
}

void Job::take_notes() {
  std::istringstream lines(said_.str());
  said_.str({});
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(": ");
    const std::string words = colon == std::string::npos ? line : line.substr(colon + 2);
    notes_.push_back(words);
    if (!line.starts_with("warning: ")) continue;
    if (PyErr_WarnEx(PyExc_UserWarning, words.c_str(), 1) != 0) throw py::error_already_set();
  }
}

}  // namespace planish::python
