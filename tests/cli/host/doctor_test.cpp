// `planish doctor`, and --open inside of another process.

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "platform/path.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

SystemFacts facts() {
  return {"Plan 9", "a processor", "plumb"};
}

SystemFacts poor_facts() {
  return {"Plan 9", "a processor", ""};
}

RunContext system(SystemFacts (*facts)()) {
  RunContext context;
  context.system_facts = facts;
  return context;
}

using Doctor = CliFolder;

TEST_F(Doctor, SaysInTenLinesOrSoWhatABugReportNeeds) {
  const CliResult result = planish({"doctor"}, system(facts));
  EXPECT_EQ(result.exit_code, k_exit_done);
  EXPECT_LE(std::count(result.out.begin(), result.out.end(), '\n'), 12);
  for (const char* words : {"Plan 9", "a processor", "plumb", "threads", "lanes"})
    EXPECT_THAT(result.out, HasSubstr(words));
  EXPECT_THAT(result.out, HasSubstr(utf8_of(std::filesystem::current_path())));
  EXPECT_TRUE(std::filesystem::is_empty(".")) << "the file that it tried with is left";
}

TEST_F(Doctor, SaysTheSameAsJson) {
  const nlohmann::json found = planish({"doctor", "--json"}, system(facts)).json();
  EXPECT_EQ(found["version"], planish({"--version", "--json"}).json()["version"]);
  EXPECT_EQ(found["system"], "Plan 9");
  EXPECT_EQ(found["processor"]["name"], "a processor");
  EXPECT_GE(found["threads"], 1);
  EXPECT_EQ(found["current_folder"]["writable"], true);
}

TEST_F(Doctor, NamesWhatIsMissing) {
  const nlohmann::json rich = planish({"doctor", "--json"}, system(facts)).json()["missing"];
  const nlohmann::json poor = planish({"doctor", "--json"}, system(poor_facts)).json()["missing"];
  EXPECT_EQ(poor.size(), rich.size() + 1);
  EXPECT_THAT(poor.dump(), HasSubstr("xdg-utils"));
  EXPECT_THAT(rich.dump(), Not(HasSubstr("xdg-utils")));
}

TEST_F(Doctor, RunsWhereNothingIsKnownOfTheSystem) {
  const CliResult result = planish({"doctor"});
  EXPECT_EQ(result.exit_code, k_exit_done);
  EXPECT_THAT(result.out, HasSubstr("not known"));
}

std::filesystem::path opened_page;

RunContext with_browser(std::string (*open)(const std::filesystem::path&)) {
  opened_page.clear();
  RunContext context;
  context.open_document = open;
  return context;
}

std::string opens(const std::filesystem::path& path) {
  opened_page = path;
  return std::filesystem::exists(path) ? "" : "it is not written yet";
}

std::string cannot_open(const std::filesystem::path&) {
  return "there is no screen";
}

using Open = CliTest;

TEST_F(Open, OpensThePageThatWasWritten) {
  const RunContext context = with_browser(opens);
  const CliResult result = planish({"flatten", "panel.obj", "--pick", "1", "--open"}, context);
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_EQ(opened_page, std::filesystem::absolute("panel-pattern/report.html"));
  EXPECT_THAT(result.err, Not(HasSubstr("cannot open")));
  planish({"flatten", "panel.obj", "--pick", "1"}, with_browser(opens));
  EXPECT_THAT(opened_page.string(), IsEmpty());
}

TEST_F(Open, OpensThePageOfAProduct) {
  std::filesystem::copy_file("panel.obj", "other.obj");
  const Names args = {"flatten", "panel.obj", "other.obj", "--product", "--pick",
                      "1",       "-o",        "out",       "--open"};
  const CliResult result = planish(args, with_browser(opens));
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_EQ(opened_page, std::filesystem::absolute("out/garment.html"));
}

TEST_F(Open, SaysOnceWhyAPageCannotBeOpenedAndEndsAsElse) {
  const Names args = {"flatten", "panel.obj", "--pick", "1", "--open"};
  const CliResult result = planish(args, with_browser(cannot_open));
  EXPECT_EQ(result.exit_code, k_exit_done);
  EXPECT_THAT(result.err,
              HasSubstr("note: cannot open panel-pattern/report.html: there is no screen\n"));
  EXPECT_EQ(planish(args).exit_code, k_exit_done);
}

TEST_F(Open, IsNotForRunsThatWriteNoPage) {
  const RunContext context = with_browser(opens);
  for (const Names& args :
       {Names{"compare", "panel.obj", "--open"}, Names{"frontier", "panel.obj", "--open"},
        Names{"frontier", "panel.obj", "-o", "x.svg", "--open"},
        Names{"compare", "panel.obj", "panel.obj", "-o", "out", "--open"}}) {
    const CliResult result = planish(args, context);
    EXPECT_EQ(result.exit_code, k_exit_usage) << testing::PrintToString(args);
    EXPECT_THAT(result.err, HasSubstr("--open"));
  }
}

TEST_F(Open, IsNotInTheCommandLineOfTheReport) {
  planish({"flatten", "panel.obj", "--pick", "1", "--open"}, with_browser(opens));
  std::ifstream file("panel-pattern/report.html");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(page, HasSubstr("planish flatten panel.obj"));
  EXPECT_THAT(page, Not(HasSubstr("--open")));
}

}  // namespace
}  // namespace planish::cli
