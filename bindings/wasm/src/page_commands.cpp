#include "commands/commands.h"

namespace planish::cli {

/// The verbs that the page calls, in place of all: others would make it larger.
const std::vector<Command>& commands() {
  static const std::vector<Command> all = {flatten_command(), suggest_cuts_command(),
                                           panels_command(), sample_command(), materials_command()};
  return all;
}

}  // namespace planish::cli
