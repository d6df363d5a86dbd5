// `planish describe` says of every flag what the program itself takes.

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include <gmock/gmock.h>

#include "cli_run.h"
#include "commands/commands.h"
#include "shell/values.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;

/// Calls visit(verb, group, flag) for every flag of every verb.
template <class Visit>
void for_each_flag(const nlohmann::json& description, const Visit& visit) {
  for (const nlohmann::json& verb : description["verbs"]) {
    for (const nlohmann::json& group : verb["groups"]) {
      for (const nlohmann::json& flag : group["flags"])
        visit(verb, group, flag);
    }
  }
}

nlohmann::json description() {
  const CliResult result = planish({"describe", "--json"});
  EXPECT_EQ(result.exit_code, k_exit_done);
  return result.json();
}

TEST(Describe, NamesEveryVerbAndFlagOfTheHelp) {
  const nlohmann::json all = description();
  EXPECT_EQ(all["schema"], 2);
  EXPECT_EQ(all["version"], "0.2.0");
  ASSERT_EQ(all["verbs"].size(), commands().size());
  std::set<std::pair<std::string, std::string>> described;
  for_each_flag(
      all, [&](const nlohmann::json& verb, const nlohmann::json&, const nlohmann::json& flag) {
        described.emplace(verb["name"].get<std::string>(), flag["name"].get<std::string>());
      });
  for (const Command& command : commands()) {
    const std::string help = planish({command.name, "--help-all"}).out;
    for (std::size_t at = help.find("      --"); at != std::string::npos;
         at = help.find("      --", at + 1)) {
      const std::string name = help.substr(at + 6, help.find_first_of(" [\n", at + 6) - at - 6);
      const auto& global = global_flags().flags;
      const bool is_global = std::any_of(global.begin(), global.end(),
                                         [&](const Flag& flag) { return flag.name == name; });
      EXPECT_NE(is_global, described.contains({command.name, name})) << command.name << name;
    }
  }
}

TEST(Describe, SaysTheDefaultAndTheChoicesThatTheHelpTells) {
  for (const Command& command : commands()) {
    for (const FlagGroup& group : command.groups) {
      for (const Flag& flag : group.flags) {
        const std::string& standard = flag.accepts.standard;
        if (!standard.empty()) {
          EXPECT_THAT(flag.doc, HasSubstr("default " + standard)) << flag.name;
        }
        for (const std::string& choice : flag.accepts.choices)
          EXPECT_THAT(flag.doc, HasSubstr(choice)) << flag.name;
        const bool is_name = type_of(flag) == ValueType::name || type_of(flag) == ValueType::names;
        EXPECT_EQ(is_name && flag.accepts.choices.empty(), false) << flag.name;
      }
    }
  }
}

TEST(Describe, SaysOfEveryOperandWhatItTakes) {
  const nlohmann::json all = description();
  for (const nlohmann::json& verb : all["verbs"]) {
    EXPECT_EQ(verb["operand_values"].size(), verb["operands"].size()) << verb["name"];
    for (const nlohmann::json& operand : verb["operand_values"]) {
      EXPECT_EQ(operand["type"] == "name", !operand["choices"].empty()) << verb["name"];
      // A material has a name, or a file of one's own.
      const bool names_files = operand["type"] == "file" || verb["name"] == "materials";
      EXPECT_EQ(names_files, !operand["extensions"].empty()) << verb["name"];
    }
  }
}

TEST(Describe, NamesEndingsOfFilesThatTheHelpTells) {
  for_each_flag(description(),
                [&](const nlohmann::json& verb, const nlohmann::json&, const nlohmann::json& flag) {
                  const std::string help = flag["help"];
                  for (const std::string extension : flag["extensions"]) {
                    EXPECT_TRUE(flag["type"] == "file" || flag["name"] == "--material");
                    const bool is_told = help.find("." + extension) != std::string::npos ||
                                         help.find("comma-separated") != std::string::npos ||
                                         help.find("mesh") != std::string::npos;
                    EXPECT_TRUE(is_told) << verb["name"] << flag["name"] << extension;
                  }
                });
}

/// The verb at work on a small patch, and the flag with a value.
std::vector<std::string> command_with(const nlohmann::json& verb, const nlohmann::json& group,
                                      const std::string& flag, const std::string& value) {
  const std::string name = verb["name"];
  std::vector<std::string> words = {name};
  if (name == "sample") words.emplace_back("panel");
  if (name != "sample") words.emplace_back("patch.obj");
  if (name == "carry") words.insert(words.end(), {"--from", "patch.obj", "--to", "patch.obj"});
  if (name == "convert") words.emplace_back("out.obj");
  if (name != "measure" && name != "convert") {
    words.emplace_back("--output");
    const bool draws = name == "unfold" || name == "frontier";
    const std::string drawing = flag == "--paper" || flag == "--page-overlap" ? "out.pdf"
                                : flag.starts_with("--dxf-")                  ? "out.dxf"
                                                                              : "out.svg";
    words.push_back(draws ? drawing : "out.obj");
  }
  if (group["method"].is_string()) {
    words.emplace_back("--method");
    words.push_back(group["method"]);
  }
  for (const auto& [dependent, other, with] :
       {std::tuple{"--corners", "--allowance", "5"}, std::tuple{"--nest-gap", "--sheet", "1500mm"},
        std::tuple{"--nest-margin", "--sheet", "1500mm"}, std::tuple{"--turn", "--sheet", "1500mm"},
        std::tuple{"--seam-tolerance", "--sheet", "1500mm"},
        std::tuple{"--dxf-notches", "--dxf-profile", "aama"},
        std::tuple{"--page-overlap", "--paper", "a4"}}) {
    if (flag != dependent) continue;
    words.emplace_back(other);
    words.emplace_back(with);
  }
  words.push_back(flag + "=" + value);
  return words;
}

class DescribedValues : public CliFolder {
 protected:
  void SetUp() override {
    CliFolder::SetUp();
    planish({"sample", "panel", "--vertices", "100", "-o", "patch.obj"});
  }
};

void expect_refused(const nlohmann::json& verb, const nlohmann::json& group,
                    const nlohmann::json& flag, const std::string& value) {
  const auto words = command_with(verb, group, flag["name"], value);
  const CliResult result = planish(words);
  EXPECT_EQ(result.exit_code, k_exit_usage) << testing::PrintToString(words) << result.err;
  EXPECT_THAT(result.err, HasSubstr(value)) << result.err;
}

TEST_F(DescribedValues, OtherNamesThanTheChoicesAreRefused) {
  for_each_flag(description(), [&](const nlohmann::json& verb, const nlohmann::json& group,
                                   const nlohmann::json& flag) {
    if (flag["type"] == "name" || flag["type"] == "names")
      expect_refused(verb, group, flag, "nonesuch");
  });
}

TEST_F(DescribedValues, NumbersOutsideOfTheRangeAreRefused) {
  for_each_flag(description(), [&](const nlohmann::json& verb, const nlohmann::json& group,
                                   const nlohmann::json& flag) {
    // Notches need a file, and borders of patches a product.
    if (flag["name"] == "--notch-depth" || flag["name"] == "--seam-tolerance") return;
    if (flag["type"] == "text") return;
    if (flag["min"].is_number() && flag["min"] > -1e9)
      expect_refused(verb, group, flag, plain(flag["min"].get<double>() - 1.0));
    if (flag["max"].is_number() && flag["max"] < 1e9)
      expect_refused(verb, group, flag, plain(flag["max"].get<double>() + 1.0));
  });
}

TEST(Describe, GivesNumbersInTheUnitOfTheirType) {
  std::set<std::string> seen;
  for_each_flag(description(), [&](const nlohmann::json& verb, const nlohmann::json&,
                                   const nlohmann::json& flag) {
    const std::string type = flag["type"], name = flag["name"];
    seen.insert(type);
    if (type == "integer" || type == "number" || type == "angle" || type == "radians") {
      EXPECT_TRUE(flag["default"].is_number() || flag["default"].is_null()) << name;
    }
    if (name == "--max-strain" && verb["name"] == "suggest-cuts") {
      EXPECT_EQ(flag["default"], 0.02);
      EXPECT_EQ(flag["unit"], "fraction");
    }
    if (name == "--min-angle") {
      EXPECT_EQ(flag["unit"], "degrees");
      EXPECT_EQ(flag["max"], 60.0);
    }
    if (type == "switch") {
      EXPECT_EQ(flag["default"], false) << name;
    }
  });
  EXPECT_EQ(seen.size(), 12U);
}

TEST(Describe, TakesAVerb) {
  const CliResult result = planish({"describe", "sample"});
  EXPECT_THAT(result.out, HasSubstr("--vertices"));
  EXPECT_THAT(result.out, HasSubstr("integer, 100 to 10000000; default 5000"));
  EXPECT_THAT(result.out, testing::Not(HasSubstr("--allowance")));
  EXPECT_EQ(planish({"describe", "fold", "--json"}).exit_code, k_exit_usage);
}

}  // namespace
}  // namespace planish::cli
