#include <algorithm>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include <planish/report/html_report.h>
#include <planish/sheet/pattern_sheet.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/page/figures_table.h"
#include "report/page/page_assets.h"
#include "support/page.h"
#include "support/sample_report.h"

namespace planish {
namespace {

using pages::count;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// The page of the sample, made once for all tests that only look at it.
const std::string& report_page() {
  static const std::string page = html_report(samples::flatten_report());
  return page;
}

TEST(HtmlReport, NeedsNothingFromOutsideAndRunsItsOwnScriptOnly) {
  pages::expect_nothing_from_outside(report_page());
  EXPECT_EQ(count(report_page(), "<script>"), page_script().is_there() ? 1U : 0U);
}

TEST(HtmlReport, NamesItsScriptByAHashAndWithoutOneAllowsNone) {
  if (!page_script().is_there()) {  // built without Node
    EXPECT_THAT(report_page(), HasSubstr("default-src 'none'; style-src"));
    EXPECT_THAT(report_page(), Not(HasSubstr("<script")));
    return;
  }
  EXPECT_THAT(report_page(), HasSubstr("; script-src '" + std::string(page_script().hash) + "';"));
  EXPECT_THAT(report_page(), HasSubstr("Three.js Authors\n * SPDX-License-Identifier: MIT"))
      << "the licence comes along";
}

TEST(HtmlReport, ClosesWhatItOpens) {
  pages::expect_closed_tags(report_page());
}

TEST(HtmlReport, ShowsStrainBesideItsLimitWhereOneWasAsked) {
  EXPECT_THAT(report_page(), Not(HasSubstr("<div class=\"legend bounded\">")));
  EXPECT_THAT(report_page(), HasSubstr("stretch in colour"));
  FlattenReport report = samples::flatten_report();
  report.unfold.limits = {{.what = Criterion::p99_strain, .limit = 0.02, .value = 0.2143}};
  const std::string page = html_report(report);
  pages::expect_closed_tags(page);
  pages::expect_nothing_from_outside(page);
  EXPECT_THAT(page, HasSubstr("limit used up in colour"));
  EXPECT_THAT(page, HasSubstr("limit of strain (2 %, on 99 % of the area)"));
  EXPECT_EQ(count(page, "<div class=\"legend bounded\">"), 1U);
  EXPECT_EQ(count(page, "fill=\"#f0520a\""), 2U) << "in the map and in its legend";
}

TEST(HtmlReport, LeadsToTheFilesBesideIt) {
  EXPECT_THAT(report_page(), Not(HasSubstr("class=\"files\">The pattern")));
  const std::string page =
      html_report(samples::flatten_report(),
                  {.files = {{"pattern.pdf", "to print"}, {"a<b.svg", "for <cutters>"}}});
  EXPECT_THAT(page, HasSubstr("<p class=\"files\">The pattern in true size: "
                              "<a href=\"pattern.pdf\">pattern.pdf</a> to print; "
                              "<a href=\"a&lt;b.svg\">a&lt;b.svg</a> for &lt;cutters&gt;.</p>"));
  pages::expect_closed_tags(page);
}

TEST(HtmlReport, EscapesAllTextFromOutside) {
  FlattenReport report = samples::flatten_report();
  report.name = "<img src=x onerror=alert(1)>\"&\xFF";
  report.evolve.before.inspection.problems = {
      {ErrorCode::zero_area, "<script>alert('x')</script>", 3, 7}};
  const std::string page = html_report(report);
  EXPECT_THAT(page, Not(HasSubstr("<img src=x")));
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(page, Not(HasSubstr("\xFF")));
  EXPECT_THAT(page, HasSubstr("<h1>&lt;img src=x onerror=alert(1)&gt;&quot;&amp;\uFFFD</h1>"));
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; (3 in all)"));
}

TEST(HtmlReport, ListsProblemsAndMarksThoseSinceEvolving) {
  FlattenReport report = samples::flatten_report();
  EXPECT_THAT(html_report(report), Not(HasSubstr("Problems of the mesh")));
  report.evolve.before.inspection.problems = {{ErrorCode::unreferenced_vertex, "old", 1, 0}};
  report.evolve.after.inspection.problems = {{ErrorCode::unreferenced_vertex, "old", 1, 0},
                                             {ErrorCode::zero_area, "new", 2, 5}};
  const std::string page = html_report(report);
  EXPECT_EQ(count(page, "<code>unreferenced_vertex</code>"), 1U);
  EXPECT_THAT(page, HasSubstr("<code>zero_area</code> new (2 in all, since evolving)"));
}

TEST(HtmlReport, HasPicturesOfTheSameSizeWithWordsForThem) {
  const std::string& page = report_page();
  EXPECT_EQ(count(page, "<img "), 4U);
  EXPECT_EQ(count(page, " alt=\"The input patch, "), 1U);
  EXPECT_EQ(count(page, " alt=\"The patch after "), 1U);
  EXPECT_EQ(count(page, ": the surface, shaded\""), 2U);
  EXPECT_EQ(count(page, "data:image/png;base64,iVBORw0KGgo"), 4U) << "PNG by its first bytes";
  EXPECT_EQ(count(page, "role=\"img\" aria-label="), 5U) << "pattern, curve, bars, outlines";
}

TEST(HtmlReport, ShowsTheScaleOfTheChosenColours) {
  const FlattenReport report = samples::flatten_report();
  const std::string diverging = html_report(report);
  const std::string paper = html_report(report, {.colors = ColorMap::paper});
  EXPECT_THAT(diverging, HasSubstr("<span>saddle <b>"));
  EXPECT_THAT(paper, Not(HasSubstr("<span>saddle <b>")));
  EXPECT_THAT(paper, HasSubstr("fill=\"#0000ff\""));
}

TEST(HtmlReport, SaysWhatWasDone) {
  const std::string& page = report_page();
  EXPECT_THAT(page, HasSubstr("651 vertices, 549 of them inner; 1\u202F200 triangles"));
  EXPECT_THAT(page, HasSubstr("lambda_min 0, lambda_max 1, min_angle 1, max_deviation unlimited"));
  EXPECT_THAT(page, HasSubstr("10 sweeps in 0.25 s on 2 threads"));
  EXPECT_THAT(page, HasSubstr("all sweeps asked for were made"));
  EXPECT_THAT(page, HasSubstr("Model unit: mm."));
}

TEST(HtmlReport, SaysWhatItWasAskedForAndWhetherItFits) {
  FlattenReport report = samples::flatten_report();
  report.evolve.method = Auto{.max_deviation = 0.5};
  report.unfold.limits = {{Criterion::strain, 0.5, 0.3187}};
  const std::string page = html_report(
      report,
      {.command = "planish flatten 'a <b>.obj'", .material = "<a> roll", .material_use = "half"});
  EXPECT_THAT(page, HasSubstr("<code>planish flatten &#39;a &lt;b&gt;.obj&#39;</code>"));
  EXPECT_THAT(page, HasSubstr("<span class=\"met\">✓ fits &lt;a&gt; roll</span>"));
  EXPECT_THAT(page, HasSubstr("<dd>&lt;a&gt; roll; half</dd>"));
  EXPECT_THAT(page, HasSubstr("<span class=\"met\">✓ at most 50\u00A0%</span>"));
  EXPECT_THAT(page, HasSubstr("<span class=\"missed\">✗ at most 0.500\u00A0mm</span>"));
  EXPECT_THAT(page,
              HasSubstr("<li><span class=\"met\">✓ within the limit of 50\u00A0%</span></li>"));
  EXPECT_THAT(page, HasSubstr("<span class=\"neutral\">• does not lie flat without stretch</span>"))
      << "a limit that is kept makes it no fault";
  EXPECT_THAT(report_page(),
              HasSubstr("<span class=\"missed\">✗ does not lie flat without stretch</span>"));
}

// From the top of the page to the end of the views, without the bytes of pictures.
std::string first_screen(const std::string& page) {
  std::string top =
      page.substr(page.find("<body>"), page.find("id=\"stage\"") - page.find("<body>"));
  for (std::size_t at; (at = top.find(";base64,")) != std::string::npos;)
    top.erase(at, top.find('"', at) - at);
  return top;
}

TEST(HtmlReport, MarksWhatTheMeshCannotShow) {
  FlattenReport report = samples::flatten_report();
  report.unfold.strain = {0.0, 0.0, 0.0};
  report.evolve.after.flattenable = true;
  EXPECT_THAT(first_screen(html_report(report)), HasSubstr("✓ lies flat without stretch"));
  report.cautions = {CoarseFacets{22.5, 0.00642}};
  std::string top = first_screen(html_report(report));
  EXPECT_THAT(top, HasSubstr("✓ lies flat without stretch"));
  EXPECT_THAT(top, HasSubstr("<span class=\"neutral\">• coarse facets</span>"));
  EXPECT_THAT(top, HasSubstr("Facets turn by 22.5 degrees"));
  report.cautions = {HiddenCurvature{0.0}};
  top = first_screen(html_report(report));
  EXPECT_THAT(top, HasSubstr("<b>Cannot be judged: no vertex inside.</b>"));
  EXPECT_THAT(top, HasSubstr("<span class=\"neutral\">• cannot be judged</span>"));
  EXPECT_THAT(top, HasSubstr("<span class=\"neutral\">• no vertex inside</span>"));
  EXPECT_THAT(top, Not(HasSubstr("lies flat without stretch")));
}

TEST(HtmlReport, MarksAgreeWithTheVerdict) {
  FlattenReport report = samples::flatten_report();
  report.unfold.strain = {0.018, 0.0005, 0.001};
  std::string top = first_screen(html_report(report));
  EXPECT_THAT(top, HasSubstr("<b>Flat but for a stretch too small to measure.</b>"));
  EXPECT_THAT(top, HasSubstr("✓ flat but for a stretch too small to measure"));
  report.material = "neoprene";
  report.unfold.limits = {{Criterion::p99_strain, 0.1, 0.018}};
  report.unfold.strain = {0.018, 0.01, 0.018};
  top = first_screen(html_report(report));
  EXPECT_THAT(top, HasSubstr("<b>Within the 10\u00A0% that neoprene takes, "
                             "with the form changed by up to 0.57\u00A0mm.</b>"));
  EXPECT_THAT(
      top, HasSubstr("<ul class=\"checks\">\n<li><span class=\"met\">✓ within the 10\u00A0% that "
                     "neoprene takes</span></li>"))
      << "what was asked for comes first";
  EXPECT_THAT(top, HasSubstr("• does not lie flat without stretch"));
  EXPECT_THAT(top, Not(HasSubstr("✗")));
  report.unfold.limits = {{Criterion::p99_strain, 0.1, 0.2}};
  top = first_screen(html_report(report));
  EXPECT_THAT(top, HasSubstr("<b>Not within the 10\u00A0% that neoprene takes.</b>"));
  EXPECT_THAT(top, HasSubstr("✗ not within the 10\u00A0% that neoprene takes"));
}

TEST(HtmlReport, MarksWhatAPersonSees) {
  FlattenReport report = samples::flatten_report();
  const auto marks = [&](const FormChange& change) {
    report.evolve.fairness.form_change = change;
    return first_screen(html_report(report));
  };
  EXPECT_THAT(marks({.fold = 2.6}), AllOf(HasSubstr("✓ smooth"), HasSubstr("✓ form kept")));
  EXPECT_THAT(marks({.fold = 2.8}), AllOf(HasSubstr("✗ folded"), Not(HasSubstr("✓ smooth"))));
  EXPECT_THAT(marks({.ripple = 1.2}), AllOf(HasSubstr("✗ rippled"), HasSubstr("✓ form kept")));
  EXPECT_THAT(marks({.ripple = 4.0}), HasSubstr("✗ crumpled"));
  EXPECT_THAT(marks({.edge_lost = 0.5}),
              AllOf(HasSubstr("✓ smooth"), HasSubstr("✗ form not kept: edges are rounded off")));
}

TEST(HtmlReport, MarksAFormThatIsLost) {
  FlattenReport report = samples::flatten_report();
  EXPECT_THAT(html_report(report), HasSubstr("✓ form kept"));
  report.evolve.fairness.height_ratio = 0.254;
  const std::string page = html_report(report);
  EXPECT_THAT(page, HasSubstr("✗ form not kept: height 25\u00A0% of the design's"));
  EXPECT_THAT(page, Not(HasSubstr("✓ form kept")));
}

TEST(HtmlReport, NeedsNoTermOfThePaperOnItsFirstScreen) {
  FlattenReport report = samples::flatten_report();
  report.unfold.pattern.flipped_triangles = 3;
  const std::string top = first_screen(html_report(report));
  for (const std::string term :
       {"sweep", "energy", "e_max", "e_avg", "defect", "face down", "vertex", "rms"})
    EXPECT_THAT(top, Not(HasSubstr(term)));
  EXPECT_THAT(top, HasSubstr("✗ parts of the pattern are flipped over"));
  EXPECT_GT(report_page().find("How it went, sweep by sweep"),
            report_page().find("<summary>How it was computed</summary>"));
}

TEST(HtmlReport, SaysWhyItDoesNotFit) {
  const std::string page =
      html_report(samples::flatten_report(),
                  {.material = "a roll", .fits = false, .material_use = "piece \"<b>\" is wider"});
  EXPECT_THAT(page, HasSubstr("<span class=\"missed\">✗ does not fit a roll</span>"));
  EXPECT_THAT(page, HasSubstr("<dd>a roll; piece &quot;&lt;b&gt;&quot; is wider</dd>"));
}

TEST(HtmlReport, DrawsTheLinesOfThePattern) {
  const FlattenReport report = samples::flatten_report();
  const std::string plain = html_report(report);
  EXPECT_EQ(count(plain, "data-layer=\"cut\""), 1U);
  EXPECT_EQ(count(plain, "data-layer=\"seam\""), 0U);
  EXPECT_EQ(count(plain, "<g id=\"directions\""), 1U);
  const PatternGeometry pattern =
      pattern_geometry(report, {.allowance = Allowance{.width = 2.0}, .grain = 90.0});
  const std::string page =
      html_report(report, pattern, pattern_sheet(report.processed.mesh(), report.unfold, pattern));
  EXPECT_EQ(count(page, "data-layer=\"seam\""), 1U);
  EXPECT_EQ(count(page, "data-layer=\"grain\""), 1U);
  EXPECT_THAT(plain, Not(HasSubstr("with the allowance")));
  EXPECT_THAT(page, HasSubstr("34.0 × 24.0\u00A0mm with the allowance"));
}

TEST(HtmlReport, ComparesWithTheMethodOf2010) {
  const FlattenReport report = samples::flatten_report();
  EXPECT_EQ(count(report_page(), "<polyline class=\"line-reference\""), 0U);
  const std::string page = html_report(
      report, {.reference = {{1, 0.06, 0.003, 0.1, 9, 0.1}, {2, 0.05, 0.003, 0.1, 9, 0.2}}});
  EXPECT_EQ(count(page, "<polyline class=\"line-reference\""), 1U);
  EXPECT_THAT(page, HasSubstr("2010 e_max 0.78"));
}

TEST(HtmlReport, SaysUnderTheTitleWhatTheBorderForbids) {
  FlattenReport report = samples::flatten_report();
  EXPECT_THAT(html_report(report), Not(HasSubstr("The edge is too short")));
  report.evolve.before.obstruction = Obstruction{};
  report.evolve.before.obstruction->excess_share = 0.329;
  report.evolve.before.obstruction->turning_most = 9.0;
  EXPECT_THAT(html_report(report), HasSubstr(" The edge is too short for so much surface"));
}

TEST(HtmlReport, DoesWithoutSweepsAndWithoutAName) {
  FlattenReport report = samples::flatten_report();
  report.evolve.result.history.clear();
  report.name.clear();
  const std::string page = html_report(report);
  EXPECT_THAT(page, HasSubstr("<h1>Patch</h1>"));
  EXPECT_THAT(page, HasSubstr("Nothing to show"));
  EXPECT_THAT(page, Not(HasSubstr("<polyline")));
}

TEST(HtmlReport, GivesTheSameBytesForTheSameReport) {
  EXPECT_TRUE(html_report(samples::flatten_report()) == report_page());
}

// The numbers of a row of the table, before and after, with all their digits.
std::vector<double> numbers_of(const std::string& table, const std::string& name) {
  std::vector<double> numbers;
  const std::size_t from = table.find("<th scope=\"row\">" + name + "<small>");
  if (from == std::string::npos) return numbers;
  const std::size_t to = table.find("</tr>", from);
  const std::string mark = "<data value=\"";
  for (std::size_t at = from; (at = table.find(mark, at)) < to; at += mark.size()) {
    numbers.push_back(std::strtod(table.c_str() + at + mark.size(), nullptr));
  }
  return numbers;
}

TEST(FiguresTable, HasTheFiguresOfTheReportToTheLastDigit) {
  FlattenReport report = samples::flatten_report();
  report.design_pattern.pattern.flipped_triangles = 3;
  report.unfold.pattern.overlaps = true;
  const std::string table = figures_table(report);
  const auto& before = report.evolve.before.figures;
  const auto& after = report.evolve.after.figures;
  constexpr double degrees = 180.0 / std::numbers::pi;
  const auto row = [&](const std::string& name) { return numbers_of(table, name); };
  EXPECT_THAT(row("Largest angle defect"), ElementsAre(before.e_max, after.e_max));
  EXPECT_THAT(row("Mean angle defect"), ElementsAre(before.e_avg, after.e_avg));
  EXPECT_THAT(row("Energy"), ElementsAre(before.energy, after.energy));
  EXPECT_THAT(row("Curvature left"), ElementsAre(before.sum_abs_defect, after.sum_abs_defect));
  EXPECT_THAT(row("Strain, rms"), ElementsAre(0.0763, 0.0761));
  EXPECT_THAT(row("Strain, 99 % of the area"), ElementsAre(0.2213, 0.2143));
  EXPECT_THAT(row("Strain, worst edge"), ElementsAre(0.3241, 0.3187));
  EXPECT_THAT(row("Smallest angle"),
              ElementsAre(degrees * before.min_angle, degrees * after.min_angle));
  EXPECT_THAT(row("Bending"), ElementsAre(41.7, 41.7 * 0.73));
  EXPECT_THAT(row("Bending over the design's"), ElementsAre(1.13));
  EXPECT_THAT(row("Bending added"), ElementsAre(0.31));
  EXPECT_THAT(row("Bending lost"), ElementsAre(0.17));
  EXPECT_THAT(row("Sharply bent"), ElementsAre(0.0125));
  EXPECT_THAT(row("Mean curvature"), ElementsAre(3.17, 3.17 * 0.73));
  EXPECT_THAT(row("Ruling defect"), ElementsAre(0.203, 0.203 * 0.73));
  EXPECT_THAT(row("Turn of the surface"), ElementsAre(3.4));
  EXPECT_THAT(row("Turn along the border"), ElementsAre(5.6));
  EXPECT_THAT(row("Crossings"), ElementsAre(0.0, 0.0));
  EXPECT_THAT(row("Deviation, rms"), ElementsAre(0.1234));
  EXPECT_THAT(row("Deviation, rms over size"), ElementsAre(0.00345));
  EXPECT_THAT(row("Deviation, largest"), ElementsAre(0.5678));
  EXPECT_THAT(row("Deviation, largest over size"),
              ElementsAre(testing::DoubleNear(0.00345 / 0.1234 * 0.5678, 1e-15)));
  EXPECT_THAT(row("Pattern size"), ElementsAre(30.5, 20.5, 30.0, 20.0));
  EXPECT_THAT(row("Area ratio"), ElementsAre(1.0034, 1.0021));
  EXPECT_THAT(row("Flipped triangles"), ElementsAre(3.0, 0.0));
  EXPECT_THAT(row("Overlap"), ElementsAre(0.0, 1.0));
  EXPECT_EQ(count(table, "<th scope=\"row\">"), 26U) << "and no other rows";
}

// What the last cell of a row says.
std::string change_of(const FlattenReport& report, const std::string& name) {
  const std::string table = figures_table(report);
  const std::size_t end = table.find("</tr>", table.find("<th scope=\"row\">" + name + "<small>"));
  const std::size_t from = table.rfind("<td", end);
  std::string text = table.substr(table.find('>', from) + 1, end - table.find('>', from) - 1);
  for (const std::string tag : {"<b>", "</b>", "</td>"}) {
    for (std::size_t at; (at = text.find(tag)) != std::string::npos;)
      text.erase(at, tag.size());
  }
  for (std::size_t at; (at = text.find("\u00A0")) != std::string::npos;)
    text.replace(at, 2, " ");
  return text;
}

TEST(FiguresTable, JudgesAChangeByWhatTheFigureShouldBe) {
  FlattenReport report = samples::flatten_report();
  EXPECT_EQ(change_of(report, "Energy"), "−27 % better");
  EXPECT_EQ(change_of(report, "Smallest angle"), "−27 % worse") << "larger is better";
  EXPECT_EQ(change_of(report, "Strain, rms"), "same");
  EXPECT_EQ(change_of(report, "Area ratio"), "−0.13 % better") << "nearer to 1";
  EXPECT_EQ(change_of(report, "Pattern size"), "–") << "neither good nor bad";
  EXPECT_EQ(change_of(report, "Deviation, rms"), "–");
  report.evolve.after.figures.energy = 0.137 / 1234.0;
  EXPECT_EQ(change_of(report, "Energy"), "÷ 1200 better");
  report.evolve.after.figures.energy = 0.137 * 5.31;
  EXPECT_EQ(change_of(report, "Energy"), "× 5.3 worse");
  report.unfold.pattern.flipped_triangles = 2;
  EXPECT_EQ(change_of(report, "Flipped triangles"), "from 0 worse");
  report.design_pattern.strain.max = 1e-9;
  report.unfold.strain.max = 5e-9;
  EXPECT_EQ(change_of(report, "Strain, worst edge"), "same") << "rounding is no change";
}

}  // namespace
}  // namespace planish
