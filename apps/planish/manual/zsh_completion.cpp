#include "commands/commands.h"
#include "manual/candidates.h"
#include "manual/completion.h"
#include "shell/command_line.h"

namespace planish::cli {

namespace {

/// Names that end so, in capitals or not.
std::string pattern(const std::vector<std::string>& endings) {
  const std::string text = joined(endings, "|");
  // One word in parentheses would be a qualifier.
  return "\"*.(#i)" + (endings.size() == 1 ? text : "(" + text + ")") + "\"";
}

/// What completes a value, as _arguments takes it.
std::string zsh_action(const Candidates& candidates) {
  switch (candidates.kind) {
    case Candidates::Kind::nothing:
      break;
    case Candidates::Kind::one:
      return "(" + joined(candidates.words, " ") + ")";
    case Candidates::Kind::some:
      return "{_values -s , name " + joined(candidates.words, " ") + "}";
    case Candidates::Kind::file:
      return candidates.words.empty() ? "_files" : "_files -g " + pattern(candidates.words);
    case Candidates::Kind::folder:
      return "_files -/";
  }
  return " ";
}

std::string message(const std::string& text) {
  return escaped(text, "\\:");
}

/// Behind "_arguments", a line each.
std::string zsh_flag_lines(const std::vector<Flag>& flags, const std::string& indent) {
  std::string text;
  for (const Flag& flag : flags) {
    const bool has_value = !flag.value.empty();
    const bool is_optional = flag.accepts.optional;  // then the value is in the same word
    std::string names = flag.name + (has_value ? "=" : "") + (is_optional ? "-" : "");
    if (flag.letter != 0) {
      const std::string letter = std::string("-") + flag.letter;
      names = "'(" + flag.name + " " + letter + ")'{" + names + "," + letter +
              (has_value ? "+" : "") + "}";
    }
    std::string rest = "[" + escaped(short_doc(flag), "\\[]") + "]";
    if (is_optional) rest += ":";
    if (has_value) rest += ":" + message(flag.value) + ":" + zsh_action(candidates_of(flag));
    text += indent + names + in_quotes(rest) + " \\\n";
  }
  return text;
}

std::string operand_lines(const Command& command, const std::string& indent) {
  std::string text;
  for (std::size_t i = 0; i < command.operand_values.size(); ++i) {
    const bool repeats = command.operands_repeat && i + 1 == command.operand_values.size();
    text +=
        indent +
        in_quotes((repeats ? "*:" : std::to_string(i + 1) + ":") + message(command.operands[i]) +
                  ":" + zsh_action(candidates_of(command.operand_values[i]))) +
        " \\\n";
  }
  return text;
}

/// A command of lines that each end with a backslash; the last one may not.
std::string closed(const std::string& text) {
  return text.substr(0, text.size() - 3) + "\n";
}

}  // namespace

std::string zsh_completion() {
  std::string text =
      "#compdef planish\n# Completion of planish for zsh. Made by: planish completion zsh\n\n"
      "_planish() {\n"
      "  local curcontext=$curcontext state line\n"
      "  typeset -A opt_args\n"
      "  local -a verbs=(\n";
  for (const Command& command : commands())
    text += "    " + in_quotes(command.name + ":" + command.summary) + "\n";
  text += "  )\n  _arguments -C \\\n" + zsh_flag_lines(global_flags().flags, "    ") +
          "    '1:VERB:->verb' \\\n    '*::FLAG:->rest' && return\n"
          "  case $state in\n"
          "    verb) _describe VERB verbs ;;\n"
          "    rest)\n      case $line[1] in\n";
  for (const Command& command : commands()) {
    text += "        " + command.name + ")\n          _arguments \\\n" +
            closed(zsh_flag_lines(global_flags().flags, "            ") +
                   zsh_flag_lines(distinct_flags(command.groups), "            ") +
                   operand_lines(command, "            ")) +
            "          ;;\n";
  }
  return text +
         "      esac\n      ;;\n  esac\n}\n\n"
         // Where a shell loads it by itself the file is the function; elsewhere it is sourced.
         "if [[ $funcstack[1] == _planish ]]; then\n  _planish \"$@\"\nelse\n"
         "  compdef _planish planish\nfi\n";
}

}  // namespace planish::cli
