#include "shell/command.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "platform/path.h"

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
      {"", ValueType::on_off},       {"N", ValueType::integer},  {"X", ValueType::number},
      {"LENGTH", ValueType::length}, {"NAME", ValueType::name},  {"KIND", ValueType::name},
      {"UNIT", ValueType::name},     {"PAPER", ValueType::name}, {"NAMES", ValueType::names},
      {"LIST", ValueType::names},    {"FILE", ValueType::file},  {"OUTPUT", ValueType::file},
      {"CUTS", ValueType::file},     {"MESH", ValueType::file},  {"OUT", ValueType::file},
      {"FOLDER", ValueType::folder}};
  const auto found = by_value.find(flag.value);
  return found == by_value.end() ? ValueType::text : found->second;
}

bool needs_value(const Flag& flag) {
  return !flag.value.empty() && !flag.accepts.optional;
}

ValueType type_of(const FlagValue& operand) {
  return operand.type.value_or(operand.choices.empty() ? ValueType::file : ValueType::name);
}

Field Arguments::value(std::string_view flag, Field other) const {
  const auto found = flags.find(flag);
  if (found == flags.end()) return other;
  if (found->second.size() == 1) return found->second.front();
  std::string all;
  for (const Field& field : found->second)
    all += (all.empty() ? "" : ",") + field_text(field);
  return all;
}

std::string Arguments::text(std::string_view flag, std::string other) const {
  return field_text(value(flag, std::move(other)));
}

std::vector<Field> Arguments::fields(std::string_view flag, std::string other) const {
  std::vector<Field> parts;
  const auto found = flags.find(flag);
  for (const Field& field : found == flags.end() ? std::vector<Field>{other} : found->second) {
    for (Field& part : field_parts(field))
      parts.push_back(std::move(part));
  }
  return parts;
}

Rows Arguments::rows_of(const std::string& flag) const {
  const auto found = rows.find(flag);
  return found != rows.end() ? found->second : read_rows(path_of(text(flag)));
}

void mark_first(std::vector<FlagGroup>& groups, const std::vector<std::string>& names) {
  const auto flag_named = [&](const std::string& name) -> Flag& {
    for (FlagGroup& group : groups) {
      for (Flag& flag : group.flags) {
        if (flag.name == name) return flag;
      }
    }
    throw std::out_of_range("no flag " + name);
  };
  for (const std::string& name : names)
    flag_named(name).first = true;
}

bool has_first_flags(const Command& command) {
  return std::any_of(command.groups.begin(), command.groups.end(), [](const FlagGroup& group) {
    return std::any_of(group.flags.begin(), group.flags.end(),
                       [](const Flag& flag) { return flag.first; });
  });
}

const FlagGroup& global_flags() {
  static const FlagGroup group = {
      "Flags of every verb",
      {{"--json", "", "print one JSON object on standard output, and nothing else there"},
       {"--quiet", "", "print no progress and no notes; results and errors still appear", 'q'},
       {"--threads",
        "N",
        "largest number of threads; never changes the result (default: all usable cores)",
        0,
        false,
        {.range = k_threads}},
       {"--help", "", "print this help and end", 'h'},
       {"--help-all", "", "print help with all flags and end"},
       {"--version", "", "print the version and end"}}};
  return group;
}

const Flag* find_flag(const Command& command, std::string_view name) {
  const auto in = [&](const FlagGroup& group) -> const Flag* {
    const auto found = std::find_if(group.flags.begin(), group.flags.end(),
                                    [&](const Flag& flag) { return flag.name == name; });
    return found == group.flags.end() ? nullptr : &*found;
  };
  for (const FlagGroup& group : command.groups) {
    if (const Flag* const found = in(group)) return found;
  }
  return in(global_flags());
}

}  // namespace planish::cli
