#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/utsname.h>
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

/// How a program is started that has nothing to do with this one: in a session of its own, with
/// empty standard files and the usual signals.
class Detached {
 public:
  Detached() {
    posix_spawn_file_actions_init(&files_);
    for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_addopen(&files_, file, "/dev/null", O_RDWR, 0);
    posix_spawnattr_init(&attributes_);
    sigset_t usual;
    sigemptyset(&usual);
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGXFSZ})
      sigaddset(&usual, signal);
    posix_spawnattr_setsigdefault(&attributes_, &usual);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSID);
  }
  ~Detached() {
    posix_spawnattr_destroy(&attributes_);
    posix_spawn_file_actions_destroy(&files_);
  }
  Detached(const Detached&) = delete;
  Detached& operator=(const Detached&) = delete;

  /// Starts a program of the search path with one argument.
  std::error_code start(std::string program, std::string argument) const {
    const std::array<char*, 3> words = {program.data(), argument.data(), nullptr};
    pid_t id = 0;
    const int fault =
        posix_spawnp(&id, program.c_str(), &files_, &attributes_, words.data(), environ);
    return {fault, std::generic_category()};
  }

 private:
  posix_spawn_file_actions_t files_ = {};
  posix_spawnattr_t attributes_ = {};
};

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
          .system_facts = system_facts};
}

std::vector<std::string> command_words(int argc, char** argv) {
  return std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc);
}

std::string open_document(const std::filesystem::path& path) {
  const std::error_code fault = Detached().start(k_opener, path.string());
  if (fault == std::errc::no_such_file_or_directory)
    return std::string(k_opener) + " is not installed";
  return fault ? std::string(k_opener) + ": " + fault.message() : "";
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
