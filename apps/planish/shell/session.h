#pragma once

#include <chrono>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <planish/core/context.h>
#include <planish/io/read_mesh.h>
#include <planish/io/write_file.h>

#include "shell/command.h"

namespace planish::cli {

/// What verbs share while they run: messages, progress, reading and writing.
class Session {
 public:
  /// @throws UsageError, Error option_out_of_range for bad global flags
  Session(const Arguments& arguments, std::ostream& err, const RunContext& context);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// What long jobs are run with: threads of --threads, a line of progress, and an end where the
  /// user asks to stop. Must not outlive the session.
  /// @param detail beside the bar, where a job does not say what it works on
  Context job_context(std::string detail);
  /// The same without a line of progress, for jobs on any thread.
  Context silent_context() const;

  /// Says what a user may want to know; nothing with --quiet.
  void note(const std::string& message);
  /// Says how far a long job has come; nothing with --quiet.
  void tell(const std::string& line);
  /// Prints a line of results on standard output, as soon as it is known.
  void print(std::string_view line);
  /// Says what a user must know.
  void warn(const std::string& message);

  /// Reads a mesh and passes on what the reader noticed.
  ReadResult read(const std::string& path, const ReadOptions& options = {});
  /// Opens a page that was written in the browser, or says in a note why that cannot be. Never
  /// fails: what the run was for is done by then.
  void open(const std::filesystem::path& page) noexcept;
  SystemFacts system_facts() const;
  /// Runs another program, as host.h has it. What it prints goes where messages go.
  /// @return why there is no result, empty where it ended well
  /// @throws Cancelled
  std::string run_program(const std::vector<std::string>& words);
  /// Null where there is none.
  std::istream* standard_input() const { return context_.in; }
  /// For a run inside this one: its messages go elsewhere, and it stops when this one is stopped.
  RunContext inner_context() const;
  /// Goes on although the user asked to stop, as where a search was stopped and its best answer is
  /// used. Asked a second time, the program ends at once.
  void resume() { is_resumed_ = true; }

  /// Writes all files or none; below the folder no symbolic link is followed, as write_files()
  /// tells.
  /// @throws Cancelled where the user asked to stop
  void write(const std::vector<OutputFile>& files, const std::filesystem::path& folder = {});

 private:
  /// Draws the line of progress anew, on a terminal only and not too often.
  /// @param share done, 0 to 1
  void show_progress(const std::string& stage, double share, const std::string& detail);
  void clear_progress();
  /// True from the moment on that the user asked to stop.
  bool interrupted() const;
  void stop_if_interrupted() const;

  std::ostream& err_;
  const RunContext& context_;
  bool quiet_;
  bool draws_progress_;
  unsigned threads_ = 0;
  bool is_resumed_ = false;
  std::size_t drawn_ = 0;  // characters of the progress line that stand there
  std::chrono::steady_clock::time_point last_drawn_ = {};
};

/// Where a run writes two things to one place, one of them would be lost.
/// @throws UsageError
void refuse_shared_places(const std::vector<OutputFile>& files);

/// The paths of the output flags that are given, by what each file is for.
/// @param flags the role and the flag of each
/// @throws UsageError if two have the same path
std::map<std::string, std::string> output_paths(
    const Arguments& arguments, std::initializer_list<std::pair<const char*, const char*>> flags);

}  // namespace planish::cli
