#include <exception>
#include <iostream>

#include "run.h"
#include "shell/host.h"

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
  const planish::cli::RunContext context = planish::cli::prepare_process();
  return planish::cli::run(planish::cli::command_words(argc, argv), std::cout, std::cerr, context);
}
