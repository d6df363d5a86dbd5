#include <regex>
#include <set>
#include <string>

#include <planish/mesh/shapes.h>
#include <planish/report/html_report.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/figure_text.h"
#include "report/page/page_assets.h"
#include "support/page.h"
#include "support/products.h"

namespace planish {
namespace {

using pages::count;
using testing::HasSubstr;
using testing::Not;

/// Three strips with two seams, and a piece that failed.
const ProductReport& product() {
  static const ProductReport report = [] {
    std::vector<ProductPatch> patches;
    for (NamedPatch& strip : in_strips(make_shape("saddle", 300), 3))
      patches.push_back({strip.name, std::move(strip.mesh)});
    patches.push_back({"lost & <found>", {}, {}, Failure{"file_unreadable", "no such file"}});
    ProductOptions options;
    options.flatten.method = ControllableLaplacian{};
    options.flatten.stopping = Stopping{.max_sweeps = 2};
    options.flatten.limits.max = 0.05;
    options.match_seams = false;  // so that there is something to be eased in
    return flatten_product(patches, options);
  }();
  return report;
}

std::string page(const ProductReport& report = product()) {
  return html_report(report,
                     {"coat", {"a/report.html", "b c/report.html", "\u00FC/report.html", ""}});
}

TEST(HtmlProduct, IsAWholePage) {
  const std::string html = page();
  pages::expect_closed_tags(html);
  pages::expect_nothing_from_outside(html);
  EXPECT_EQ(count(html, "<script"), page_script().is_there() ? 2U : 0U) << "data and script";
  EXPECT_EQ(count(html, "<img "), 4U) << "of the whole and of each piece";
  EXPECT_EQ(count(html, "<svg class=\"outline\""), 3U);
  EXPECT_THAT(html, HasSubstr("<title>coat"));
}

TEST(HtmlProduct, ShowsWhatIsMissedFirst) {
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("1 of 4 pieces needs a look"));
  const std::size_t tiles = html.find("<ol class=\"pieces\">");
  EXPECT_LT(html.find("lost &amp; &lt;found&gt;", tiles), html.find("strip-1", tiles));
  EXPECT_EQ(count(html, "class=\"lacking\""), 1U);
  // In the list of the whole and over its tile.
  EXPECT_EQ(count(html, "<span class=\"met\">\u2713</span>"), 2U * 3U);
  EXPECT_EQ(count(html, "<span class=\"missed\">\u2717</span>"), 2U * 1U);
  EXPECT_THAT(html, HasSubstr("<p>Failed: no such file.</p>"));
}

TEST(HtmlProduct, SaysNothingIsAsAskedForWhereNothingWasAskedFor) {
  ProductReport report = product();
  report.patches.pop_back();
  EXPECT_THAT(page(report), HasSubstr("All 3 pieces are as asked for."));
  for (PatchResult& piece : report.patches) {
    piece.finished->limits.clear();
    piece.finished->deviation = {};
  }
  report.patches.front().finished->not_judged = "no vertex inside";
  const std::string html = page(report);
  EXPECT_THAT(html, Not(HasSubstr("as asked for")));
  EXPECT_EQ(count(html, "<span class=\"met\">\u2713</span>"), 2U * 2U);
  EXPECT_THAT(html, HasSubstr("<span class=\"neutral\">\u2022</span>"));
  EXPECT_THAT(html, HasSubstr("Cannot be judged: no vertex inside."));
}

TEST(HtmlProduct, ColoursBothSidesOfASeamAlikeWithOneNumber) {
  const std::string html = page();
  ASSERT_EQ(product().seams.size(), 2U);
  std::set<std::string> classes;
  for (const std::string number : {"1", "2"}) {
    const std::regex disc("<g class=\"(line-[0-9])\"><circle [^>]*/><text [^>]*>" + number +
                          "</text>");
    std::smatch found;
    std::string rest = html;
    std::size_t sides = 0;
    std::string first;
    for (; std::regex_search(rest, found, disc); rest = found.suffix(), ++sides) {
      if (sides == 0) first = found[1];
      EXPECT_EQ(found[1], first);
    }
    EXPECT_EQ(sides, 2U) << number;
    EXPECT_THAT(
        html, HasSubstr("<tr id=\"seam-" + number + "\"><th><svg class=\"swatch " + first + "\""));
    EXPECT_EQ(count(html, "<g class=\"" + first + "\"><path d=\"M"), 2U);
    classes.insert(first);
  }
  EXPECT_EQ(classes.size(), 2U);
}

TEST(HtmlProduct, LinksToTheReportOfEachFinishedPiece) {
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("<a href=\"a/report.html\">"));
  EXPECT_THAT(html, HasSubstr("<a href=\"b%20c/report.html\">"));
  EXPECT_THAT(html, HasSubstr("<a href=\"%C3%BC/report.html\">"));
  EXPECT_EQ(count(html, "<a href") - count(html, "<a href=\"#piece-"), 3U);
}

TEST(HtmlProduct, ListsThePiecesOfTheWholeWithLinksToTheirTiles) {
  const std::string html = page();
  const std::size_t list = html.find("<ol class=\"parts\">"),
                    tiles = html.find("<ol class=\"pieces\">");
  EXPECT_LT(html.find("<section class=\"whole"), list);
  EXPECT_LT(list, tiles);
  for (const std::string number : {"1", "2", "3", "4"}) {
    EXPECT_LT(html.find("<a href=\"#piece-" + number + "\">"), tiles) << number;
    EXPECT_EQ(count(html, "<li id=\"piece-" + number + "\""), 1U);
  }
  EXPECT_EQ(count(html, "class=\"chip\" style=\"background:#"), 3U) << "the other one failed";
  EXPECT_THAT(html, HasSubstr("<p class=\"sum\">4 pieces (1 failed), "));
}

TEST(HtmlProduct, ListsTheSeamsWithTheirDifference) {
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("strip-1 \u2013 strip-2"));
  const MeasuredSeam& first = product().seams[0];
  const std::string cells = "<br><small>strip-1 is " + decimals_text(*first.difference(), 2) +
                            "\u00A0mm longer in the pattern</small></td><td>" +
                            decimals_text(*first.difference(), 2) + "</td><td>" +
                            decimals_text(first.on_model[0], 2) + "</td><td>" +
                            decimals_text(*first.in_pattern[0], 2) + "</td>";
  EXPECT_LT(html.find("<th>Difference</th><th>On the model</th><th>First piece</th>"),
            html.find("strip-1 \u2013 strip-2" + cells));
  EXPECT_THAT(html, HasSubstr("strip-1 \u2013 strip-2" + cells));
  EXPECT_THAT(html, HasSubstr("Of 2 seams the two sides differ by "));
  ProductReport without = product();
  without.seams.clear();
  const std::string other = page(without);
  pages::expect_closed_tags(other);
  EXPECT_THAT(other, Not(HasSubstr("<h2>Seams</h2>")));
}

}  // namespace
}  // namespace planish
