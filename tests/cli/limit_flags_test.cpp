#include <gmock/gmock.h>

#include "cli_run.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;

class LimitFlags : public CliTest {
 protected:
  /// The options that a run of evolve was given, by its flags.
  static nlohmann::json options(const Names& flags) {
    Names args = {"evolve", "panel.obj", "-o", "out.obj", "--sweeps", "0", "--json"};
    args.insert(args.end(), flags.begin(), flags.end());
    const CliResult result = planish(args);
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    return result.json()["options"];
  }
};

TEST_F(LimitFlags, SharesMayBePerCent) {
  for (const char* text : {"2%", "0.02", ".02", "2.0%"}) {
    EXPECT_EQ(options({"--method", "auto", "--max-strain", text})["max_strain"], 0.02) << text;
    EXPECT_EQ(options({"--method", "auto", "--max-rms-strain", text})["max_rms_strain"], 0.02)
        << text;
  }
}

TEST_F(LimitFlags, AnglesMayNameTheirDegrees) {
  for (const Names& method : {Names{"--method", "auto"}, Names{}}) {
    for (const char* text : {"5deg", "5"}) {
      Names flags = method;
      flags.insert(flags.end(), {"--min-angle", text});
      EXPECT_EQ(options(flags)["min_angle"], 5.0) << text;
    }
  }
}

TEST_F(LimitFlags, LengthsAreConvertedToTheUnitOfTheModel) {
  struct Case {
    const char *text, *unit;
    double value;
  };
  for (const Case& c :
       {Case{"1.5", "cm", 1.5}, Case{"1.5mm", "mm", 1.5}, Case{"1.5cm", "mm", 15.0},
        Case{"0.5m", "mm", 500.0}, Case{"2in", "mm", 50.8}, Case{"5mm", "cm", 0.5},
        Case{"0.1in", "in", 0.1}, Case{"254mm", "in", 10.0}, Case{"3mm", "m", 0.003}}) {
    for (const char* method : {"auto", "controllable", "classical", "local_perturbation"}) {
      const auto given = options({"--method", method, "--max-deviation", c.text, "--unit", c.unit});
      EXPECT_DOUBLE_EQ(given["max_deviation"], c.value) << c.text << " in " << c.unit;
    }
  }
  EXPECT_EQ(options({"--max-deviation", "1cm"})["max_deviation"], 10.0) << "models are in mm";
}

TEST_F(LimitFlags, BordersStayOrSlideOrGoADistance) {
  const auto border = [](const char* text) {
    return options({"--method", "auto", "--unit", "cm", "--border", text})["border"];
  };
  EXPECT_EQ(options({"--method", "auto"})["border"], "fixed");
  EXPECT_EQ(border("fixed"), "fixed");
  EXPECT_EQ(border("slide"), "slide");
  EXPECT_EQ(border("5mm"), 0.5);
  EXPECT_EQ(border("2"), 2.0);
  for (const char* text : {"slid", "5lb", "-1", "nan"}) {
    const CliResult result = planish({"flatten", "panel.obj", "--border", text});
    EXPECT_EQ(result.exit_code, k_exit_usage) << text;
    EXPECT_THAT(result.err, HasSubstr("border")) << text;
  }
  const CliResult result = planish({"flatten", "panel.obj", "--border", "slid"});
  EXPECT_THAT(result.err, HasSubstr("slide"));
}

TEST_F(LimitFlags, WhatBecameOfABorderThatMovedIsTold) {
  const Names args = {"flatten", "panel.obj", "--border", "3mm"};
  Names with_json = args;
  with_json.push_back("--json");
  const auto json = planish(with_json).json();
  const auto border = json["evolve"]["border"];
  EXPECT_GT(border["max"], 0.3);
  EXPECT_LE(border["max"], 3.0 * (1.0 + 1e-12));
  EXPECT_GT(border["length_before"], 100.0);
  EXPECT_NE(border["length_before"], border["length_after"]);
  EXPECT_THAT(planish(args).out, HasSubstr("  border      moved by at most "));
  EXPECT_THAT(content_of("panel-pattern/report.html"), HasSubstr("Border, largest move"));
  const CliResult fixed = planish({"flatten", "panel.obj", "--json"});
  EXPECT_FALSE(fixed.json()["evolve"].contains("border"));
  EXPECT_THAT(content_of("panel-pattern/report.html"),
              testing::Not(HasSubstr("Border, largest move")));
}

TEST_F(LimitFlags, FlattenTakesThemAsAutoByItself) {
  const CliResult result = planish({"flatten", "panel.obj", "--unit", "cm", "--max-strain", "2%",
                                    "--max-deviation", "5mm", "--min-angle", "1deg", "--json"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  const auto evolve = result.json()["evolve"];
  EXPECT_EQ(evolve["method"], "auto");
  EXPECT_EQ(evolve["options"]["max_strain"], 0.02);
  EXPECT_EQ(evolve["options"]["max_deviation"], 0.5);
  EXPECT_EQ(evolve["options"]["min_angle"], 1.0);
  EXPECT_LE(evolve["deviation"]["max"], 0.5 * (1 + 1e-12));
}

TEST_F(LimitFlags, AMaterialIsItsStrain) {
  EXPECT_EQ(options({"--method", "auto", "--material", "leather"})["max_strain"], 0.01);
  EXPECT_EQ(options({"--method", "auto", "--material", "neoprene"})["max_strain"], 0.1);
}

TEST_F(LimitFlags, FlattenTellsWhetherThePatternKeepsTheLimit) {
  const Names args = {"flatten", "panel.obj", "--material", "cotton"};
  const CliResult result = planish(args);
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.out, HasSubstr("The strain limit of 5 % is "));
  Names with_json = args;
  with_json.push_back("--json");
  const auto limits = planish(with_json).json()["limits"];
  EXPECT_EQ(limits["max_strain"], 0.05);
  EXPECT_EQ(limits["met"], limits["largest_strain"] <= 0.05);
  EXPECT_EQ(limits["at"].size(), 3U);
  EXPECT_THAT(content_of("panel-pattern/report.html"), HasSubstr("The strain limit of 5 % is "));
  EXPECT_TRUE(planish({"flatten", "panel.obj", "--json"}).json()["limits"].is_null());
}

TEST_F(LimitFlags, ProgressOnLevelsTellsTheLevelAndItsStrain) {
  write_mesh("large.obj", make_shape("panel", 3000));
  const RunContext terminal = {.err_is_terminal = true};
  const CliResult result =
      planish({"evolve", "large.obj", "-o", "out.obj", "--method", "auto"}, terminal);
  EXPECT_THAT(result.err, HasSubstr("sweep 1  level of "));
  EXPECT_THAT(result.err, HasSubstr(" vertices  strain "));
}

}  // namespace
}  // namespace planish::cli
