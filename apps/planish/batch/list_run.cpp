#include "batch/list_run.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "batch/named_files.h"
#include "batch/records.h"
#include "flatten/product/workers.h"
#include "model/sha256.h"
#include "output/kept_files.h"
#include "piece/single_patch_flags.h"
#include "platform/path.h"
#include "platform/processors.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/output_folder.h"
#include "shell/text.h"
#include "text/json_text.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

/// What a run said for people that is no progress.
std::vector<std::string> notes_in(const std::string& said) {
  std::vector<std::string> notes;
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("note: ") || line.starts_with("warning: ")) notes.push_back(line);
  }
  return notes;
}

/// @throws Error file_not_found, file_unreadable
std::string content_of_input(const std::string& path) {
  std::error_code ignored;
  if (is_folder(path)) {
    throw Error(ErrorCode::file_unreadable, "is a folder; a list names each file", {.path = path});
  }
  const fs::path place = fs::canonical(path_of(path), ignored);
  if (place.empty())
    throw Error(ErrorCode::file_not_found, "cannot be read: there is no such file", {.path = path});
  auto content = kept_content(place);
  if (!content) throw Error(ErrorCode::file_unreadable, "cannot be read", {.path = path});
  return *std::move(content);
}

/// Turns an exception into the outcome of an input that failed.
/// @pre called in a handler
void take_failure(InputOutcome& outcome) {
  outcome.result = {{}, {}, k_exit_failed};
  try {
    throw;
  } catch (const Cancelled&) {
    throw;
  } catch (const UsageError& error) {
    outcome.failure = Failure{"usage", error.what()};
    outcome.result.exit_code = k_exit_usage;
  } catch (const std::exception&) {
    outcome.failure = current_failure();
  }
}

/// Works on single inputs, from any thread.
class InputWork {
 public:
  InputWork(const ListJob& job, const Arguments& arguments, ListSettings settings, unsigned threads,
            const RunContext& context)
      : job_(job), arguments_(arguments), settings_(std::move(settings)), context_(context) {
    folder_ = output_folder(arguments.text("--output"));
    arguments_.flags["--threads"] = {Field(static_cast<std::int64_t>(threads))};
    for (const char* flag : {"--inputs", "--shard", "--csv", "--keep-failures", "--json"})
      arguments_.flags.erase(flag);
  }

  /// The records of an input, when all of it is written.
  /// @throws Cancelled, Error file_unwritable
  std::vector<Json> records_for(const ListedInput& input) const {
    InputOutcome outcome;
    try {
      outcome.hash = sha256(content_of_input(input.path));
    } catch (const std::exception&) {
      take_failure(outcome);
    }
    const fs::path folder = folder_ / path_of(input.folder);
    // A product file names others, which its hash says nothing of.
    const bool may_keep = lower_extension(input.path) != ".json";
    if (!outcome.failure && may_keep && arguments_.has("--resume")) {
      const auto kept = kept_records(input, outcome.hash, settings_, folder);
      if (kept) return *kept;
    }
    if (!outcome.failure) work_on(input, folder, outcome);
    std::vector<Json> records = records_of(input, outcome, settings_);
    write_files(std::vector<OutputFile>{record_file(records, folder)}, folder_);
    return records;
  }

 private:
  void work_on(const ListedInput& input, const fs::path& folder, InputOutcome& outcome) const {
    Arguments own = arguments_;
    own.operands = {input.path};
    own.flags["--output"] = {Field(utf8_of(folder))};
    std::ostringstream said;
    const auto begin = std::chrono::steady_clock::now();
    try {
      Session session(own, said, context_);
      outcome.result = job_.work(own, session);
      if (outcome.result.exit_code == k_exit_interrupted) throw Cancelled();
    } catch (const std::exception&) {
      take_failure(outcome);
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    outcome.seconds = took.count();
    outcome.notes = notes_in(said.str());
  }

  const ListJob& job_;
  Arguments arguments_;
  ListSettings settings_;
  RunContext context_;
  fs::path folder_;
};

/// What a thread made of an input.
struct DoneInput {
  std::size_t place = 0;  ///< in the shard
  std::vector<Json> records = {};
  std::exception_ptr fault = {};  ///< that ends the run
};

/// One run over the inputs of a shard.
class ListRun {
 public:
  ListRun(const ListJob& job, const Arguments& arguments, Session& session)
      : job_(job),
        arguments_(arguments),
        session_(session),
        inputs_(of_shard(job.inputs, shard_from(arguments))),
        rows_(arguments.has("--csv") ? inputs_.size() : 0) {}

  void work() {
    const Context context = session_.job_context({});
    const std::size_t all_threads = context.threads == 0 ? usable_processors() : context.threads;
    const std::size_t at_once = std::clamp<std::size_t>(inputs_.size(), 1, all_threads);
    const InputWork input_work(job_, arguments_, settings_of(arguments_, job_.inputs.size()),
                               static_cast<unsigned>(all_threads / at_once),
                               session_.inner_context());
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> abandoned = false;
    Handover<DoneInput> results(inputs_.size());
    const auto work_on_next = [&] {
      const std::size_t place = next++;
      if (place >= inputs_.size() || abandoned) return false;
      DoneInput done{place};
      try {
        done.records = input_work.records_for(inputs_[place]);
      } catch (...) {
        done.fault = std::current_exception();
      }
      results.put(std::move(done));
      return true;
    };
    Workers workers(abandoned);
    if (at_once > 1) {
      workers.start(at_once, [&] {
        while (work_on_next()) {
        }
      });
    }
    while (done_ < inputs_.size()) {
      if (workers.empty()) work_on_next();
      take(results.take());
      if (context.on_progress)
        context.on_progress(
            {"flattening", static_cast<double>(done_) / static_cast<double>(inputs_.size())});
      if (context.is_cancelled()) throw Cancelled();
    }
  }

  CommandResult cancelled() const {
    return {{},
            {},
            k_exit_interrupted,
            "interrupted; " + std::to_string(done_) + " of " + counted(inputs_.size(), "input") +
                " are done, --resume does the rest"};
  }

  CommandResult finish() {
    if (arguments_.has("--csv")) {
      std::string table = record_table_header();
      for (const std::string& row : rows_)
        table += row;
      session_.write({{path_of(arguments_.text("--csv")), std::move(table)}});
    }
    session_.tell(counted(inputs_.size(), "input") + ": " + std::to_string(patches_) +
                  " patches, " + std::to_string(failed_) + " failed, " + std::to_string(missed_) +
                  " miss something, " + std::to_string(kept_) + " kept of an earlier run");
    if (failed_ > 0) {
      return {{},
              {},
              k_exit_failed,
              std::to_string(failed_) + " of " + std::to_string(patches_) +
                  " patches could not be flattened"};
    }
    if (missed_ > 0) {
      return {{},
              {},
              k_exit_target_missed,
              std::to_string(missed_) + " of " + std::to_string(patches_) +
                  " patches miss what was asked for, or cannot be cut as they are"};
    }
    return {};
  }

 private:
  void take(const DoneInput& done) {
    if (done.fault) std::rethrow_exception(done.fault);
    bool has_failed = false;
    for (const Json& record : done.records) {
      job_.on_record(record);
      tell_of(record);
      if (arguments_.has("--csv")) rows_[done.place] += record_table_line(record);
      has_failed = has_failed || !record["error"].is_null();
    }
    if (has_failed && arguments_.has("--keep-failures"))
      keep_failure(inputs_[done.place], done.records);
    ++done_;
  }

  void tell_of(const Json& record) {
    ++patches_;
    kept_ += record["kept"].get<bool>() ? 1 : 0;
    const std::string path = record["path"];
    if (!record["error"].is_null()) {
      ++failed_;
      session_.tell("failed: " + record["error"]["message"].get<std::string>());
      return;
    }
    missed_ += exit_of(record) == k_exit_done ? 0 : 1;
    const std::string patch = record["patch"];
    session_.tell((exit_of(record) == k_exit_done ? "[ok] " : "[no] ") + path +
                  (patch == stem_of(path) ? "" : ", " + patch));
  }

  /// The input that failed, as it is, and its records beside it.
  void keep_failure(const ListedInput& input, const std::vector<Json>& records) {
    const fs::path folder = path_of(arguments_.text("--keep-failures"));
    std::string lines;
    for (const Json& record : records)
      lines += record_line(record) + "\n";
    std::vector<OutputFile> files = {{folder / path_of(input.folder + ".error.json"), lines}};
    try {
      std::string content = content_of_input(input.path);
      files.push_back(
          {folder / path_of(input.folder + extension_of(input.path)), std::move(content)});
    } catch (const Error&) {
      // The input cannot be read: its records are kept without it.
    }
    session_.write(files, folder);
  }

  const ListJob& job_;
  const Arguments& arguments_;
  Session& session_;
  std::vector<ListedInput> inputs_;
  std::vector<std::string> rows_;  // of the table, of each input
  std::size_t done_ = 0, patches_ = 0, failed_ = 0, missed_ = 0, kept_ = 0;
};

}  // namespace

std::vector<Flag> list_flags() {
  return {{"--inputs", "FILE",
           "work on each input of a list by itself: one path a line; - reads the list from "
           "standard input. Prints one line of JSON for each patch"},
          {"--shard",
           "K/N",
           "with --inputs: work only on every Nth input, from the Kth on, so that N machines can "
           "share a list",
           0,
           false,
           {.type = ValueType::text}},
          {"--csv",
           "FILE",
           "with --inputs: write the figures as comma-separated values, one line for each patch",
           0,
           false,
           {.extensions = {"csv"}}},
          {"--keep-failures", "FOLDER",
           "with --inputs: copy each input that fails into FOLDER, with its error"}};
}

void refuse_list_flags(const Arguments& arguments) {
  for (const char* flag : {"--shard", "--csv", "--keep-failures"}) {
    if (arguments.has(flag))
      throw UsageError("flag " + std::string(flag) + " goes with a list of inputs: --inputs");
  }
}

CommandResult run_list(const ListJob& job, const Arguments& arguments, Session& session) {
  refuse_single_patch_flags(arguments, "a list has several");
  for (const char* flag : {"--open", "--product", "--rename"}) {
    if (!arguments.has(flag)) continue;
    throw UsageError("flag " + std::string(flag) +
                     " does not go with --inputs, where each input stands alone");
  }
  if (arguments.has("--keep-failures")) output_folder(arguments.text("--keep-failures"));
  ListRun run(job, arguments, session);
  try {
    run.work();
    return run.finish();
  } catch (const Cancelled&) {
    return run.cancelled();
  }
}

}  // namespace planish::cli
