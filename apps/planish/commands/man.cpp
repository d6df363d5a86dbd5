#include <algorithm>

#include <planish_json/json.h>

#include "commands/commands.h"
#include "manual/man_page.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

std::string page_of(const std::string& name) {
  const auto& all = commands();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Command& command) { return command.name == name; });
  return verb_manual(*found);
}

CommandResult run_man(const Arguments& arguments, Session&) {
  if (arguments.operands.empty()) {
    const std::string page = program_manual();
    return {page, json_document({{"verb", nullptr}, {"page", page}})};
  }
  std::vector<std::string> names;
  for (const Command& command : commands())
    names.push_back(command.name);
  const std::string name = known_name("verb", arguments.operands.front(), names);
  const std::string page = page_of(name);
  return {page, json_document({{"verb", name}, {"page", page}})};
}

}  // namespace

Command man_command() {
  return {"man",
          "manual page of the program or of a verb",
          "[VERB]",
          "Prints the manual page for the program man, with every flag of the verb. The Debian "
          "package of planish installs all these pages: man planish-flatten.",
          {"VERB"},
          {},
          {"planish man flatten | man -l -", "planish man > planish.1"},
          run_man,
          true,
          false,
          {{.type = ValueType::name}}};
}

}  // namespace planish::cli
