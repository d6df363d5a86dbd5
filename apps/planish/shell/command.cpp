#include "shell/command.h"

#include <algorithm>

namespace planish::cli {

std::string Arguments::value_or(std::string_view flag, const std::string& other) const {
  const auto found = flags.find(flag);
  return found == flags.end() ? other : found->second;
}

const FlagGroup& global_flags() {
  static const FlagGroup group = {
      "Flags of every verb",
      {{"--json", "", "print one JSON object on standard output and nothing else there"},
       {"--quiet", "", "no progress and no notes; results and errors still appear", 'q'},
       {"--threads", "N", "use at most N threads; never changes the result (default: all cores)"},
       {"--help", "", "print help and end", 'h'},
       {"--version", "", "print the version and end"}}};
  return group;
}

const Flag* find_flag(const Command& command, std::string_view name) {
  for (const FlagGroup& group : command.groups) {
    const auto found = std::find_if(group.flags.begin(), group.flags.end(),
                                    [&](const Flag& flag) { return flag.name == name; });
    if (found != group.flags.end()) return &*found;
  }
  return nullptr;
}

}  // namespace planish::cli
