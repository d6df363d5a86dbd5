// What verbs and flags there are, for programs that build on this one.

#include <cmath>
#include <string>
#include <vector>

#include <planish/core/version.h>

#include <planish_json/json.h>

#include "commands/commands.h"
#include "flags/synonyms.h"
#include "shell/session.h"
#include "shell/text.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

Json bound(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

std::string_view unit_of(ValueType type) {
  switch (type) {
    case ValueType::share:
      return "fraction";
    case ValueType::length:
      return "model units";
    case ValueType::angle:
      return "degrees";
    case ValueType::radians:
      return "radians";
    default:
      return {};
  }
}

/// A number where the whole text is one, else the text.
Json standard_json(const std::string& text) {
  if (text.empty()) return nullptr;
  const Json number = Json::parse(text, nullptr, false);
  return number.is_number() ? number : Json(text);
}

/// In the unit of the type: 0.02 for 2%.
Json standard_json(const Flag& flag, ValueType type) {
  const std::string& text = flag.accepts.standard;
  if (type == ValueType::on_off) return false;
  if (type == ValueType::share && text.ends_with('%')) {
    const Json per_cent = standard_json(text.substr(0, text.size() - 1));
    return per_cent.get<double>() / 100.0;
  }
  return standard_json(text);
}

Json flag_json(const Flag& flag) {
  const ValueType type = type_of(flag);
  const auto text_or_null = [](const std::string& text) {
    return text.empty() ? Json(nullptr) : Json(text);
  };
  return {{"name", flag.name},
          {"aliases", aliases_of(flag.name)},
          {"short", text_or_null(flag.letter == 0 ? "" : std::string("-") + flag.letter)},
          {"type", to_string(type)},
          {"unit", text_or_null(std::string(unit_of(type)))},
          {"choices", flag.accepts.choices},
          {"min", bound(flag.accepts.range.min)},
          {"max", bound(flag.accepts.range.max)},
          {"default", standard_json(flag, type)},
          {"extensions", flag.accepts.extensions},
          {"value_optional", flag.accepts.optional},
          {"repeats", flag.accepts.repeats},
          {"required", flag.required},
          {"first", flag.first},
          {"placeholder", text_or_null(flag.value)},
          {"help", flag.doc}};
}

Json operand_json(const FlagValue& operand) {
  return {{"type", to_string(type_of(operand))},
          {"choices", operand.choices},
          {"extensions", operand.extensions}};
}

Json group_json(const FlagGroup& group) {
  Json flags = Json::array();
  for (const Flag& flag : group.flags)
    flags.push_back(flag_json(flag));
  return {{"title", group.title},
          {"method", group.method.empty() ? Json(nullptr) : Json(group.method)},
          {"flags", flags}};
}

Json verb_json(const Command& command) {
  Json groups = Json::array(), operand_values = Json::array();
  for (const FlagValue& operand : command.operand_values)
    operand_values.push_back(operand_json(operand));
  for (const FlagGroup& group : command.groups)
    groups.push_back(group_json(group));
  return {{"name", command.name},
          {"summary", command.summary},
          {"usage", command.usage},
          {"description", command.description},
          {"operands", command.operands},
          {"operands_repeat", command.operands_repeat},
          {"operand_values", operand_values},
          {"groups", groups},
          {"examples", command.examples}};
}

std::vector<const Command*> described(const Arguments& arguments) {
  std::vector<std::string> names;
  for (const Command& command : commands())
    names.push_back(command.name);
  const std::string asked =
      arguments.operands.empty() ? "" : known_name("verb", arguments.operands.front(), names);
  std::vector<const Command*> chosen;
  for (const Command& command : commands()) {
    if (asked.empty() || asked == command.name) chosen.push_back(&command);
  }
  return chosen;
}

/// "--quantity  integer, 1 to 1000000"
std::string flag_line(const Flag& flag) {
  const FlagValue& value = flag.accepts;
  std::string text = std::string(to_string(type_of(flag)));
  if (std::isfinite(value.range.min) || std::isfinite(value.range.max)) {
    text += ", " + (std::isfinite(value.range.min) ? plain(value.range.min) : "any") + " to " +
            (std::isfinite(value.range.max) ? plain(value.range.max) : "any");
  }
  if (!value.choices.empty()) text += ": " + list_of(value.choices);
  if (!value.standard.empty()) text += "; default " + value.standard;
  return "  " + left(flag.name, 20) + wrapped(text, 22) + "\n";
}

std::string verb_text(const Command& command) {
  std::string text = command.name + ": " + command.summary + "\n";
  for (const FlagGroup& group : command.groups) {
    text += "\n" + group.title + ":\n";
    for (const Flag& flag : group.flags)
      text += flag_line(flag);
  }
  return text + "\n";
}

CommandResult run_describe(const Arguments& arguments, Session&) {
  std::string text;
  Json verbs = Json::array();
  for (const Command* command : described(arguments)) {
    text += verb_text(*command);
    verbs.push_back(verb_json(*command));
  }
  return {text, json_document({{"version", std::string(k_version)},
                               {"verbs", verbs},
                               {"every_verb", group_json(global_flags())["flags"]}})};
}

}  // namespace

Command describe_command() {
  return {"describe",
          "list what all flags accept, for programs that use this one",
          "[VERB]",
          "Prints what the flags of each verb, or of one verb, accept: type, range, choices and "
          "default. With --json it prints all that --help-all prints too, for forms and bindings.",
          {"VERB"},
          {},
          {"planish describe --json", "planish describe flatten"},
          run_describe,
          true,
          false,
          {{.type = ValueType::name}}};
}

}  // namespace planish::cli
