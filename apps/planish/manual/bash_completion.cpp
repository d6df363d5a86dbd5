#include <map>

#include "commands/commands.h"
#include "flags/synonyms.h"
#include "manual/candidates.h"
#include "manual/completion.h"

namespace planish::cli {

namespace {

constexpr const char* k_bash_head =
    R"(# Completion of planish for bash. Made by: planish completion bash

_planish_one() { # candidates
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$cur")
}

_planish_some() { # candidates, with commas between those that are typed
  local before=""
  [[ $cur != *,* ]] || before=${cur%,*},
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "$1" -- "${cur##*,}")
}

_planish_file() { # endings; none for all files
  local name ending
  COMPREPLY=()
  compopt -o filenames 2>/dev/null
  while IFS= read -r name; do
    ending=${name##*.}
    if [[ -z $1 || " $1 " == *" ${ending,,} "* || -d ${name/#\~\//$HOME/} ]]; then
      COMPREPLY+=("$name")
    fi
  done < <(compgen -f -- "$cur")
}

_planish_folder() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$cur")
}

)";

constexpr const char* k_bash_tail = R"(
_planish() {
  local cur=${COMP_WORDS[COMP_CWORD]} word before="" verb="" action i operands=0 ended=""
  COMPREPLY=()
  # Bash takes "--unit=cm" for three words. A flag that waits for its value is kept in "before".
  for ((i = 1; i < COMP_CWORD; ++i)); do
    word=${COMP_WORDS[i]}
    if [[ -n $before ]]; then
      [[ $word == "=" ]] || before=""
    elif [[ $word == "=" ]]; then  # of a flag whose value may be left out
      ((++i))
    elif [[ -n $ended || $word != -* ]]; then
      if [[ -z $verb ]]; then verb=$word; else ((++operands)); fi
    elif [[ $word == -- ]]; then
      ended=1
    elif _planish_value "$verb" "$word"; then
      before=$word
    fi
  done
  [[ $cur != "=" ]] || cur=""
  if [[ -n $before ]]; then
    _planish_value "$verb" "$before"
    eval "$action"
  elif [[ -z $ended && $cur == -* ]]; then
    _planish_flags "$verb"
  elif [[ -z $verb ]]; then
    _planish_verbs
  else
    _planish_operand "$verb" "$operands"
  fi
}

complete -F _planish planish
)";

/// The command that completes a value.
std::string bash_action(const Candidates& candidates) {
  const std::string words = " '" + joined(candidates.words, " ") + "'";
  switch (candidates.kind) {
    case Candidates::Kind::nothing:
      break;
    case Candidates::Kind::one:
      return "_planish_one" + words;
    case Candidates::Kind::some:
      return "_planish_some" + words;
    case Candidates::Kind::file:
      return "_planish_file" + words;
    case Candidates::Kind::folder:
      return "_planish_folder";
  }
  return ":";
}

/// Lines of a case that call for a flag's value, those of one action together.
std::string value_lines(const std::vector<Flag>& flags, const std::string& indent) {
  std::vector<std::string> actions;
  std::map<std::string, std::vector<std::string>> names;
  for (const Flag& flag : flags) {
    if (!needs_value(flag)) continue;
    const std::string of_flag = bash_action(candidates_of(flag));
    if (!names.contains(of_flag)) actions.push_back(of_flag);
    for (const std::vector<std::string>& some : {offered_names(flag), aliases_of(flag.name)})
      names[of_flag].insert(names[of_flag].end(), some.begin(), some.end());
  }
  std::string text;
  for (const std::string& some : actions) {
    text += indent + joined(names[some], " | ") +
            ") action=" + (some == ":" ? ":" : "\"" + some + "\"") + " ;;\n";
  }
  return text;
}

std::string value_function() {
  std::string text =
      "# Sets what completes the value of a flag; false where it takes none.\n"
      "_planish_value() { # verb, flag\n  action=\"\"\n  case $2 in\n" +
      value_lines(global_flags().flags, "    ") + "  esac\n  case $1 in\n";
  for (const Command& command : commands()) {
    const std::string lines = value_lines(distinct_flags(command.groups), "        ");
    if (lines.empty()) continue;
    text += "    " + command.name + ")\n      case $2 in\n" + lines + "      esac\n      ;;\n";
  }
  return text + "  esac\n  [[ -n $action ]]\n}\n";
}

std::string names_of_flags(const std::vector<Flag>& flags) {
  std::vector<std::string> names;
  for (const Flag& flag : flags) {
    for (std::string& name : offered_names(flag))
      names.push_back(std::move(name));
  }
  return joined(names, " ");
}

std::string flags_function() {
  std::string text = "\n_planish_flags() { # verb\n  local flags='" +
                     names_of_flags(global_flags().flags) + "'\n  case $1 in\n";
  for (const Command& command : commands()) {
    const std::string names = names_of_flags(distinct_flags(command.groups));
    if (!names.empty()) text += "    " + command.name + ") flags+=' " + names + "' ;;\n";
  }
  return text + "  esac\n  _planish_one \"$flags\"\n}\n";
}

std::string verbs_function() {
  std::vector<std::string> names;
  for (const Command& command : commands())
    names.push_back(command.name);
  return "\n_planish_verbs() {\n  _planish_one '" + joined(names, " ") + "'\n}\n";
}

std::string operand_function() {
  std::string text = "\n_planish_operand() { # verb, how many stand before\n  case $1:$2 in\n";
  for (const Command& command : commands()) {
    for (std::size_t i = 0; i < command.operand_values.size(); ++i) {
      const bool repeats = command.operands_repeat && i + 1 == command.operand_values.size();
      text += "    " + command.name + ":" + (repeats ? "*" : std::to_string(i)) + ") " +
              bash_action(candidates_of(command.operand_values[i])) + " ;;\n";
    }
  }
  return text + "  esac\n}\n";
}

}  // namespace

std::string bash_completion() {
  return k_bash_head + value_function() + flags_function() + verbs_function() + operand_function() +
         k_bash_tail;
}

}  // namespace planish::cli
