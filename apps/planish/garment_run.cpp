#include "garment_run.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

#include <planish/platform/path.h>

namespace planish::cli {

namespace {

FlattenedPatch flatten_patch(const GarmentJob& job, std::size_t number,
                             const std::function<bool()>& stopped) {
  const GarmentPatch& patch = job.patches[number];
  FlattenedPatch done;
  try {
    if (patch.failure) throw Error(*patch.failure);
    FlattenOptions options = job.options;
    options.threads = 1;
    options.keep = named_vertices(job.furniture[number]);
    auto report =
        flatten(patch.mesh, patch.name, options, [&](FlattenStage, double) { return !stopped(); });
    if (!report) return done;
    done.files = job.files_of(*report, patch.format, job.furniture[number],
                              job.folder / path_of(patch.folder));
    done.mesh = std::move(report->processed);
    done.pattern = std::move(report->unfold.pattern.positions);
  } catch (...) {
    done = {};
    done.failure = current_failure();
  }
  return done;
}

/// What threads hand to the one that writes. There is room for all from the beginning: handing on
/// must not fail, as the one that writes would wait for ever.
class Finished {
 public:
  using Item = std::pair<std::size_t, FlattenedPatch>;

  explicit Finished(std::size_t count) { items_.reserve(count); }

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
  explicit Workers(std::atomic<bool>& cancelled) : cancelled_(cancelled) {}
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers() {
    cancelled_ = true;  // by now all is done, or nobody takes what is left
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
  std::atomic<bool>& cancelled_;
  std::vector<std::thread> threads_;
};

}  // namespace

PatchFailure current_failure() try {
  try {
    throw;
  } catch (const Error& error) {
    return {std::string(to_string(error.code())), error.what()};
  } catch (const std::bad_alloc&) {
    return {"out_of_memory", "out of memory"};
  } catch (const std::exception& error) {
    return {"internal_error", error.what()};
  }
} catch (const std::bad_alloc&) {  // not even for the words
  return {"out_of_memory", "out of memory"};
}

void flatten_patches(const GarmentJob& job, std::vector<std::size_t> numbers, unsigned threads,
                     const std::function<bool()>& interrupted,
                     const std::function<bool(std::size_t, FlattenedPatch)>& on_done) {
  std::stable_sort(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) {
    return job.patches[a].mesh.triangles.size() > job.patches[b].mesh.triangles.size();
  });
  std::atomic<bool> cancelled = false;
  std::atomic<std::size_t> next = 0;
  Finished finished(numbers.size());
  const auto stopped = [&] { return cancelled || interrupted(); };
  const auto work_on_next = [&] {
    const std::size_t k = next++;
    if (k >= numbers.size()) return false;
    finished.put(
        {numbers[k], stopped() ? FlattenedPatch{} : flatten_patch(job, numbers[k], stopped)});
    return true;
  };
  Workers workers(cancelled);
  workers.start(std::min<std::size_t>(threads, numbers.size()), [&] {
    while (work_on_next()) {
    }
  });
  for (std::size_t taken = 0; taken < numbers.size(); ++taken) {
    if (workers.empty()) work_on_next();
    Finished::Item item = finished.take();
    if (!on_done(item.first, std::move(item.second))) cancelled = true;
  }
}

}  // namespace planish::cli
