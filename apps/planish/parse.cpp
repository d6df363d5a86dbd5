#include "parse.h"

#include <algorithm>
#include <map>
#include <utility>

#include <CLI/CLI.hpp>

#include "commands/commands.h"
#include "flags/synonyms.h"
#include "shell/command_line.h"
#include "shell/failures.h"
#include "shell/nearest.h"
#include "shell/values.h"

// CLI11 takes the words apart; what is missing or unknown is told in our own words, and the help is
// written from the same tables (help.cpp).

namespace planish::cli {

namespace {

std::string cli11_name(const Flag& flag) {
  return flag.letter == 0 ? flag.name : std::string("-") + flag.letter + "," + flag.name;
}

/// With all names that mean the same.
std::string cli11_names(const Flag& flag) {
  std::string names = cli11_name(flag);
  for (const std::string& alias : aliases_of(flag.name))
    names += "," + alias;
  return names;
}

/// Options by their full names. CLI11 could be asked for them, but ends the program where memory
/// ends while it looks.
using Options = std::map<std::string, CLI::Option*>;

void add_flag(CLI::App& app, const Flag& flag, Options& options) {
  // Several methods may have an option of one name.
  if (options.find(flag.name) != options.end()) return;
  CLI::Option*& option = options[flag.name];
  if (flag.value.empty()) {
    option = app.add_flag(cli11_names(flag))->disable_flag_override();
  } else if (flag.accepts.optional) {
    option = app.add_flag(cli11_names(flag));
  } else if (flag.accepts.repeats) {
    option = app.add_option(cli11_names(flag))
                 ->expected(1)
                 ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  } else {
    option = app.add_option(cli11_names(flag))
                 ->expected(1)
                 ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  }
}

Options add_flags(CLI::App& app, const std::vector<FlagGroup>& groups) {
  app.set_help_flag();
  app.allow_extras();
  Options options;
  for (const Flag& flag : global_flags().flags)
    add_flag(app, flag, options);
  for (const FlagGroup& group : groups) {
    for (const Flag& flag : group.flags)
      add_flag(app, flag, options);
  }
  return options;
}

/// The value as it was typed; empty where none was.
std::string value_of(const Flag& flag, const CLI::Option& option) {
  const auto& given = option.results();
  if (flag.value.empty()) return {};
  if (flag.accepts.optional && given.back() == "true") return {};  // as CLI11 has it of a switch
  if (!flag.accepts.repeats) return given.back();
  std::string all;
  for (const std::string& value : given)
    all += (all.empty() ? "" : ",") + value;
  return all;
}

/// Of several values the last one counts.
void note_other_values(const Flag& flag, const CLI::Option& option, Parsed& parsed) {
  if (flag.value.empty() || flag.accepts.repeats) return;
  const auto& given = option.results();
  const auto other = std::find_if(given.begin(), given.end(),
                                  [&](const std::string& value) { return value != given.back(); });
  if (other == given.end()) return;
  parsed.notes.push_back(flag.name + " is given as " + *other + " and as " + given.back() +
                         "; the last one counts");
}

void read_flags(const Options& options, const FlagGroup& group, Parsed& parsed) {
  for (const Flag& flag : group.flags) {
    const CLI::Option* option = options.at(flag.name);
    if (option->count() == 0) continue;
    parsed.arguments.flags[flag.name] = value_of(flag, *option);
    note_other_values(flag, *option, parsed);
  }
}

std::vector<std::string> flag_names(const Command* command) {
  std::vector<std::string> names;
  const auto add = [&](const FlagGroup& group) {
    for (const Flag& flag : group.flags) {
      names.push_back(flag.name);
      for (std::string& alias : aliases_of(flag.name))
        names.push_back(std::move(alias));
    }
  };
  add(global_flags());
  if (command != nullptr) std::for_each(command->groups.begin(), command->groups.end(), add);
  return names;
}

/// Why there is no such flag, where that is known; else nothing.
std::string reason_of_absence(const std::string& flag, const Command* command) {
  constexpr std::string_view no = "--no-";
  if (flag.starts_with(no) && command != nullptr) {
    const std::string other = "--" + flag.substr(no.size());
    const Flag* const found = find_flag(*command, other);
    if (found != nullptr && found->value.empty()) return other + " is off unless given";
  }
  return std::string(missing_flag_advice(flag));
}

[[noreturn]] void refuse_flag(const std::string& word, const Command* command) {
  const std::string typed = word.substr(0, word.find('='));
  const std::string flag(without_alias(typed));
  const std::string shown = flag == typed ? flag : typed + " (" + flag + ")";
  if (command != nullptr && find_flag(*command, flag) != nullptr) {
    throw UsageError("flag " + flag + " must stand behind the verb: planish " + command->name +
                     " " + flag + " ...");
  }
  std::vector<std::string> owners;
  for (const Command& other : commands()) {
    if (find_flag(other, flag) != nullptr) owners.push_back(other.name);
  }
  if (!owners.empty()) {
    throw UsageError("flag " + shown + " belongs to " + list_of(owners) +
                     (command == nullptr ? "" : ", not " + command->name));
  }
  const std::string reason = reason_of_absence(flag, command);
  if (!reason.empty()) throw UsageError("there is no flag " + flag + ": " + reason);
  throw UsageError("unknown flag " + flag + nearest_hint(flag, flag_names(command)));
}

[[noreturn]] void refuse_verb(const std::string& word) {
  std::vector<std::string> known = {"--help", "--version"};
  for (const Command& command : commands())
    known.push_back(command.name);
  const bool is_path = word.find_first_of("./") != std::string::npos;
  throw UsageError("unknown verb " + word +
                   (is_path ? "; did you mean planish flatten " + shell_word(word) + "?"
                            : nearest_hint(word, known)));
}

[[noreturn]] void refuse_argument(const std::string& word, const Command& command) {
  std::string taken;
  for (const std::string& operand : command.operands)
    taken += " " + operand;
  throw UsageError("unexpected argument " + word + ": planish " + command.name + " takes" +
                   (taken.empty() ? " none" : taken + " only"));
}

/// CLI11 throws for two faults only: a flag at the end that lacks its value, and a value for a
/// flag that takes none.
[[noreturn]] void refuse_value(std::span<const std::string> args) {
  for (const std::string& word : args) {
    const std::string name = word.substr(0, word.find('='));
    const bool valueless =
        std::any_of(global_flags().flags.begin(), global_flags().flags.end(),
                    [&](const Flag& flag) { return flag.name == name && flag.value.empty(); });
    if (valueless && name != word) throw UsageError("flag " + name + " takes no value");
  }
  const std::string& last = args.back();
  throw UsageError("flag " + last.substr(0, last.find('=')) + " needs a value");
}

bool is_flag(const std::string& word) {
  return word.size() > 1 && word.front() == '-';
}

/// Takes the words behind "--" for operands, whatever they begin with.
void take_operands(std::span<const std::string> words, const Command* command,
                   Arguments& arguments) {
  if (words.empty()) return;
  if (command == nullptr) refuse_verb(words.front());
  arguments.operands.insert(arguments.operands.end(), words.begin(), words.end());
  const std::size_t most = command->operands.size();
  if (!command->operands_repeat && arguments.operands.size() > most)
    refuse_argument(arguments.operands[most], *command);
}

void refuse_leftovers(const std::vector<std::string>& words, const Command* command) {
  for (const std::string& word : words) {
    if (is_flag(word)) refuse_flag(word, command);
    if (command == nullptr) refuse_verb(word);
    refuse_argument(word, *command);
  }
}

/// Takes what is no flag for more operands, in the order of the command line.
std::vector<std::string> with_operands_taken(std::vector<std::string> words, Arguments& arguments) {
  const auto operands = std::stable_partition(words.begin(), words.end(), is_flag);
  arguments.operands.insert(arguments.operands.end(), operands, words.end());
  words.erase(operands, words.end());
  return words;
}

/// An empty word, as a shell makes it of an empty variable, names no file and is no number.
void refuse_empty_values(const FlagGroup& group, const Arguments& arguments) {
  for (const Flag& flag : group.flags) {
    if (!needs_value(flag) || type_of(flag) == ValueType::text) continue;
    if (arguments.has(flag.name) && arguments.flags.at(flag.name).empty())
      throw UsageError("flag " + flag.name + " needs a value, and the one given is empty");
  }
}

void refuse_empty_operands(const Command& command, const Arguments& arguments) {
  const auto& given = arguments.operands;
  const auto empty = std::find(given.begin(), given.end(), "");
  if (empty == given.end()) return;
  const auto at = std::min(static_cast<std::size_t>(empty - given.begin()),
                           command.operands.size() - 1);  // the last may repeat
  throw UsageError(command.operands[at] + " needs a value, and the one given is empty");
}

void check_complete(const Command& command, const Arguments& arguments) {
  const auto& given = arguments.operands;
  if (arguments.has("--list")) return;  // `sample --list` needs nothing else
  const std::string usage = ": planish " + command.name + " " + command.usage;
  if (given.size() < command.operands.size() && !command.operands_optional) {
    throw UsageError("missing " + command.operands[given.size()] + usage);
  }
  for (const FlagGroup& group : command.groups) {
    for (const Flag& flag : group.flags) {
      // A table of figures may be all that is wanted of several files.
      if (flag.required && !arguments.has(flag.name) && !arguments.has("--csv")) {
        const std::string name = flag.letter == 0 ? flag.name : "-" + std::string(1, flag.letter);
        throw UsageError("missing flag " + name + usage);
      }
    }
  }
}

/// A verb as CLI11 takes it apart.
struct Verb {
  const Command* command = nullptr;
  Options options;
  std::vector<CLI::Option*> operands;
};

}  // namespace

bool asks_for(std::span<const std::string> args, std::string_view flag) {
  const auto end = std::find(args.begin(), args.end(), "--");
  return std::find(args.begin(), end, flag) != end;
}

Parsed parse(std::span<const std::string> args) {
  // Words behind "--" are operands; CLI11 would lose which of its leftovers were.
  const auto mark = std::find(args.begin(), args.end(), "--");
  const auto before = args.first(static_cast<std::size_t>(mark - args.begin()));
  const auto behind = args.subspan(std::min(before.size() + 1, args.size()));
  CLI::App app;
  const Options global = add_flags(app, {});
  app.allow_windows_style_options(false);  // a word like /a.obj is a path; verbs inherit it
  app.require_subcommand(0, 1);
  std::map<const CLI::App*, Verb> verbs;
  for (const Command& command : commands()) {
    CLI::App& app_of_verb = *app.add_subcommand(command.name);
    Verb& verb = verbs[&app_of_verb];
    verb.command = &command;
    verb.options = add_flags(app_of_verb, command.groups);
    for (const std::string& operand : command.operands)
      verb.operands.push_back(app_of_verb.add_option(operand)->expected(1));
  }
  try {
    // CLI11 wants them reversed.
    app.parse(std::vector<std::string>(before.rbegin(), before.rend()));
  } catch (const CLI::ParseError&) {
    refuse_value(before);
  }

  Parsed parsed;
  read_flags(global, global_flags(), parsed);
  const auto given_verbs = app.get_subcommands();
  if (!given_verbs.empty()) {
    const Verb& verb = verbs.at(given_verbs.front());
    parsed.command = verb.command;
    read_flags(verb.options, global_flags(), parsed);
    for (const FlagGroup& group : parsed.command->groups)
      read_flags(verb.options, group, parsed);
    for (const CLI::Option* operand : verb.operands) {
      const auto given = operand->results();
      parsed.arguments.operands.insert(parsed.arguments.operands.end(), given.begin(), given.end());
    }
  }
  for (const char* flag : {"--help", "--help-all", "--version"}) {
    if (parsed.arguments.has(flag)) return parsed;
  }
  std::vector<std::string> leftovers = app.remaining(true);
  if (parsed.command != nullptr && parsed.command->operands_repeat)
    leftovers = with_operands_taken(std::move(leftovers), parsed.arguments);
  refuse_leftovers(leftovers, parsed.command);
  take_operands(behind, parsed.command, parsed.arguments);
  refuse_empty_values(global_flags(), parsed.arguments);
  if (parsed.command == nullptr) return parsed;
  for (const FlagGroup& group : parsed.command->groups)
    refuse_empty_values(group, parsed.arguments);
  refuse_empty_operands(*parsed.command, parsed.arguments);
  check_complete(*parsed.command, parsed.arguments);
  return parsed;
}

}  // namespace planish::cli
