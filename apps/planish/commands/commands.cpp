#include "commands/commands.h"

namespace planish::cli {

namespace {

/// What VERB stands for is known once all verbs are.
std::vector<Command> with_verbs_named(std::vector<Command> all) {
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const Command& command : all)
    names.push_back(command.name);
  for (Command& command : all) {
    for (std::size_t i = 0; i < command.operands.size(); ++i) {
      if (command.operands[i] == "VERB") command.operand_values.at(i).choices = names;
    }
  }
  return all;
}

}  // namespace

const std::vector<Command>& commands() {
  static const std::vector<Command> all = with_verbs_named(
      {flatten_command(), measure_command(), evolve_command(), unfold_command(), compare_command(),
       frontier_command(), suggest_cuts_command(), panels_command(), carry_command(),
       collect_command(), convert_command(), sample_command(), app_command(), materials_command(),
       describe_command(), completion_command(), man_command(), doctor_command()});
  return all;
}

}  // namespace planish::cli
