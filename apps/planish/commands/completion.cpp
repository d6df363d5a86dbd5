#include "manual/completion.h"

#include <planish_json/json.h>

#include "commands/commands.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

std::vector<std::string> shell_names() {
  return {"bash", "zsh", "fish"};
}

CommandResult run_completion(const Arguments& arguments, Session&) {
  const std::string shell = known_name("shell", arguments.operands.front(), shell_names());
  const std::string script = shell == "bash"  ? bash_completion()
                             : shell == "zsh" ? zsh_completion()
                                              : fish_completion();
  return {script, json_document({{"shell", shell}, {"script", script}})};
}

}  // namespace

Command completion_command() {
  return {"completion",
          "script that completes verbs, flags and files in a shell",
          "SHELL",
          "Prints a script for " + list_of(shell_names()) +
              ". Once the shell has loaded it, the Tab key completes verbs, flags, their values, "
              "and files of the right kinds. The Debian package of planish installs these scripts.",
          {"SHELL"},
          {},
          {"source <(planish completion bash)", "planish completion zsh > ~/.zfunc/_planish",
           "planish completion fish > ~/.config/fish/completions/planish.fish"},
          run_completion,
          false,
          false,
          {{.choices = shell_names()}}};
}

}  // namespace planish::cli
