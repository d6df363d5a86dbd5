#include "parse.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "commands/commands.h"
#include "flags/synonyms.h"
#include "shell/command_line.h"
#include "shell/failures.h"
#include "shell/nearest.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

/// The flag that a word names by its name, an alias or its letter; nullptr where there is none.
const Flag* flag_called(const std::string& word, const Command* command) {
  const auto in = [&](const FlagGroup& group) -> const Flag* {
    const auto found = std::find_if(group.flags.begin(), group.flags.end(), [&](const Flag& flag) {
      return flag.name == without_alias(word) ||
             (flag.letter != 0 && word == std::string("-") + flag.letter);
    });
    return found == group.flags.end() ? nullptr : &*found;
  };
  const Flag* found = in(global_flags());
  for (std::size_t i = 0; found == nullptr && command != nullptr && i < command->groups.size(); ++i)
    found = in(command->groups[i]);
  return found;
}

/// Of several values the last one counts, but for flags that repeat.
void take_value(const Flag& flag, const std::optional<std::string>& value, Parsed& parsed) {
  std::vector<Field>& fields = parsed.arguments.flags[flag.name];
  if (!flag.accepts.repeats) {
    if (value && !fields.empty() && fields.back() != Field(*value)) {
      parsed.notes.push_back(flag.name + " is given as " + field_text(fields.back()) + " and as " +
                             *value + "; the last one counts");
    }
    fields.clear();
  }
  if (value) fields.emplace_back(*value);
}

/// Takes a word that is no flag for the verb or an operand; false where there is no place for it.
bool take_operand(const std::string& word, Parsed& parsed) {
  if (parsed.command == nullptr) {
    const auto found = std::find_if(commands().begin(), commands().end(),
                                    [&](const Command& command) { return command.name == word; });
    if (found != commands().end()) parsed.command = &*found;
    return parsed.command != nullptr;
  }
  std::vector<std::string>& operands = parsed.arguments.operands;
  if (operands.size() >= parsed.command->operands.size() && !parsed.command->operands_repeat)
    return false;
  operands.push_back(word);
  return true;
}

bool is_flag(const std::string& word) {
  return word.size() > 1 && word.front() == '-';
}

/// Takes words apart, in their order.
/// @return those that have no place
std::vector<std::string> take_words(std::span<const std::string> words, Parsed& parsed) {
  std::vector<std::string> rest(words.rbegin(), words.rend()), leftovers;
  const auto next = [&] {
    std::string word = std::move(rest.back());
    rest.pop_back();
    return word;
  };
  while (!rest.empty()) {
    const std::string word = next();
    const bool is_long = word.starts_with("--");
    const std::string name = word.substr(0, is_long ? word.find('=') : 2);
    const Flag* const flag = is_flag(word) ? flag_called(name, parsed.command) : nullptr;
    if (flag == nullptr) {
      if (is_flag(word) || !take_operand(word, parsed)) leftovers.push_back(word);
      continue;
    }
    std::optional<std::string> value;
    if (name.size() < word.size() && (is_long || needs_value(*flag))) {
      value = word.substr(name.size() + (is_long ? 1 : 0));
    } else if (name.size() < word.size()) {
      rest.push_back("-" + word.substr(name.size()));  // more letters
    } else if (needs_value(*flag)) {
      if (rest.empty()) throw UsageError("flag " + name + " needs a value");
      value = next();  // whatever it begins with
    }
    if (value && flag->value.empty()) throw UsageError("flag " + name + " takes no value");
    take_value(*flag, value, parsed);
  }
  return leftovers;
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

void refuse_leftovers(const std::vector<std::string>& words, const Command* command) {
  for (const std::string& word : words) {
    if (is_flag(word)) refuse_flag(word, command);
    if (command == nullptr) refuse_verb(word);
    refuse_argument(word, *command);
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
  const bool needs_operands = !command.operands_optional && !arguments.has("--inputs");
  if (given.size() < command.operands.size() && needs_operands) {
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

}  // namespace

void refuse_empty_values(const Command& command, const Arguments& arguments) {
  for (const auto& [name, value] : arguments.flags) {
    const Flag* const flag = find_flag(command, name);
    if (flag == nullptr || !needs_value(*flag) || type_of(*flag) == ValueType::text) continue;
    if (arguments.text(name).empty())
      throw UsageError("flag " + name + " needs a value, and the one given is empty");
  }
}

bool asks_for(std::span<const std::string> args, std::string_view flag) {
  const auto end = std::find(args.begin(), args.end(), "--");
  return std::find(args.begin(), end, flag) != end;
}

Parsed parse(std::span<const std::string> args) {
  // Words behind "--" are operands, whatever they begin with.
  const auto mark = std::find(args.begin(), args.end(), "--");
  const auto before = args.first(static_cast<std::size_t>(mark - args.begin()));
  const auto behind = args.subspan(std::min(before.size() + 1, args.size()));
  Parsed parsed;
  const std::vector<std::string> leftovers = take_words(before, parsed);
  for (const char* flag : {"--help", "--help-all", "--version"}) {
    if (parsed.arguments.has(flag)) return parsed;
  }
  refuse_leftovers(leftovers, parsed.command);
  for (const std::string& word : behind) {
    if (parsed.command == nullptr) refuse_verb(word);
    if (!take_operand(word, parsed)) refuse_argument(word, *parsed.command);
  }
  if (parsed.command == nullptr) return parsed;
  refuse_empty_values(*parsed.command, parsed.arguments);
  refuse_empty_operands(*parsed.command, parsed.arguments);
  check_complete(*parsed.command, parsed.arguments);
  return parsed;
}

}  // namespace planish::cli
