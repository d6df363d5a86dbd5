#include <fstream>
#include <iterator>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "output/app_page.h"

namespace planish::cli {
namespace {

class AppTest : public CliFolder {};

TEST_F(AppTest, WritesThePageOrSaysHowToGetOne) {
  const CliResult run = planish({"app", "-o", "page.html"});
  if (app_page().empty()) {
    EXPECT_EQ(run.exit_code, k_exit_failed);
    EXPECT_THAT(run.err, testing::HasSubstr("scripts/web makes its page"));
    EXPECT_FALSE(std::filesystem::exists("page.html"));
    return;
  }
  EXPECT_EQ(run.exit_code, k_exit_done) << run.err;
  std::string page;
  for (const std::string_view part : app_page())
    page += part;
  std::ifstream file("page.html", std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), page);
  EXPECT_THAT(page, testing::HasSubstr("Content-Security-Policy"));
}

}  // namespace
}  // namespace planish::cli
