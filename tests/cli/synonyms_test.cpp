// Names of flags that people type although the program calls them something else, or has none.

#include "flags/synonyms.h"

#include <gmock/gmock.h>

#include "cli_run.h"
#include "commands/commands.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;

bool is_a_flag(std::string_view name) {
  return std::any_of(commands().begin(), commands().end(),
                     [&](const Command& command) { return find_flag(command, name) != nullptr; });
}

TEST(Aliases, AreNoFlagsOfTheirOwn) {
  for (const Command& command : commands()) {
    for (const FlagGroup& group : command.groups) {
      for (const Flag& flag : group.flags) {
        EXPECT_EQ(without_alias(flag.name), flag.name);
        EXPECT_EQ(missing_flag_advice(flag.name), "") << flag.name;
        for (const std::string& alias : aliases_of(flag.name)) {
          EXPECT_FALSE(is_a_flag(alias)) << alias;
          EXPECT_EQ(missing_flag_advice(alias), "") << alias;
          EXPECT_EQ(without_alias(alias), flag.name);
        }
      }
    }
  }
}

class AliasesTyped : public CliTest {};

TEST_F(AliasesTyped, MeanTheSameAsTheFlag) {
  const Names plain = {"unfold", "panel.obj",   "--output", "a.svg",        "--unit",
                       "cm",     "--allowance", "10mm",     "--max-strain", "5%"};
  const Names other = {
      "unfold",        "panel.obj", "--out", "b.svg", "--units", "cm", "--seam-allowance=10mm",
      "--max-stretch", "5%"};
  EXPECT_EQ(planish(plain).exit_code, k_exit_done);
  const CliResult result = planish(other);
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  std::ifstream a("a.svg"), b("b.svg");
  const std::string in_a{std::istreambuf_iterator<char>(a), {}};
  EXPECT_EQ(in_a, std::string(std::istreambuf_iterator<char>(b), {}));
  EXPECT_THAT(in_a, HasSubstr("<svg"));
}

TEST_F(AliasesTyped, CountForFlagsThatMustBeThere) {
  EXPECT_EQ(planish({"evolve", "panel.obj", "--out", "b.obj", "--sweeps", "1"}).exit_code,
            k_exit_done);
}

TEST(Aliases, LeadToTheFlagOfOtherVerbs) {
  EXPECT_THAT(planish({"measure", "a.obj", "--seam-allowance", "1"}).err,
              HasSubstr("flag --seam-allowance (--allowance) belongs to flatten"));
}

TEST(Aliases, AreNamedWhereTheyAreNear) {
  EXPECT_THAT(planish({"flatten", "a.obj", "--seam-alowance", "1"}).err,
              HasSubstr("did you mean --seam-allowance?"));
}

TEST(Aliases, AreDescribed) {
  const auto described = planish({"describe", "unfold", "--json"}).json();
  for (const auto& group : described["verbs"][0]["groups"]) {
    for (const auto& flag : group["flags"]) {
      if (flag["name"] != "--unit") continue;
      EXPECT_EQ(flag["aliases"], nlohmann::json::array({"--units"}));
    }
  }
}

TEST(MissingFlags, AreExplainedAndNeverMistakenForOthers) {
  for (const char* flag : {"--bend-lines", "--rulings", "--thickness", "--no-strain-map",
                           "--bend-radius", "--thickness=2", "--smooth"}) {
    const CliResult result = planish({"flatten", "a.obj", flag});
    EXPECT_EQ(result.exit_code, k_exit_usage);
    EXPECT_THAT(result.err, HasSubstr("there is no flag --")) << flag;
    EXPECT_THAT(result.err, testing::Not(HasSubstr("did you mean"))) << flag;
  }
  EXPECT_THAT(planish({"flatten", "a.obj", "--no-remesh"}).err,
              HasSubstr("there is no flag --no-remesh: --remesh is off unless given"));
}

}  // namespace
}  // namespace planish::cli
