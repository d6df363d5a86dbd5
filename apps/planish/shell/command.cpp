#include "shell/command.h"

#include <algorithm>
#include <array>

namespace planish::cli {

std::string_view to_string(ValueType type) {
  constexpr std::array<std::string_view, 12> names = {"switch", "integer", "number",  "share",
                                                      "length", "angle",   "radians", "name",
                                                      "names",  "text",    "file",    "folder"};
  return names.at(static_cast<std::size_t>(type));
}

ValueType type_of(const Flag& flag) {
  if (flag.accepts.type) return *flag.accepts.type;
  const std::map<std::string_view, ValueType> by_value = {
      {"", ValueType::on_off},       {"N", ValueType::integer},    {"X", ValueType::number},
      {"LENGTH", ValueType::length}, {"NAME", ValueType::name},    {"KIND", ValueType::name},
      {"UNIT", ValueType::name},     {"PAPER", ValueType::name},   {"NAMES", ValueType::names},
      {"LIST", ValueType::names},    {"FILE", ValueType::file},    {"OUTPUT", ValueType::file},
      {"CUTS", ValueType::file},     {"FOLDER", ValueType::folder}};
  const auto found = by_value.find(flag.value);
  return found == by_value.end() ? ValueType::text : found->second;
}

std::string Arguments::value_or(std::string_view flag, const std::string& other) const {
  const auto found = flags.find(flag);
  return found == flags.end() ? other : found->second;
}

const FlagGroup& global_flags() {
  static const FlagGroup group = {
      "Flags of every verb",
      {{"--json", "", "print one JSON object on standard output and nothing else there"},
       {"--quiet", "", "no progress and no notes; results and errors still appear", 'q'},
       {"--threads",
        "N",
        "use at most N threads; never changes the result (default: all cores)",
        0,
        false,
        {.range = k_threads}},
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
