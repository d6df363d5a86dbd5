#include <csignal>

#include <fcntl.h>
#include <unistd.h>
#ifdef __GLIBC__
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
#endif
}

}  // namespace

RunContext prepare_process() {
  keep_freed_memory();
  keep_standard_files_taken();
  listen_for(SIGINT);
  listen_for(SIGTERM);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  return {.err_is_terminal = isatty(STDERR_FILENO) == 1, .interrupted = &interrupted};
}

std::vector<std::string> command_words(int argc, char** argv) {
  return std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc);
}

void end_at_once(std::string_view message, int exit_code) noexcept {
  [[maybe_unused]] const auto written = write(STDERR_FILENO, message.data(), message.size());
  _exit(exit_code);
}

}  // namespace planish::cli
