#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <spawn.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __GLIBC__
#include <gnu/libc-version.h>
#include <malloc.h>
#endif

#include "shell/host.h"

namespace planish::cli {

namespace {

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "signal handlers may touch nothing else");

void on_signal(int) {
  interrupted = true;
}

/// The first signal asks to stop; the second one, with its default action back in place, ends the
/// program at once.
void listen_for(int signal) {
  struct sigaction action = {};
  action.sa_handler = on_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(signal, &action, nullptr);
}

void keep_standard_files_taken() {
  int lowest = STDIN_FILENO;
  while (lowest >= 0 && lowest <= STDERR_FILENO)
    lowest = open("/dev/null", O_RDONLY);  // writing to it fails, as to what is closed
  if (lowest >= 0) close(lowest);
}

void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int mebibyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * mebibyte);  // the most there can be
  mallopt(M_TRIM_THRESHOLD, 1024 * mebibyte);
  mallopt(M_ARENA_MAX, 1);  // what one thread frees is there for the others
#endif
}

constexpr const char* k_opener = "xdg-open";

/// A program that was started, or why it could not be.
struct Started {
  std::error_code fault;
  pid_t id = 0;
};

/// How a program is started: with empty standard input and the usual signals.
class Launch {
 public:
  /// @param is_detached it has nothing to do with this one: a session of its own, and prints
  ///   nowhere; else a group of processes of its own, and prints to standard error
  explicit Launch(bool is_detached) {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDWR, 0);
    if (is_detached) {
      for (const int file : {STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&files_, file, "/dev/null", O_RDWR, 0);
    } else {
      posix_spawn_file_actions_adddup2(&files_, STDERR_FILENO, STDOUT_FILENO);
    }
    posix_spawnattr_init(&attributes_);
    sigset_t usual;
    sigemptyset(&usual);
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGXFSZ})
      sigaddset(&usual, signal);
    posix_spawnattr_setsigdefault(&attributes_, &usual);
    const int group = is_detached ? POSIX_SPAWN_SETSID : POSIX_SPAWN_SETPGROUP;
    posix_spawnattr_setflags(&attributes_, static_cast<short>(POSIX_SPAWN_SETSIGDEF | group));
  }
  ~Launch() {
    posix_spawnattr_destroy(&attributes_);
    posix_spawn_file_actions_destroy(&files_);
  }
  Launch(const Launch&) = delete;
  Launch& operator=(const Launch&) = delete;

  /// Starts a program of the search path.
  Started start(std::vector<std::string> words) const {
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words)
      pointers.push_back(word.data());
    pointers.push_back(nullptr);
    Started started;
    const int fault = posix_spawnp(&started.id, pointers.front(), &files_, &attributes_,
                                   pointers.data(), environ);
    started.fault = {fault, std::generic_category()};
    return started;
  }

 private:
  posix_spawn_file_actions_t files_ = {};
  posix_spawnattr_t attributes_ = {};
};

/// Why a program that ended so has no result; empty where it ended well.
std::string fault_of_end(int status) {
  if (WIFSIGNALED(status)) return "was ended by signal " + std::to_string(WTERMSIG(status));
  const int code = WEXITSTATUS(status);
  return code == 0 ? "" : "ended with code " + std::to_string(code);
}

/// Where the search path has a program; empty where it has none.
std::string found_program(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::string program = folder + "/" + name;
    if (access(program.c_str(), X_OK) == 0) return program;
  }
  return {};
}

/// What Linux calls the processor; empty elsewhere.
std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return {};
}

}  // namespace

RunContext prepare_process() {
  keep_freed_memory();
  keep_standard_files_taken();
  listen_for(SIGINT);
  listen_for(SIGTERM);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  return {.err_is_terminal = isatty(STDERR_FILENO) == 1,
          .interrupted = &interrupted,
          .open_document = open_document,
          .system_facts = system_facts,
          .run_program = run_program};
}

std::vector<std::string> command_words(int argc, char** argv) {
  return std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc);
}

std::string open_document(const std::filesystem::path& path) {
  const std::error_code fault = Launch(true).start({k_opener, path.string()}).fault;
  if (fault == std::errc::no_such_file_or_directory)
    return std::string(k_opener) + " is not installed";
  return fault ? std::string(k_opener) + ": " + fault.message() : "";
}

std::string run_program(const std::vector<std::string>& words,
                        const std::function<bool()>& is_cancelled) {
  using Clock = std::chrono::steady_clock;
  constexpr auto longest_pause = std::chrono::milliseconds(20);
  constexpr auto patience = std::chrono::seconds(2);  // with a program that was asked to end
  const Started started = Launch(false).start(words);
  if (started.fault) return "cannot be started: " + started.fault.message();
  std::optional<Clock::time_point> asked;
  auto pause = std::chrono::milliseconds(1);
  int status = 0;
  while (waitpid(started.id, &status, WNOHANG) == 0) {
    if (!asked && is_cancelled()) {
      asked = Clock::now();
      kill(-started.id, SIGTERM);
    } else if (asked && Clock::now() > *asked + patience) {
      kill(-started.id, SIGKILL);
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, longest_pause);
  }
  return fault_of_end(status);
}

SystemFacts system_facts() {
  SystemFacts facts;
  utsname system = {};
  if (uname(&system) == 0)
    facts.name = std::string(system.sysname) + " " + system.release + " " + system.machine;
#ifdef __GLIBC__
  facts.name += std::string(", glibc ") + gnu_get_libc_version();
#endif
  facts.processor = processor_name();
  facts.document_opener = found_program(k_opener);
  return facts;
}

bool has_own_window() {
  return false;
}

void end_at_once(std::string_view message, int exit_code) noexcept {
  [[maybe_unused]] const auto written = write(STDERR_FILENO, message.data(), message.size());
  _exit(exit_code);
}

}  // namespace planish::cli
