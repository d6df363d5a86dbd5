#include "manual/man_page.h"

#include <array>

#include <planish/core/version.h>

#include "commands/commands.h"
#include "help.h"
#include "manual/candidates.h"

namespace planish::cli {

namespace {

/// Text that roff prints as it is.
std::string roff(std::string_view text) {
  constexpr std::array<std::pair<char, std::string_view>, 6> special = {{{'\\', "\\e"},
                                                                         {'-', "\\-"},
                                                                         {'~', "\\(ti"},
                                                                         {'^', "\\(ha"},
                                                                         {'\'', "\\(aq"},
                                                                         {'`', "\\(ga"}}};
  // A line that begins with a point would be a request.
  std::string result = text.starts_with('.') ? "\\&" : "";
  for (const char c : text) {
    std::string_view shown(&c, 1);
    for (const auto& [plain, escape] : special) {
      if (c == plain) shown = escape;
    }
    result += shown;
  }
  return result;
}

std::string bold(std::string_view text) {
  return "\\fB" + roff(text) + "\\fR";
}

std::string italic(std::string_view text) {
  return "\\fI" + roff(text) + "\\fR";
}

std::string paragraph(std::string_view text) {
  return roff(text) + "\n";
}

/// A term and, indented below it, its meaning.
std::string entry(const std::string& term, std::string_view meaning) {
  return ".TP\n" + term + "\n" + paragraph(meaning);
}

std::string section(const std::string& title) {
  return ".SH " + title + "\n";
}

std::string head(const std::string& name, std::string_view summary) {
  std::string text =
      ".TH \"" + roff(name) + "\" 1 \"\" \"planish " + k_version + "\" \"Planish\"\n";
  return text + section("NAME") + roff(name) + " \\- " + paragraph(summary) + section("SYNOPSIS");
}

std::string flag_entry(const Flag& flag) {
  std::string term = flag.letter == 0 ? "" : bold(std::string("-") + flag.letter) + ", ";
  term += bold(flag.name);
  if (needs_value(flag)) term += " " + italic(flag.value);
  if (flag.accepts.optional) term += "[=" + italic(flag.value) + "]";
  return entry(term, flag.doc);
}

std::string group_text(const FlagGroup& group) {
  std::string text = ".SS \"" + roff(group.title) + "\"\n";
  for (const Flag& flag : group.flags)
    text += flag_entry(flag);
  return text;
}

std::string examples_text(const std::vector<std::string>& examples) {
  std::string text = section("EXAMPLES") + ".EX\n";
  for (const std::string& example : examples)
    text += paragraph(example);
  return text + ".EE\n";
}

std::string exit_codes_text() {
  std::string text = section("EXIT STATUS");
  for (const ExitCode& code : exit_codes())
    text += entry(bold(std::to_string(code.number)), code.meaning);
  return text + ".PP\n" + paragraph(k_nothing_after_failure);
}

/// The pages of the program and of verbs, but for one.
std::string see_also(std::string_view left_out) {
  std::vector<std::string> pages;
  if (!left_out.empty()) pages.push_back(bold("planish") + "(1)");
  for (const Command& command : commands()) {
    if (command.name != left_out) pages.push_back(bold("planish-" + command.name) + "(1)");
  }
  return section("SEE ALSO") + joined(pages, ", ") + "\n";
}

}  // namespace

std::string program_manual() {
  std::string text = head("planish", k_program_summary) + bold("planish") + " " + italic("VERB") +
                     " [flags] " + italic("INPUT") + " ...\n" + section("DESCRIPTION");
  text += paragraph(
      "Takes a curved patch of a product as a triangle mesh, measures how far it is from "
      "flattenable, changes it as little as it can towards that, lays it flat, and writes the "
      "true-size pattern. Each verb has a page of its own.");
  text += section("VERBS");
  for (const Command& command : commands())
    text += entry(bold(command.name), command.summary);
  text += section("FLAGS") + group_text(global_flags());
  return text + exit_codes_text() + examples_text(program_examples()) + see_also("");
}

std::string verb_manual(const Command& command) {
  std::string text = head("planish-" + command.name, command.summary) +
                     bold("planish " + command.name) + " " + roff(command.usage) + " [flags]\n" +
                     section("DESCRIPTION") + paragraph(command.description) + section("FLAGS");
  for (const FlagGroup& group : command.groups)
    text += group_text(group);
  text += group_text(global_flags());
  return text + exit_codes_text() + examples_text(command.examples) + see_also(command.name);
}

}  // namespace planish::cli
