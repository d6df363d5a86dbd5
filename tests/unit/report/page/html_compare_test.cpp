#include <cstdlib>
#include <string>
#include <vector>

#include <planish/report/html_report.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/charts/convergence_chart.h"
#include "report/page/compare_table.h"
#include "support/page.h"
#include "support/sample_comparison.h"

namespace planish {
namespace {

using pages::count;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string& comparison_page() {
  static const std::string page = html_report(samples::comparison());
  return page;
}

TEST(HtmlCompare, NeedsNothingFromOutsideAndClosesWhatItOpens) {
  pages::expect_nothing_from_outside(comparison_page());
  pages::expect_closed_tags(comparison_page());
}

TEST(HtmlCompare, EscapesAllTextFromOutside) {
  CompareReport report = samples::comparison();
  report.name = "<img src=x>\"&\xFF";
  report.runs[1].failure = {"unfold_failed", "<script>1</script>"};
  const std::string page = html_report(report);
  EXPECT_THAT(page, Not(HasSubstr("<img src=x")));
  EXPECT_THAT(page, Not(HasSubstr("<script>1")));
  EXPECT_THAT(page, Not(HasSubstr("\xFF")));
  EXPECT_THAT(page, Not(HasSubstr("<weights>")));
  EXPECT_THAT(page, HasSubstr("<h1>&lt;img src=x&gt;&quot;&amp;\uFFFD</h1>"));
  report.design_least_stretch.reset();
  report.why_no_patterns = "<b onclick=1>";
  EXPECT_THAT(html_report(report), Not(HasSubstr("<b onclick")));
}

TEST(HtmlCompare, SaysWhichIsBestAndWhatEachDid) {
  const std::string& page = comparison_page();
  EXPECT_THAT(page, HasSubstr("controllable did best: it lowered the strain of the pattern from "
                              "7.6\u00A0% to 2.6\u00A0% rms."));
  EXPECT_THAT(page, HasSubstr("worse pattern: strain 7.6 % -&gt; 8.6 %; needles (0.12 deg)"));
  EXPECT_THAT(page, HasSubstr("failed: no &lt;weights&gt; here"));
  EXPECT_THAT(page, HasSubstr("lambda 0.25, order sequential, max_deviation unlimited"));
  EXPECT_THAT(page, HasSubstr("4 sweeps in 3.2 s on 2 threads"));
  EXPECT_THAT(page, HasSubstr("no vertex moved any more"));
}

TEST(HtmlCompare, HasPicturesOfTheInputAndOfEveryResultAtOneSize) {
  const std::string& page = comparison_page();
  EXPECT_EQ(count(page, " alt=\"Patch, "), 3U) << "input and the two that did not fail";
  EXPECT_EQ(count(page, " alt=\"Pattern, "), 3U);
  const std::size_t at = page.find("<img width=");
  const std::string size = page.substr(at, page.find(" alt=", at) - at);
  EXPECT_EQ(count(page, size + " alt=\"Patch, "), 3U) << size;
  EXPECT_EQ(count(page, "<img "), 8U) << "and two of directions";
  EXPECT_EQ(count(page, "<svg class=\"chart\""), 6U);
}

TEST(HtmlCompare, DoesWithoutPatternsAndWithoutSweeps) {
  CompareReport report = samples::comparison();
  report.design_least_stretch.reset();
  report.why_no_patterns = "it is a tube";
  for (ComparedMethod& method : report.runs) {
    method.unfold.reset();
    if (method.evolve) method.evolve->result.history.clear();
  }
  const std::string page = html_report(report);
  EXPECT_THAT(page, HasSubstr("read the curvature left: it is a tube."));
  EXPECT_EQ(count(page, " alt=\"Pattern, "), 0U);
  EXPECT_THAT(page, Not(HasSubstr("<svg class=\"chart\"")));
  pages::expect_closed_tags(pages::without_pictures(page));
}

TEST(HtmlCompare, GivesTheSameBytesForTheSameReport) {
  EXPECT_TRUE(html_report(samples::comparison()) == comparison_page());
}

/// The row that begins at `from`.
std::string row_at(const std::string& table, std::size_t from) {
  return table.substr(from, table.find("</tr>", from) - from);
}

std::vector<double> numbers_in(const std::string& row) {
  std::vector<double> numbers;
  const std::string mark = "<data value=\"";
  for (std::size_t at = 0; (at = row.find(mark, at)) != std::string::npos; at += mark.size()) {
    numbers.push_back(std::strtod(row.c_str() + at + mark.size(), nullptr));
  }
  return numbers;
}

TEST(CompareTable, HasTheFiguresToTheLastDigit) {
  const CompareReport report = samples::comparison();
  const std::string table = compare_table(report);
  const auto& before = report.before.figures;
  EXPECT_THAT(numbers_in(row_at(table, table.find(">input<"))),
              ElementsAre(0.0763, 0.3241, before.sum_abs_defect, before.e_max, before.energy,
                          before.min_angle));
  const auto& after = report.runs[1].evolve->after.figures;
  EXPECT_THAT(numbers_in(row_at(table, table.find(">classical<"))),
              ElementsAre(0.0861, 0.4187, after.sum_abs_defect, after.e_max, 0.0123, 0.0123, 0.0021,
                          1.13, 0.31, 1.0, 4.0, 3.25));
  EXPECT_EQ(count(table, "<tr"), 5U) << "head, input and three runs";
}

TEST(CompareTable, MarksTheBestOfEachColumnWithAStar) {
  CompareReport report = samples::comparison();
  const auto stars = [&](const char* name) {
    const std::string table = compare_table(report);
    return count(row_at(table, table.find(name)), "★");
  };
  // The same in both: curvature left, e_max, bending and what of it was added. Strain rms and
  // worst, deviation, angle and time are better in the first, energy in the second.
  EXPECT_EQ(stars(">controllable<"), 9U);
  EXPECT_EQ(stars(">classical<"), 5U);
  EXPECT_EQ(stars(">input<"), 0U);
  report.runs[0].evolve->deviation.max = 0.0;
  EXPECT_EQ(stars(">controllable<"), 0U) << "who moved nothing is in no contest";
  EXPECT_EQ(stars(">classical<"), 10U);
}

TEST(ComparisonChart, HasALineAndANameForEveryMethodThatRan) {
  const CompareReport report = samples::comparison();
  for (const ChartAgainst against : {ChartAgainst::sweeps, ChartAgainst::seconds}) {
    const std::string svg = comparison_chart(report, k_chart_figures[2], against);
    EXPECT_EQ(count(svg, "<polyline"), 2U);
    EXPECT_EQ(count(svg, ">controllable</text>"), 1U);
    EXPECT_EQ(count(svg, ">classical</text>"), 1U);
    EXPECT_THAT(svg, HasSubstr("polyline class=\"line-0\""));
    EXPECT_THAT(svg, HasSubstr("polyline class=\"line-1\""));
    EXPECT_THAT(svg, HasSubstr("aria-label=\"energy against "));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
  }
}

TEST(ComparisonChart, KeepsManyNamesApartAndInside) {
  CompareReport report = samples::comparison();
  const ComparedMethod one = report.runs[0];
  report.runs.assign(12, one);
  const std::string svg = comparison_chart(report, k_chart_figures[0], ChartAgainst::sweeps);
  std::vector<double> places;
  for (std::size_t at = 0; (at = svg.find("text-anchor=\"start\"", at)) != std::string::npos;
       ++at) {
    places.push_back(std::strtod(svg.c_str() + svg.rfind(" y=\"", at) + 4, nullptr));
  }
  ASSERT_EQ(places.size(), 12U);
  for (std::size_t i = 1; i < places.size(); ++i)
    EXPECT_GE(places[i] - places[i - 1], 15.9);
  EXPECT_GE(places.front(), 10.0);
  EXPECT_LE(places.back(), 330.0 - 44.0 + 4.0);
}

}  // namespace
}  // namespace planish
