#include "commands/commands.h"

namespace planish::cli {

/// Only the verbs that the page uses. The page is linked with this instead of the program's list,
/// so that it stays small.
const std::vector<Command>& commands() {
  static const std::vector<Command> all = {flatten_command(), suggest_cuts_command(),
                                           panels_command(), sample_command(), materials_command()};
  return all;
}

}  // namespace planish::cli
