#include "shell/command_line.h"

#include <gtest/gtest.h>

namespace planish::cli {
namespace {

TEST(CommandLine, AsksForTheSame) {
  EXPECT_EQ(command_line("flatten", {{"a.obj"}, {{"--max-strain", "2%"}, {"--remesh", ""}}}),
            "planish flatten a.obj --max-strain 2% --remesh");
}

TEST(CommandLine, LeavesOutWhatChangesNothing) {
  EXPECT_EQ(
      command_line("flatten", {{"a.obj"}, {{"--json", ""}, {"--quiet", ""}, {"--threads", "3"}}}),
      "planish flatten a.obj");
}

TEST(CommandLine, QuotesAsAllShellsDo) {
  EXPECT_EQ(command_line("flatten", {{"my mesh.obj"}, {{"--output", "C:\\it's here"}}}),
            "planish flatten \"my mesh.obj\" --output \"C:\\it's here\"");
  EXPECT_EQ(shell_word("out \\"), "'out \\'") << "in double quotes it would quote the second one";
  EXPECT_EQ(shell_word("50% more"), "'50% more'") << "cmd replaces names between such signs";
  EXPECT_EQ(shell_word(""), "''");
}

TEST(CommandLine, QuotesWhatHasAMeaningInDoubleQuotes) {
  EXPECT_EQ(command_line("flatten", {{"it's $here.obj"}, {{"--output", "$(x)"}}}),
            "planish flatten 'it'\\''s $here.obj' --output '$(x)'");
}

}  // namespace
}  // namespace planish::cli
