#include "program.h"

#include <sstream>

#include "run.h"

namespace planish::wasm {

Run run_program(const std::vector<std::string>& words,
                const std::function<void(const Progress&)>& on_progress) {
  std::ostringstream out, err;
  cli::RunContext context;
  context.on_progress = on_progress;
  const int exit_code = cli::run(words, out, err, context);
  return {exit_code, out.str(), err.str()};
}

}  // namespace planish::wasm
