#include "garment_run.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

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
    done.files =
        job.files_of(*report, patch.format, job.furniture[number], job.folder / patch.folder);
    done.mesh = std::move(report->processed);
    done.pattern = std::move(report->unfold.pattern.positions);
  } catch (...) {
    done = {};
    done.failure = current_failure();
  }
  return done;
}

/// What threads hand to the one that writes.
class Finished {
 public:
  using Item = std::pair<std::size_t, FlattenedPatch>;

  void put(Item item) {
    const std::lock_guard lock(mutex_);
    items_.push_back(std::move(item));
    arrived_.notify_one();
  }
  Item take() {
    std::unique_lock lock(mutex_);
    arrived_.wait(lock, [&] { return !items_.empty(); });
    Item item = std::move(items_.front());
    items_.pop_front();
    return item;
  }

 private:
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::deque<Item> items_;
};

}  // namespace

PatchFailure current_failure() {
  try {
    throw;
  } catch (const Error& error) {
    return {std::string(to_string(error.code())), error.what()};
  } catch (const std::bad_alloc&) {
    return {"out_of_memory", "out of memory"};
  } catch (const std::exception& error) {
    return {"internal_error", error.what()};
  }
}

void flatten_patches(const GarmentJob& job, std::vector<std::size_t> numbers, unsigned threads,
                     const std::function<bool()>& interrupted,
                     const std::function<bool(std::size_t, FlattenedPatch)>& on_done) {
  std::stable_sort(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) {
    return job.patches[a].mesh.triangles.size() > job.patches[b].mesh.triangles.size();
  });
  std::atomic<bool> cancelled = false;
  std::atomic<std::size_t> next = 0;
  Finished finished;
  const auto stopped = [&] { return cancelled || interrupted(); };
  const auto work_on_next = [&] {
    const std::size_t k = next++;
    if (k >= numbers.size()) return false;
    finished.put(
        {numbers[k], stopped() ? FlattenedPatch{} : flatten_patch(job, numbers[k], stopped)});
    return true;
  };
  std::vector<std::thread> workers;
  const std::size_t wanted = std::min<std::size_t>(threads, numbers.size());
  workers.reserve(wanted);
  try {
    while (workers.size() < wanted) {
      workers.emplace_back([&] {
        while (work_on_next()) {
        }
      });
    }
  } catch (const std::system_error&) {
    // The system has no more threads to give: those that there are do the work.
  }
  for (std::size_t taken = 0; taken < numbers.size(); ++taken) {
    if (workers.empty()) work_on_next();
    Finished::Item item = finished.take();
    if (!on_done(item.first, std::move(item.second))) cancelled = true;
  }
  for (std::thread& worker : workers)
    worker.join();
}

}  // namespace planish::cli
