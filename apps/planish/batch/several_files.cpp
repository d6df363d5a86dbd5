#include "batch/several_files.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include "batch/named_files.h"
#include "model/model_flags.h"
#include "platform/path.h"
#include "shell/failures.h"
#include "shell/file_name.h"
#include "shell/output_folder.h"
#include "shell/text.h"
#include "shell/values.h"
#include "text/json_text.h"
#include "text/written_text.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_name_width = 26;

/// The folder that --output names, or nothing without the flag.
/// @throws UsageError for what looks like a file, Error file_unwritable
std::optional<fs::path> folder_from(const Arguments& arguments) {
  if (!arguments.has("--output")) return std::nullopt;
  const std::string folder = arguments.text("--output");
  if (!is_folder(folder) && !extension_of(folder).empty()) {
    throw UsageError("with several files or --csv, --output is a folder, and " + folder +
                     " looks like a file");
  }
  return output_folder(folder);
}

/// One run over all files.
class SeveralRun {
 public:
  SeveralRun(const SeveralFiles& job, const Arguments& arguments, Session& session)
      : job_(job),
        csv_(arguments.text("--csv")),
        folder_(job.extension ? folder_from(arguments) : std::nullopt),
        files_(files_named(arguments.operands, session)),
        session_(session) {
    if (folder_) places_ = output_places(files_, *folder_, job_.extension);
  }

  void work() {
    for (std::size_t f = 0; f < files_.size(); ++f) {
      if (!files_[f].report.failure) work_on(files_[f], folder_ ? places_[f] : fs::path());
      ++done_;
    }
  }

  CommandResult cancelled() const {
    if (!has_written_) throw Cancelled();
    const std::string message = "interrupted; " + std::to_string(done_) + " of " +
                                counted(files_.size(), "file") +
                                " are done and their outputs written, but no table";
    return {{}, json_failure("interrupted", message), k_exit_interrupted, message};
  }

  CommandResult finish() {
    std::vector<FileReport> reports;
    std::string text = left("file", k_name_width) + " " + std::string(job_.heads) + "\n";
    for (WorkFile& file : files_) {
      text += text_of(file);
      reports.push_back(std::move(file.report));
    }
    const bool with_output = job_.extension != nullptr;
    std::vector<OutputFile> written;
    if (!csv_.empty()) {
      written.push_back({path_of(csv_), several_csv(reports, job_.columns, with_output)});
      text += written_text(written);
    }
    if (folder_ && has_written_) text += "results in " + utf8_of(*folder_) + "\n";
    CommandResult outcome =
        with_failures_counted({std::move(text), several_json(reports, with_output, csv_)}, reports);
    if (!written.empty()) session_.write(written);
    return outcome;
  }

 private:
  void work_on(WorkFile& file, const fs::path& place) {
    try {
      job_.work(file, place);
      if (file.files.empty()) return;
      session_.write(file.files, *folder_);
      has_written_ = true;
      file.files.clear();
      file.report.output = utf8_of(place);
    } catch (const std::exception&) {
      file.report.failure = current_failure();
      file.files.clear();
    }
  }

  static std::string text_of(const WorkFile& file) {
    const std::string name = left(short_path(file.report.path, k_name_width), k_name_width) + " ";
    const auto& failure = file.report.failure;
    return name + (failure ? "failed: " + failure->message + "\n" : file.text);
  }

  CommandResult with_failures_counted(CommandResult outcome,
                                      const std::vector<FileReport>& reports) const {
    const auto failed = std::count_if(reports.begin(), reports.end(), [](const FileReport& file) {
      return file.failure.has_value();
    });
    const auto missed = std::count_if(files_.begin(), files_.end(),
                                      [](const WorkFile& file) { return file.misses; });
    const std::string of = " of " + counted(files_.size(), "file");
    if (failed > 0) {
      outcome.exit_code = k_exit_failed;
      outcome.complaint = std::to_string(failed) + of + " failed";
    } else if (missed > 0) {
      outcome.exit_code = k_exit_target_missed;
      outcome.complaint = std::string(job_.missed_before) + std::to_string(missed) + of +
                          std::string(job_.missed_behind);
    }
    return outcome;
  }

  const SeveralFiles& job_;
  std::string csv_;
  std::optional<fs::path> folder_;
  std::vector<WorkFile> files_;
  std::vector<fs::path> places_;  // of the files' outputs
  Session& session_;
  std::size_t done_ = 0;
  bool has_written_ = false;
};

}  // namespace

Flag csv_flag() {
  return {"--csv",
          "FILE",
          "write the figures of all inputs as comma-separated values, one line for each file",
          0,
          false,
          {.extensions = {"csv"}}};
}

Flag output_format_flag(std::vector<std::string> names, const std::string& standard) {
  return {"--output-format",
          "NAME",
          "format of the files that several inputs give: " + list_of(names) + " (default " +
              standard + ")",
          0,
          false,
          {.choices = std::move(names)}};
}

std::optional<std::string> output_format_from(const Arguments& arguments,
                                              const std::vector<std::string>& names) {
  if (!arguments.has("--output-format")) return std::nullopt;
  const std::string name = known_name("format", arguments.text("--output-format"), names);
  if (!takes_several(arguments) || !arguments.has("--output"))
    throw UsageError("flag --output-format goes with several files and --output");
  return name;
}

bool takes_several(const Arguments& arguments) {
  return arguments.operands.size() > 1 || arguments.has("--csv") ||
         is_folder(arguments.operands.front());
}

void refuse_single_file_flags(const Arguments& arguments, std::span<const char* const> flags) {
  for (const char* flag : flags) {
    if (!arguments.has(flag)) continue;
    throw UsageError("flag " + std::string(flag) + " goes with one file only, without --csv");
  }
}

Arguments with_files_that_are_asked_for(const Arguments& arguments, Session& session) {
  if (!arguments.has("--only") && !arguments.has("--without")) return arguments;
  std::ostringstream unheard;
  const RunContext context;
  Session silent(arguments, unheard, context);
  std::vector<std::string> names, asked_for, passed_over;
  for (const WorkFile& file : files_named(arguments.operands, session)) {
    const std::string& path = file.report.path;
    bool is_asked_for = true;  // also of a file that cannot be read: its error is reported later
    try {
      const Model model = read_model_of_several({path, stem_of(path)}, arguments, silent);
      names.insert(names.end(), model.names.begin(), model.names.end());
      is_asked_for = !model.pieces.empty();
    } catch (const Error& error) {
      if (is_of_usage(error)) throw;
    }
    (is_asked_for ? asked_for : passed_over).push_back(path);
  }
  check_asked_names(arguments, names);
  if (asked_for.empty()) {
    throw Error(ErrorCode::no_triangles, "the flags leave nothing of the files",
                {.path = arguments.operands.front()});
  }
  if (!passed_over.empty())
    session.note("passed over, as the flags take nothing of them: " + list_of_some(passed_over));
  Arguments run = arguments;
  run.operands = std::move(asked_for);
  run.names_of_all = std::move(names);
  return run;
}

CommandResult run_several(const SeveralFiles& job, const Arguments& arguments, Session& session) {
  SeveralRun run(job, arguments, session);
  try {
    run.work();
    return run.finish();
  } catch (const Cancelled&) {
    return run.cancelled();
  }
}

}  // namespace planish::cli
