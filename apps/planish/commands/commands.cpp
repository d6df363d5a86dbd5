#include "commands/commands.h"

namespace planish::cli {

const std::vector<Command>& commands() {
  static const std::vector<Command> all = {
      flatten_command(), measure_command(),  evolve_command(),       unfold_command(),
      compare_command(), frontier_command(), suggest_cuts_command(), carry_command(),
      convert_command(), sample_command(),   describe_command()};
  return all;
}

}  // namespace planish::cli
