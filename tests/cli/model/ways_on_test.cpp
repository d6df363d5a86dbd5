// The ways on after errors lead to flags and verbs that there are.

#include <regex>
#include <set>

#include <planish/core/ways_on.h>

#include "cli/cli_run.h"

namespace planish::cli {
namespace {

struct Known {
  std::set<std::string> flags, verbs;
};

Known known_words() {
  const nlohmann::json described = planish({"describe", "--json"}).json();
  Known known;
  const auto add = [&](const nlohmann::json& flags) {
    for (const auto& flag : flags)
      known.flags.insert(flag["name"].get<std::string>());
  };
  add(described["every_verb"]);
  for (const auto& verb : described["verbs"]) {
    known.verbs.insert(verb["name"].get<std::string>());
    for (const auto& group : verb["groups"])
      add(group["flags"]);
  }
  return known;
}

/// All that the pattern finds in the text, without what it begins with.
std::vector<std::string> found(const std::string& text, const std::string& pattern) {
  const std::regex words(pattern);
  std::vector<std::string> all;
  for (std::sregex_iterator at(text.begin(), text.end(), words), end; at != end; ++at)
    all.push_back((*at)[1]);
  return all;
}

TEST(WaysOn, NameFlagsAndVerbsThatThereAre) {
  const Known known = known_words();
  std::size_t flags = 0, verbs = 0;
  for (int number = 0; to_string(static_cast<ErrorCode>(number)) != "unknown"; ++number) {
    const auto code = static_cast<ErrorCode>(number);
    const std::string way(way_on(code));
    for (const std::string& flag : found(way, "(--[a-z-]+)")) {
      EXPECT_TRUE(known.flags.contains(flag)) << to_string(code) << ": " << flag;
      ++flags;
    }
    for (const std::string& verb : found(way, "planish ([a-z-]+)")) {
      EXPECT_TRUE(known.verbs.contains(verb)) << to_string(code) << ": " << verb;
      ++verbs;
    }
  }
  EXPECT_GT(flags, 30U);
  EXPECT_GT(verbs, 8U);
}

class WaysOnOfMeshes : public CliTest {};

TEST_F(WaysOnOfMeshes, StandBehindMessagesOfTheProgram) {
  write_mesh("closed.obj", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                            {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
  const std::string way(way_on(ErrorCode::closed_surface));
  const CliResult told = planish({"unfold", "closed.obj", "-o", "flat.svg", "--json"});
  EXPECT_EQ(told.exit_code, k_exit_failed);
  EXPECT_NE(told.err.find(way), std::string::npos) << told.err;
  EXPECT_NE(told.json()["error"]["message"].get<std::string>().find(way), std::string::npos);
}

}  // namespace
}  // namespace planish::cli
