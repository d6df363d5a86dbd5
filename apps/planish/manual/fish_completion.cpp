#include "commands/commands.h"
#include "flags/synonyms.h"
#include "manual/candidates.h"
#include "manual/completion.h"

namespace planish::cli {

namespace {

constexpr const char* k_fish_head =
    R"(# Completion of planish for fish. Made by: planish completion fish

# The words behind the program's name that are neither flags before the verb nor their values.
function __planish_words
    set -l words (commandline -opc)
    set -e words[1]
    while set -q words[1]; and string match -q -- '-*' $words[1]
        contains -- $words[1] VALUED; and set -e words[1]
        set -e words[1]
    end
    printf '%s\n' $words
end

# Whether that is the verb; without a word, whether there is none yet.
function __planish_verb
    set -l words (__planish_words)
    test "$words[1]" = "$argv[1]"
end

# Whether an operand may be next: the last word is none of the verb's flags that take a value.
function __planish_operand # verb, how many stand before or *, flags that take a value
    __planish_verb $argv[1]; or return
    set -l words (__planish_words)
    set -l count 0
    set -l waits 0
    for word in $words[2..]
        if test $waits = 1
            set waits 0
        else if contains -- $word $argv[3..]
            set waits 1
        else if not string match -q -- '-*' $word
            set count (math $count + 1)
        end
    end
    test $waits = 0; or return
    test $argv[2] = '*'; or test $argv[2] = $count
end

# What of the current word stands behind "--flag=".
function __planish_value
    string replace -r -- '^-[^=]*=' '' (commandline -ct)
end

function __planish_some # candidates, with commas between those that are typed
    set -l before (string match -r -- '.*,' (__planish_value))
    printf '%s\n' "$before"$argv
end

function __planish_file # endings; none for all files
    set -l ending .
    set -q argv[1]; and set ending '(?i)(?:/|\.(?:'(string join '|' $argv)'))(?:\t.*)?$'
    complete -C "'' "(__planish_value) | string match -er -- $ending
end

complete -c planish -f
)";

std::string quoted(const std::string& text) {
  return "'" + escaped(text, "\\'") + "'";
}

/// What completes a value, for complete -a; empty for what has no candidates.
std::string fish_action(const Candidates& candidates) {
  std::string words = joined(candidates.words, " ");
  switch (candidates.kind) {
    case Candidates::Kind::nothing:
      break;
    case Candidates::Kind::one:
      return words;
    case Candidates::Kind::some:
      return "(__planish_some " + words + ")";
    case Candidates::Kind::file:
      return words.empty() ? "(__planish_file)" : "(__planish_file " + words + ")";
    case Candidates::Kind::folder:
      return "(__fish_complete_directories (__planish_value))";
  }
  return "";
}

/// @param condition when the flags are offered; empty for always
std::string fish_flag_lines(const std::vector<Flag>& flags, const std::string& condition) {
  std::string text;
  for (const Flag& flag : flags) {
    text += "complete -c planish";
    if (!condition.empty()) text += " -n " + quoted(condition);
    if (flag.letter != 0) text += std::string(" -s ") + flag.letter;
    text += " -l " + flag.name.substr(2);
    const std::string of_value = flag.value.empty() ? "" : fish_action(candidates_of(flag));
    if (needs_value(flag)) text += " -x";
    if (!of_value.empty()) text += " -a " + quoted(of_value);
    text += " -d " + quoted(short_doc(flag)) + "\n";
  }
  return text;
}

/// The names of flags that take a value, with those that mean the same.
std::string valued_names(const std::vector<Flag>& flags) {
  std::vector<std::string> names;
  for (const Flag& flag : flags) {
    if (!needs_value(flag)) continue;
    for (const std::vector<std::string>& some : {offered_names(flag), aliases_of(flag.name)})
      names.insert(names.end(), some.begin(), some.end());
  }
  return joined(names, " ");
}

std::string verb_lines(const Command& command) {
  const std::vector<Flag> flags = distinct_flags(command.groups);
  std::string text = "\n" + fish_flag_lines(flags, "__planish_verb " + command.name);
  const std::string valued = valued_names(global_flags().flags) + " " + valued_names(flags);
  for (std::size_t i = 0; i < command.operand_values.size(); ++i) {
    const bool repeats = command.operands_repeat && i + 1 == command.operand_values.size();
    text += "complete -c planish -n " +
            quoted("__planish_operand " + command.name + " " +
                   (repeats ? "'*'" : std::to_string(i)) + " " + valued) +
            " -a " + quoted(fish_action(candidates_of(command.operand_values[i]))) + "\n";
  }
  return text;
}

}  // namespace

std::string fish_completion() {
  std::string text = k_fish_head;
  const std::string mark = "VALUED";
  text.replace(text.find(mark), mark.size(), valued_names(global_flags().flags));
  text += fish_flag_lines(global_flags().flags, "");
  for (const Command& command : commands()) {
    text += "complete -c planish -n '__planish_verb' -a " + command.name + " -d " +
            quoted(command.summary) + "\n";
  }
  for (const Command& command : commands())
    text += verb_lines(command);
  return text;
}

}  // namespace planish::cli
