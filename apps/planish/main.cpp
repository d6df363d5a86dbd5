#include <csignal>
#include <iostream>
#include <string>
#include <vector>

#include <unistd.h>

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

}  // namespace

int main(int argc, char** argv) {
  listen_for(SIGINT);
  listen_for(SIGTERM);
  const std::vector<std::string> args(argv + (argc > 0 ? 1 : 0), argv + argc);
  return planish::cli::run(
      args, std::cout, std::cerr,
      {.err_is_terminal = isatty(STDERR_FILENO) == 1, .interrupted = &interrupted});
}
