#include "product/run.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

#include "flatten/twin_report.h"
#include "platform/path.h"

namespace planish::cli {

namespace {

using Stopped = std::function<bool()>;

FlattenOptions options_of(const ProductJob& job, std::size_t number) {
  FlattenOptions options = job.options;
  options.threads = 1;
  options.keep = named_vertices(job.annotations[number]);
  return options;
}

/// @throws Error as flatten(), and that of a patch that could not be read
std::optional<FlattenReport> report_of(const ProductJob& job, std::size_t number,
                                       const Stopped& stopped) {
  const ProductPatch& patch = job.patches[number];
  if (patch.failure) throw Error(*patch.failure);
  return flatten(Patch(patch.mesh), patch.name, options_of(job, number),
                 [&](FlattenStage, double) { return !stopped(); });
}

FlattenedPatch files_and_all(const ProductJob& job, std::size_t number, const FlattenReport& report,
                             const PatternOptions& annotations) {
  const ProductPatch& patch = job.patches[number];
  return {{},
          job.files_of(report, patch.format, annotations, job.folder / path_of(patch.folder)),
          report.processed.mesh(),
          report.unfold.pattern.positions,
          report.twin_of.has_value()};
}

/// What of a patch is written and told, from its report; where there is none it was cancelled.
template <class MakeReport>
FlattenedPatch finished(const ProductJob& job, std::size_t number, const MakeReport& make) try {
  const std::optional<FlattenReport>& report = make();
  return report ? files_and_all(job, number, *report, job.annotations[number]) : FlattenedPatch{};
} catch (...) {
  FlattenedPatch failed;
  failed.failure = current_failure();
  return failed;
}

/// What was made of the other one, or else what flattening makes of it.
FlattenedPatch finished_twin(const ProductJob& job, std::size_t number, const MeshTwin& twin,
                             const FlattenReport& other, const Stopped& stopped) try {
  const ProductPatch& patch = job.patches[number];
  const auto report =
      twin_report(other, Patch(patch.mesh), twin.match, patch.name, options_of(job, number));
  if (!report) return finished(job, number, [&] { return report_of(job, number, stopped); });
  return files_and_all(
      job, number, *report,
      annotations_of_twin(job.annotations[number], job.patches[twin.of].mesh, twin.match));
} catch (...) {
  FlattenedPatch failed;
  failed.failure = current_failure();
  return failed;
}

/// Flattens the first patch of a group and makes the others from it.
/// @param put is handed each by its number
template <class Put>
void flatten_group(const ProductJob& job, const ProductTwins& twins, const TwinGroup& group,
                   const Stopped& stopped, const Put& put) {
  std::optional<FlattenReport> first;
  put(group.front(), finished(job, group.front(), [&]() -> const std::optional<FlattenReport>& {
        return first = report_of(job, group.front(), stopped);
      }));
  for (std::size_t k = 1; k < group.size(); ++k) {
    const std::size_t number = group[k];
    put(number, stopped() ? FlattenedPatch{}
                : first   ? finished_twin(job, number, *twins[number], *first, stopped)
                          : finished(job, number, [&] { return report_of(job, number, stopped); }));
  }
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

void flatten_patches(const ProductJob& job, const ProductTwins& twins,
                     std::vector<std::size_t> numbers, unsigned threads,
                     const std::function<bool()>& interrupted,
                     const std::function<bool(std::size_t, FlattenedPatch)>& on_done) {
  std::stable_sort(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) {
    return job.patches[a].mesh.triangles.size() > job.patches[b].mesh.triangles.size();
  });
  const std::vector<TwinGroup> groups = groups_of(numbers, twins);
  std::atomic<bool> cancelled = false;
  std::atomic<std::size_t> next = 0;
  Finished results(numbers.size());
  const auto stopped = [&] { return cancelled || interrupted(); };
  const auto work_on_next = [&] {
    const std::size_t k = next++;
    if (k >= groups.size()) return false;
    const auto put = [&](std::size_t p, FlattenedPatch done) { results.put({p, std::move(done)}); };
    flatten_group(job, twins, groups[k], stopped, put);
    return true;
  };
  Workers workers(cancelled);
  workers.start(std::min<std::size_t>(threads, groups.size()), [&] {
    while (work_on_next()) {
    }
  });
  for (std::size_t taken = 0; taken < numbers.size(); ++taken) {
    if (workers.empty()) work_on_next();
    Finished::Item item = results.take();
    if (!on_done(item.first, std::move(item.second))) cancelled = true;
  }
}

}  // namespace planish::cli
