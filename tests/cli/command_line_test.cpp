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

TEST(CommandLine, QuotesForAShell) {
  EXPECT_EQ(command_line("flatten", {{"it's here.obj"}, {{"--output", "$(x)"}}}),
            "planish flatten 'it'\\''s here.obj' --output '$(x)'");
}

}  // namespace
}  // namespace planish::cli
