#include <algorithm>
#include <cstdlib>
#include <set>

#include <gmock/gmock.h>

#include "cli_run.h"
#include "commands/commands.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;

struct Mistake {
  Names args;
  std::string message;
};

/// Names the test after what was typed.
void PrintTo(const Mistake& mistake, std::ostream* out) {
  for (const std::string& arg : mistake.args)
    *out << (&arg == &mistake.args.front() ? "" : " ") << arg;
}

class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, EndWithTwoAndAMessageOnStandardErrorOnly) {
  const CliResult result = planish(GetParam().args);
  EXPECT_EQ(result.exit_code, k_exit_usage);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, HasSubstr(GetParam().message));
}

TEST_P(Mistakes, AreOneJsonObjectWithJson) {
  Names args = GetParam().args;
  args.insert(args.begin(), "--json");
  const CliResult result = planish(args);
  EXPECT_EQ(result.exit_code, k_exit_usage);
  EXPECT_THAT(result.json()["error"]["message"].get<std::string>(), HasSubstr(GetParam().message));
  EXPECT_THAT(result.err, HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Flags, Mistakes,
    testing::Values(
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--sweps", "3"},
                "unknown flag --sweps; did you mean --sweeps?"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--sweps=3"},
                "unknown flag --sweps; did you mean --sweeps?"},
        Mistake{{"--jsn", "measure", "a.obj"}, "unknown flag --jsn; did you mean --json?"},
        Mistake{{"measure", "a.obj", "--foo"}, "unknown flag --foo"},
        Mistake{{"measure", "a.obj", "-x"}, "unknown flag -x"},
        Mistake{{"measure", "a.obj", "--sweeps", "3"},
                "flag --sweeps belongs to flatten, evolve or compare, not measure"},
        Mistake{{"--sweeps", "3", "evolve", "a.obj"},
                "must stand behind the verb: planish evolve --sweeps"},
        Mistake{{"--sweeps", "3"}, "flag --sweeps belongs to flatten, evolve or compare"},
        Mistake{{"evolve", "a.obj", "-o"}, "flag -o needs a value"},
        Mistake{{"measure", "a.obj", "--threads"}, "flag --threads needs a value"},
        Mistake{{"measure", "a.obj", "--quiet=yes"}, "flag --quiet takes no value"},
        Mistake{{"evolve", "a.obj", "--remesh=1"}, "flag --remesh takes no value"},
        Mistake{{"evolve", "a.obj", "-qx", "-o", "b.obj"}, "unknown flag -x"},
        Mistake{{"evolve", "a.obj", "-qo"}, "flag -o needs a value"},
        Mistake{{"evolve", "a.obj", "-ob.obj", "--sweeps=-1"}, "--sweeps is -1"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--method="}, "flag --method needs a value"},
        Mistake{{"measure", "---x"}, "unknown flag ---x"}));

INSTANTIATE_TEST_SUITE_P(
    Operands, Mistakes,
    testing::Values(Mistake{{"--quiet"}, "no verb given"},
                    Mistake{{"mesure", "a.obj"}, "unknown verb mesure; did you mean measure?"},
                    Mistake{{"help"}, "unknown verb help; did you mean --help?"},
                    Mistake{{"a.obj"}, "did you mean planish flatten a.obj?"},
                    Mistake{{"measure"}, "missing INPUT: planish measure INPUT"},
                    Mistake{{"convert", "a.obj"}, "missing OUTPUT"},
                    Mistake{{"carry", "a.obj", "-o", "b.obj"}, "missing flag --from"},
                    Mistake{{"convert", "a.obj", "a.ply", "b.obj"}, "unexpected argument b.obj"},
                    Mistake{{"evolve", "a.obj"}, "missing flag -o"},
                    Mistake{{"sample", "panel"}, "missing flag -o"},
                    Mistake{{"evolve", "a.obj", "-o", "b.obj", "--history", "./b.obj"},
                            "two outputs have the same path"}));

INSTANTIATE_TEST_SUITE_P(
    Patterns, Mistakes,
    testing::Values(
        Mistake{{"unfold", "a.obj", "-o", "b.svg", "--paper", "a4"},
                "flag --paper goes with pdf only"},
        Mistake{{"unfold", "a.obj", "-o", "b.pdf", "--paper", "a5"}, "unknown paper a5"},
        Mistake{{"unfold", "a.obj", "-o", "b.obj", "--text", "strokes"},
                "flag --text goes with svg, dxf, pdf and plt only"},
        Mistake{{"unfold", "a.obj", "-o", "b.dxf", "--dxf-layers", "cutt=A"},
                "unknown layer cutt; did you mean cut?"},
        Mistake{{"unfold", "a.obj", "-o", "b.dxf", "--dxf-layers", "cut"},
                "must be like cut=LASER,label=NOTES"},
        Mistake{{"flatten", "a.obj", "--formats", "svg,dwg"}, "unknown format dwg"},
        Mistake{{"flatten", "a.obj", "--formats", "svg", "--dxf-profile", "clo"},
                "flag --dxf-profile goes with dxf only"},
        Mistake{{"flatten", "a.obj", "--dxf-profile", "cloo"}, "unknown profile cloo"}));

INSTANTIATE_TEST_SUITE_P(
    Values, Mistakes,
    testing::Values(
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--sweeps", "many"},
                "--sweeps is \"many\" but must be a whole number"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--sweeps", "2.5"}, "must be a whole number"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--sweeps", "99999999999"}, "smaller number"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--max-deviation", "1e999mm"}, "smaller number"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--max-deviation", "-inf"}, "at least 0"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--sweeps", "-1"}, "--sweeps is -1"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--lambda-max", "11"}, "must be from 0 to 10"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--lambda-max", "0,5"}, "must be a number"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--lambda-max", "nan"}, "--lambda-max is nan"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--lambda-max", ""},
                "flag --lambda-max needs a value, and the one given is empty"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--history", ""}, "--history needs a value"},
        Mistake{{"evolve", "a.obj", "-o", ""}, "flag --output needs a value"},
        Mistake{{"evolve", "", "a.obj", "-o", "out"},
                "INPUT needs a value, and the one given is empty"},
        Mistake{{"flatten", "a.obj", "--", ""}, "INPUT needs a value"},
        Mistake{{"convert", "a.obj", ""}, "OUTPUT needs a value"},
        Mistake{{"flatten", "a.obj", "--threads", ""}, "--threads needs a value"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--lambda", "0.5"},
                "method controllable has no flag --lambda; it belongs to --method classical"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--method", "clasical"},
                "unknown method clasical; did you mean classical?"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--method", "classical", "--order", "random"},
                "unknown order random"},
        Mistake{{"flatten", "a.obj", "--unit", "ft"}, "unknown unit ft"},
        Mistake{{"flatten", "a.obj", "--unit", "0.5m"}, "give --unit m --scale 0.5"},
        Mistake{{"flatten", "a.obj", "--unit", "2 inches"}, "give --unit in --scale 2"},
        Mistake{{"measure", "a.obj", "--scale", "0"}, "--scale is 0"},
        Mistake{{"measure", "a.obj", "--scale", "2m"}, "--scale is \"2m\" but must be a number"},
        Mistake{{"flatten", "a.obj", "--max-strain", "2pct"},
                "--max-strain is \"2pct\" but must be a share such as 0.02 or 2%"},
        Mistake{{"flatten", "a.obj", "--max-strain", "2"}, "did you mean 2%?"},
        Mistake{{"flatten", "a.obj", "--max-strain", "200%"}, "--max-strain is 2 but must be"},
        Mistake{{"flatten", "a.obj", "--max-strain", "2mm"}, "must be a share"},
        Mistake{{"flatten", "a.obj", "--max-deviation", "5ft"},
                "--max-deviation is \"5ft\" but must be a length such as 1.5 (model units), "
                "1.5mm, 1.5cm, 1.5m or 1.5in"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--max-deviation", "5%"}, "must be a length"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--max-deviation", "-1mm"},
                "--max-deviation is -1"},
        Mistake{{"flatten", "a.obj", "--min-angle", "5rad"},
                "--min-angle is \"5rad\" but must be an angle in degrees such as 5 or 5deg"},
        Mistake{{"flatten", "a.obj", "--closeness", "2%"}, "must be a number"},
        Mistake{{"flatten", "a.obj", "--max-bending", "2", "--prefer", "near"},
                "--max-bending belongs to --prefer smooth or flat, not to --prefer near"},
        Mistake{{"flatten", "a.obj", "--max-bending", "2", "--closeness", "1"},
                "--max-bending belongs to --prefer smooth or flat, not to --closeness"},
        Mistake{{"flatten", "a.obj", "--max-bending", "-1"}, "--max-bending is -1"},
        Mistake{{"flatten", "a.obj", "--material", "lether"},
                "unknown material lether; did you mean leather?"},
        Mistake{{"flatten", "a.obj", "--material", "10%"}, "give --max-strain 10%, or"},
        Mistake{{"flatten", "a.obj", "--unit", "kilometre"}, "unknown unit kilometre (there are"},
        Mistake{{"flatten", "a.obj", "--material", "leather", "--max-strain", "1%"},
                "--material and --max-strain both say what strain is allowed"},
        Mistake{{"evolve", "a.obj", "-o", "b.obj", "--material", "leather"},
                "method controllable has no flag --material; it belongs to --method auto"},
        Mistake{{"flatten", "a.obj", "--colors", "papre"}, "did you mean paper?"},
        Mistake{{"measure", "a.obj", "--threads", "-2"}, "--threads is -2"},
        Mistake{{"sample", "panl", "-o", "a.obj"}, "unknown sample panl; did you mean panel?"},
        Mistake{{"sample", "panel", "-o", "a.obj", "--vertices", "99"}, "--vertices is 99"},
        Mistake{{"sample", "panel", "-o", "a.obj", "--vertices", "1e5"}, "whole number"}));

class Words : public CliTest {};

TEST_F(Words, NameUnitsAndChoicesInCapitalsAndInFull) {
  const auto pattern = [](const std::string& unit) {
    return planish({"unfold", "panel.obj", "-o", "a.svg", "--unit", unit, "--json"}).json();
  };
  const auto expect_same = [&](const std::string& unit, const Names& words) {
    for (const std::string& word : words)
      EXPECT_EQ(pattern(word)["unit"], unit) << word;
  };
  expect_same("mm", {"MM", "millimetre", "millimeters"});
  expect_same("cm", {"cm", "Centimetres", "centimeter"});
  expect_same("m", {"M", "metre", "meter", "metres", "Meters"});
  expect_same("in", {"inch", "Inches", "\""});
  const Names args = {"unfold", "panel.obj",  "-o",       "a.pdf",       "--paper",
                      "A4",     "--material", "Neoprene", "--allowance", "1 Inch"};
  EXPECT_EQ(planish(args).exit_code, k_exit_done) << planish(args).err;
}

TEST(Usage, NoArgumentsGiveAShortHelpOnStandardError) {
  const CliResult result = planish({});
  EXPECT_EQ(result.exit_code, k_exit_usage);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, HasSubstr("planish flatten panel.obj"));
  EXPECT_THAT(result.err, HasSubstr("planish measure panel.obj"));
}

TEST(Usage, NotesThatTheLastOfTwoValuesCounts) {
  const CliResult result = planish({"materials", "--json", "--threads", "1", "--threads", "1"});
  EXPECT_EQ(result.err.find("the last one counts"), std::string::npos) << "of equal values";
  const CliResult two = planish({"materials", "--threads=2", "--threads", "1"});
  EXPECT_EQ(two.exit_code, k_exit_done);
  EXPECT_THAT(two.err, HasSubstr("--threads is given as 2 and as 1; the last one counts"));
}

TEST(Usage, VersionIsOneLine) {
  EXPECT_EQ(planish({"--version"}).out, "planish 0.2.0\n");
  EXPECT_EQ(planish({"evolve", "--version"}).exit_code, k_exit_done);
  EXPECT_EQ(planish({"--json", "--version"}).json()["version"], "0.2.0");
}

/// Compares with tests/golden/help/NAME; with PLANISH_UPDATE_GOLDENS set, writes it.
void expect_golden(const std::string& name, const std::string& text) {
  const std::filesystem::path path = std::filesystem::path(PLANISH_GOLDEN_FOLDER) / "help" / name;
  if (std::getenv("PLANISH_UPDATE_GOLDENS") != nullptr) {
    std::ofstream(path, std::ios::binary) << text;
  }
  EXPECT_EQ(text, content_of(path)) << "PLANISH_UPDATE_GOLDENS=1 writes " << path;
}

TEST(Help, IsAsWrittenDown) {
  expect_golden("help.txt", planish({"--help"}).out);
  for (const Command& command : commands()) {
    const CliResult result = planish({command.name, "--help"});
    EXPECT_EQ(result.exit_code, k_exit_done);
    EXPECT_EQ(result.err, "");
    expect_golden("help_" + command.name + ".txt", result.out);
    const std::string all = planish({command.name, "--help-all"}).out;
    if (has_first_flags(command)) {
      expect_golden("help_all_" + command.name + ".txt", all);
    } else {
      EXPECT_EQ(all, result.out);
    }
    EXPECT_EQ(planish({"--help", command.name}).out, result.out);
  }
}

TEST(Help, ShowsTheUsualFlagsOfVerbsWithMany) {
  constexpr std::size_t many = 25;
  for (const Command& command : commands()) {
    std::set<std::string> all, first;
    for (const FlagGroup& group : command.groups) {
      for (const Flag& flag : group.flags) {
        all.insert(flag.name);
        if (flag.first) first.insert(flag.name);
      }
    }
    EXPECT_EQ(has_first_flags(command), all.size() > many) << command.name << all.size();
    if (first.empty()) continue;
    EXPECT_EQ(first.size(), 12U) << command.name;
    const std::string help = planish({command.name, "--help"}).out;
    EXPECT_LE(std::count(help.begin(), help.end(), '\n'), 60) << command.name;
    EXPECT_TRUE(help.ends_with("All: planish " + command.name + " --help-all\n")) << help;
    for (const std::string& flag : first)
      EXPECT_THAT(help, HasSubstr(flag));
  }
}

TEST(Help, FitsEightyColumns) {
  std::vector<Names> all = {{"--help"}};
  for (const Command& command : commands())
    for (const char* flag : {"--help", "--help-all"})
      all.push_back({command.name, flag});
  for (const Names& args : all) {
    std::istringstream lines(planish(args).out);
    for (std::string line; std::getline(lines, line);)
      EXPECT_LE(line.size(), 80U) << line;
  }
}

TEST(Help, WinsOverOtherFaults) {
  EXPECT_EQ(planish({"evolve", "--help", "--nonsense"}).exit_code, k_exit_done);
}

}  // namespace
}  // namespace planish::cli
