#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "run.h"
#include "shell/host.h"
#include "shell/own_window.h"

namespace {

/// Where memory ends while a failure is being handled: nothing can be caught any more, but what has
/// been written is whole still.
[[noreturn]] void end_after_failure() {
  planish::cli::end_at_once("error: out of memory or internal error; ended at once\n",
                            planish::cli::k_exit_failed);
}

}  // namespace

int main(int argc, char** argv) {
  std::set_terminate(end_after_failure);
  planish::cli::RunContext context = planish::cli::prepare_process();
  context.in = &std::cin;
  const std::vector<std::string> words = planish::cli::command_words(argc, argv);
  if (planish::cli::has_own_window()) {
    return planish::cli::run_in_own_window(
        words, {std::cin, std::cout, std::cerr, planish::cli::open_document}, context);
  }
  return planish::cli::run(words, std::cout, std::cerr, context);
}
