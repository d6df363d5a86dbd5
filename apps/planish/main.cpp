#include <csignal>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "run.h"

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

/// A file that is opened must not become one of the three standard ones, where messages would go
/// into it.
void keep_standard_files_taken() {
  int lowest = STDIN_FILENO;
  while (lowest >= 0 && lowest <= STDERR_FILENO)
    lowest = open("/dev/null", O_RDONLY);  // writing to it fails, as to what is closed
  if (lowest >= 0) close(lowest);
}

/// Steps take and free the same memory again and again: given back to the system in between, it has
/// to be cleared again each time, which was a sixth of the time of a patch of 4,000 vertices.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int mebibyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * mebibyte);  // the most there can be
  mallopt(M_TRIM_THRESHOLD, 1024 * mebibyte);
#endif
}

/// Where memory ends while a failure is being handled: nothing can be caught any more, but what has
/// been written is whole still.
[[noreturn]] void end_at_once() {
  constexpr std::string_view message = "error: out of memory or internal error; ended at once\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, message.data(), message.size());
  _exit(planish::cli::k_exit_failed);
}

}  // namespace

int main(int argc, char** argv) {
  std::set_terminate(end_at_once);
  keep_freed_memory();
  keep_standard_files_taken();
  listen_for(SIGINT);
  listen_for(SIGTERM);
  // A reader that went away and a file that may not grow are failures like others.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  const std::vector<std::string> args(argv + (argc > 0 ? 1 : 0), argv + argc);
  return planish::cli::run(
      args, std::cout, std::cerr,
      {.err_is_terminal = isatty(STDERR_FILENO) == 1, .interrupted = &interrupted});
}
