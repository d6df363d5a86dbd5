#include <algorithm>

#include <gmock/gmock.h>

#include "cli_run.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;

/// Lines are broken at eighty columns.
std::string in_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

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
  const Names args = {"flatten", "panel.obj", "--border", "3mm", "--pick", "5"};
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
  const CliResult fixed = planish({"flatten", "panel.obj", "--pick", "5", "--json"});
  EXPECT_FALSE(fixed.json()["evolve"].contains("border"));
  EXPECT_THAT(content_of("panel-pattern/report.html"),
              testing::Not(HasSubstr("Border, largest move")));
}

TEST_F(LimitFlags, FlattenTakesThemAsAutoByItself) {
  const CliResult result = planish({"flatten", "panel.obj", "--unit", "cm", "--max-strain", "2%",
                                    "--max-deviation", "5mm", "--min-angle", "1deg", "--json"});
  ASSERT_EQ(result.exit_code, k_exit_target_missed) << "so near nothing keeps the limit";
  const auto evolve = result.json()["evolve"];
  EXPECT_EQ(evolve["method"], "auto");
  EXPECT_EQ(evolve["options"]["max_strain"], 0.02);
  EXPECT_EQ(evolve["options"]["max_deviation"], 0.5);
  EXPECT_EQ(evolve["options"]["min_angle"], 1.0);
  EXPECT_LE(evolve["deviation"]["max"], 0.5 * (1 + 1e-12));
}

TEST_F(LimitFlags, ABoundOfBendingThatIsMissedIsNamed) {
  const auto said = [](const char* bound) {
    const CliResult result = planish(
        {"evolve", "panel.obj", "-o", "bent.obj", "--method", "auto", "--max-bending", bound});
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    return result.out;
  };
  EXPECT_THAT(said("0.01"), HasSubstr("more than the 0.0100 of --max-bending\n"));
  EXPECT_THAT(said("2"), testing::Not(HasSubstr("--max-bending")));
}

TEST_F(LimitFlags, AMaterialIsItsStrain) {
  EXPECT_EQ(options({"--method", "auto", "--material", "leather"})["max_strain"], 0.01);
  EXPECT_EQ(options({"--method", "auto", "--material", "neoprene"})["max_strain"], 0.1);
}

TEST_F(LimitFlags, FlattenTellsWhetherThePatternKeepsTheLimit) {
  const Names args = {"flatten", "panel.obj", "--material", "cotton"};
  const CliResult result = planish(args);
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  const std::string kept = "The limit of 5 % for the strain on 99 % of the area is kept";
  EXPECT_THAT(in_one_line(result.out), HasSubstr("Within the 5.0 % that cotton takes"));
  EXPECT_THAT(content_of("panel-pattern/report.html"), HasSubstr(kept));
  Names with_json = args;
  with_json.push_back("--json");
  const auto limits = planish(with_json).json()["limits"];
  ASSERT_EQ(limits.size(), 1U);
  EXPECT_EQ(limits[0]["kind"], "p99");
  EXPECT_EQ(limits[0]["asked"], 0.05);
  EXPECT_EQ(limits[0]["kept"], true);
  EXPECT_LE(limits[0]["reached"], 0.05);
  EXPECT_EQ(limits[0]["where"]["at"].size(), 3U);
  EXPECT_EQ(planish({"flatten", "panel.obj", "--json"}).json()["limits"].size(), 0U);
}

TEST_F(LimitFlags, FlattenLeavesAPatchWhosePatternKeepsTheLimitAsItIs) {
  const CliResult result = planish({"flatten", "panel.obj", "--max-strain", "10%", "--json"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  const auto json = result.json();
  EXPECT_EQ(json["evolve"]["sweeps"], 0);
  EXPECT_EQ(json["evolve"]["stop"], "strain_met");
  EXPECT_EQ(json["evolve"]["deviation"]["max"], 0.0);
  EXPECT_EQ(content_of("panel-pattern/processed.obj"), content_of("panel.obj"));
}

TEST_F(LimitFlags, UnfoldTakesLimitsForEveryEdgeOrForTheArea) {
  const auto strain = [](const Names& flags) {
    Names args = {"unfold", "panel.obj", "-o", "out.svg", "--json"};
    args.insert(args.end(), flags.begin(), flags.end());
    const CliResult result = planish(args);
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    return result.json();
  };
  const auto least = strain({"--least-stretch"});
  const double half = 0.6 * least["strain"]["max"].get<double>();
  EXPECT_EQ(least["limits"].size(), 0U);
  EXPECT_TRUE(least["unlimited_strain"].is_null());
  const auto kept = strain({"--max-strain", std::to_string(half)});
  EXPECT_LE(kept["strain"]["max"], half);
  EXPECT_EQ(kept["limits"][0]["kind"], "max");
  EXPECT_NEAR(kept["unlimited_strain"]["max"], least["strain"]["max"], 1e-12);
  const auto both = strain({"--max-strain", "9%@p99", "--max-rms-strain", "9%"});
  EXPECT_EQ(both["limits"][0]["kind"], "p99");
  EXPECT_EQ(both["limits"][1]["kind"], "rms");
  EXPECT_EQ(both["strain"], strain({})["strain"]) << "it keeps them without";
}

TEST_F(LimitFlags, ALimitThatIsNotKeptEndsWithThreeAndIsWritten) {
  for (const std::string verb : {"unfold", "flatten"}) {
    Names args = {verb,           "panel.obj", "-o", verb == "unfold" ? "out.svg" : "out",
                  "--max-strain", "0.00001%"};
    if (verb == "flatten") args.insert(args.end(), {"--max-deviation", "0.01mm"});
    const CliResult result = planish(args);
    EXPECT_EQ(result.exit_code, k_exit_target_missed) << verb;
    EXPECT_THAT(result.err, HasSubstr("is not kept: the pattern has ")) << verb;
  }
  EXPECT_FALSE(content_of("out.svg").empty());
  EXPECT_FALSE(content_of("out/pattern.svg").empty());
}

TEST_F(LimitFlags, RefuseWhatIsNoLimit) {
  for (const std::string verb : {"unfold", "flatten"}) {
    const auto refused = [&](const Names& flags) {
      Names args = {verb, "panel.obj", "-o", "out.svg"};
      args.insert(args.end(), flags.begin(), flags.end());
      const CliResult result = planish(args);
      EXPECT_EQ(result.exit_code, k_exit_usage) << verb << " " << flags[1];
      return result.err;
    };
    for (const char* text : {"0", "-1%", "101%", "nan", "x", "5%@p98", "5%@", "@p99", "5"})
      EXPECT_THAT(refused({"--max-strain", text}), HasSubstr("--max-strain is ")) << text;
    EXPECT_THAT(refused({"--max-rms-strain", "0"}), HasSubstr("--max-rms-strain is 0 but"));
    EXPECT_THAT(refused({"--max-strain", "5%", "--material", "cotton"}), HasSubstr("give one"));
    EXPECT_THAT(refused({"--material", "coton"}), HasSubstr("cotton"));
  }
}

TEST_F(LimitFlags, RefuseNumbersThatAreNoLimitWithOneCode) {
  for (const std::string verb : {"unfold", "flatten", "measure", "suggest-cuts", "evolve"}) {
    for (const std::string flag : {"--max-strain", "--max-rms-strain"}) {
      if (verb == "suggest-cuts" && flag == "--max-rms-strain") continue;
      for (const char* text : {"nan", "-0.02", "inf", "2", "200%"}) {
        Names args = {verb, "panel.obj", flag, text, "--json"};
        if (verb != "measure") args.insert(args.end(), {"-o", "out.obj"});
        if (verb == "evolve") args.insert(args.end(), {"--method", "auto"});
        const CliResult result = planish(args);
        EXPECT_EQ(result.exit_code, k_exit_usage) << verb << flag << text;
        EXPECT_EQ(result.json()["error"]["code"], "option_out_of_range") << verb << flag << text;
      }
    }
  }
}

TEST_F(LimitFlags, OfMeasureTellWhetherSomePatternKeepsThem) {
  const auto strain = planish({"measure", "panel.obj", "--json"}).json()["strain"];
  const double smallest = strain["smallest_limit"];
  EXPECT_LT(smallest, strain["max"]);
  const CliResult kept =
      planish({"measure", "panel.obj", "--max-strain", std::to_string(1.05 * smallest)});
  EXPECT_EQ(kept.exit_code, k_exit_done) << kept.err;
  EXPECT_THAT(kept.out, HasSubstr("from a sheet that takes"));
  EXPECT_THAT(in_one_line(kept.out), HasSubstr("every edge is kept"));
  const CliResult beyond =
      planish({"measure", "panel.obj", "--max-strain", std::to_string(0.9 * smallest)});
  EXPECT_EQ(beyond.exit_code, k_exit_target_missed);
  EXPECT_THAT(beyond.err, HasSubstr("is not kept"));
}

TEST_F(LimitFlags, OfMeasureNeedAPatchThatCanBeLaidFlat) {
  write_mesh("closed.stl", TriMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
  EXPECT_EQ(planish({"measure", "closed.stl", "--json"}).json()["strain"], nullptr);
  const CliResult refused = planish({"measure", "closed.stl", "--max-strain", "5%"});
  EXPECT_EQ(refused.exit_code, k_exit_failed);
  EXPECT_THAT(refused.err, HasSubstr("closed.stl"));
}

}  // namespace
}  // namespace planish::cli
