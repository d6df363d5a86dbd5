#include "help.h"

#include <algorithm>
#include <array>

#include "commands/commands.h"
#include "shell/text.h"

namespace planish::cli {

namespace {

constexpr std::size_t k_doc_column = 26;
constexpr std::size_t k_first_examples = 5;

/// A term at the left and its meaning beside it, or below where the term is long.
std::string entry(const std::string& term, const std::string& doc) {
  std::string text = "  " + term;
  if (text.size() + 2 > k_doc_column) {
    text += "\n" + std::string(k_doc_column, ' ');
  } else {
    text.resize(k_doc_column, ' ');
  }
  return text + wrapped(doc, k_doc_column) + "\n";
}

std::string flag_entry(const Flag& flag) {
  std::string term = flag.letter == 0 ? "    " : std::string("-") + flag.letter + ", ";
  term += flag.name;
  if (needs_value(flag)) term += " " + flag.value;
  if (flag.accepts.optional) term += "[=" + flag.value + "]";
  return entry(term, flag.doc);
}

std::string group_text(const FlagGroup& group) {
  std::string text = "\n" + group.title + ":\n";
  for (const Flag& flag : group.flags)
    text += flag_entry(flag);
  return text;
}

/// Of a group those flags that come first; nothing where there are none.
std::string first_text(const FlagGroup& group) {
  FlagGroup few = {group.first_title.empty() ? group.title : group.first_title, {}};
  for (const Flag& flag : group.flags) {
    if (flag.first) few.flags.push_back(flag);
  }
  return few.flags.empty() ? "" : group_text(few);
}

/// "Exit codes: 0 done; 1 ... "
std::string exit_codes_line() {
  std::string text;
  for (const ExitCode& code : exit_codes()) {
    text += text.empty() ? "Exit codes: " : "; ";
    text += std::to_string(code.number) + " " + std::string(code.meaning);
  }
  return text + ". " + std::string(k_nothing_after_failure);
}

}  // namespace

std::span<const ExitCode> exit_codes() {
  static constexpr std::array<ExitCode, 5> all = {
      {{k_exit_done, "done"},
       {k_exit_failed, "input, output or unusable mesh"},
       {k_exit_usage, "usage"},
       {k_exit_target_missed, "target or limit missed"},
       {k_exit_interrupted, "interrupted"}}};
  return all;
}

std::vector<std::string> program_examples() {
  return {"planish flatten panel.obj -o panel-pattern", "planish measure panel.obj --json"};
}

std::string program_help() {
  std::string text = "planish: " + std::string(k_program_summary) +
                     "\n\nUsage: planish VERB [flags] INPUT ...\n\nVerbs:\n";
  for (const Command& command : commands())
    text += entry(command.name, command.summary);
  text += group_text(global_flags());
  text += "\nExamples:\n";
  for (const std::string& example : program_examples())
    text += "  " + example + "\n";
  text += "\nplanish VERB --help shows the usual flags of a verb, --help-all all of them.\n";
  return text + wrapped(exit_codes_line(), 0) + "\n";
}

std::string verb_help(const Command& command, bool all) {
  const bool few = !all && has_first_flags(command);
  std::string text = "planish " + command.name + ": " + command.summary + "\n\n";
  text += "Usage: planish " + command.name + " " + command.usage + " [flags]\n\n";
  text += wrapped(command.description, 0) + "\n";
  for (const FlagGroup& group : command.groups)
    text += few ? first_text(group) : group_text(group);
  if (!few) text += group_text(global_flags());
  text += "\nExamples:\n";
  const std::size_t count =
      std::min(command.examples.size(), few ? k_first_examples : command.examples.size());
  for (std::size_t i = 0; i < count; ++i)
    text += "  " + command.examples[i] + "\n";
  if (few) text += "\nThese are the usual flags. All: planish " + command.name + " --help-all\n";
  return text;
}

std::string short_help() {
  return "Usage: planish VERB [flags] INPUT ...\n\n"
         "  planish flatten panel.obj     the whole job: lay flat, write the pattern\n"
         "  planish measure panel.obj     how far the patch is from flattenable\n\n"
         "planish --help shows the rest.\n";
}

}  // namespace planish::cli
