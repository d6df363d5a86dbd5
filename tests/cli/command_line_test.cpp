#include "shell/command_line.h"

#include <gtest/gtest.h>

namespace planish::cli {
namespace {

/// Of flatten.
std::string line_of(const Arguments& arguments) {
  Command flatten;
  flatten.name = "flatten";
  flatten.groups = {{"Input", {{"--weld", "LENGTH", "join", 0, false, {.optional = true}}}}};
  return command_line(flatten, arguments);
}

TEST(CommandLine, AsksForTheSame) {
  EXPECT_EQ(line_of({{"a.obj"}, {{"--max-strain", {"2%"}}, {"--remesh", {}}}}),
            "planish flatten a.obj --max-strain 2% --remesh");
}

TEST(CommandLine, PutsAValueThatMayBeLeftOutBehindAnEqualsSign) {
  EXPECT_EQ(line_of({{"a.obj"}, {{"--weld", {"0.1mm"}}}}), "planish flatten a.obj --weld=0.1mm");
  EXPECT_EQ(line_of({{"a.obj"}, {{"--weld", {}}}}), "planish flatten a.obj --weld");
}

TEST(CommandLine, LeavesOutWhatChangesNothing) {
  EXPECT_EQ(line_of({{"a.obj"}, {{"--json", {}}, {"--quiet", {}}, {"--threads", {"3"}}}}),
            "planish flatten a.obj");
}

TEST(CommandLine, QuotesAsAllShellsDo) {
  EXPECT_EQ(line_of({{"my mesh.obj"}, {{"--output", {"C:\\it's here"}}}}),
            "planish flatten \"my mesh.obj\" --output \"C:\\it's here\"");
  EXPECT_EQ(shell_word("out \\"), "'out \\'") << "in double quotes it would quote the second one";
  EXPECT_EQ(shell_word("50% more"), "'50% more'") << "cmd replaces names between such signs";
  EXPECT_EQ(shell_word(""), "''");
}

TEST(CommandLine, QuotesWhatHasAMeaningInDoubleQuotes) {
  EXPECT_EQ(line_of({{"it's $here.obj"}, {{"--output", {"$(x)"}}}}),
            "planish flatten 'it'\\''s $here.obj' --output '$(x)'");
}

}  // namespace
}  // namespace planish::cli
