#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string>

#include <planish/core/error.h>
#include <planish/draw/format_drawing.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "draw/pdf/pdf_text.h"
#include "support/sheets.h"

namespace planish {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++found;
  return found;
}

TEST(WritePdf, HasThePageOfTheSheetAtTrueSize) {
  const std::string pdf = format_pdf({"t", 210.0, 297.0, {}});
  EXPECT_TRUE(pdf.starts_with("%PDF-1.6\n"));
  EXPECT_TRUE(pdf.ends_with("%%EOF\n"));
  EXPECT_THAT(pdf, HasSubstr("/MediaBox [0 0 595.2756 841.8898]"));
  EXPECT_THAT(pdf, HasSubstr("/PrintScaling /None"));
  EXPECT_THAT(pdf, HasSubstr("\n2.834645669291339 0 0 2.8346"));
  EXPECT_THAT(pdf, Not(HasSubstr("UserUnit")));
}

TEST(WritePdf, DividesSheetsThatAreLongerThanAPageCanBe) {
  const Path panel{{{{10, 10}, {6510, 10}, {6510, 910}, {10, 910}}}, true, Stroke{}};
  const std::string pdf = format_pdf({"t", 6520.0, 920.0, {Layer{"cut", {panel}}}});
  EXPECT_THAT(pdf, HasSubstr("/Count 3 "));
  EXPECT_THAT(pdf, Not(HasSubstr("UserUnit")));
  EXPECT_THAT(pdf, HasSubstr("/MediaBox [0 0 595.2756 841.8898]")) << "the map is on A4";
  // 6504 and 904 mm, two pages overlap by 10, and 10 mm at either edge stay free: 3277 by 924.
  EXPECT_EQ(count(pdf, "/MediaBox [0 0 9289.1339 2619.2126]"), 2U);
  EXPECT_THAT(pdf, HasSubstr("2 pages of 3277 "));
  EXPECT_THAT(format_pdf({"t", 5080.0, 920.0, {Layer{"cut", {panel}}}}), HasSubstr("/Count 1 "));
}

TEST(WritePdf, TakesALargerUnitWhereNobodyWouldJoinSoManyPages) {
  const Path field{{{{0, 0}, {1e6, 0}, {1e6, 1e6}, {0, 1e6}}}, true, Stroke{}};
  const std::string pdf = format_pdf({"t", 1e6, 1e6, {Layer{"cut", {field}}}});
  EXPECT_THAT(pdf, HasSubstr("/Count 1 "));
  EXPECT_THAT(pdf, HasSubstr("/UserUnit 197"));
}

TEST(WritePdf, PointsToEveryObject) {
  const std::string pdf = format_pdf(sheet_with(Path{{{{1, 2}, {3, 4}}}, false, Stroke{}}));
  const std::size_t table = std::strtoul(pdf.c_str() + pdf.rfind("startxref") + 10, nullptr, 10);
  ASSERT_EQ(pdf.substr(table, 7), "xref\n0 ");
  const std::size_t objects = std::strtoul(pdf.c_str() + table + 7, nullptr, 10);
  EXPECT_EQ(objects, count(pdf, " 0 obj\n") + 1);
  const std::size_t first = pdf.find('\n', table + 5) + 1;
  for (std::size_t i = 1; i < objects; ++i) {
    const std::size_t offset = std::strtoul(pdf.c_str() + first + 20 * i, nullptr, 10);
    const std::string head = std::to_string(i) + " 0 obj\n";
    EXPECT_EQ(pdf.substr(offset, head.size()), head);
  }
}

TEST(WritePdf, MakesLayersThatCanBeHidden) {
  const std::string pdf = format_pdf({"t", 9.0, 9.0, {Layer{"cut", {}}, Layer{"Ä", {}, false}}});
  EXPECT_THAT(pdf, HasSubstr("/Type /OCG /Name <FEFF006300750074>"));
  EXPECT_THAT(pdf, HasSubstr("/Type /OCG /Name <FEFF00C4>"));
  EXPECT_THAT(pdf, HasSubstr("/OFF [ 6 0 R ]"));
  EXPECT_THAT(pdf, HasSubstr("/Properties << /L0 5 0 R /L1 6 0 R >>"));
  EXPECT_THAT(pdf, HasSubstr("/OC /L0 BDC\nEMC\n/OC /L1 BDC\nEMC\n"));
}

TEST(WritePdf, DrawsLinesDashesAndAreas) {
  const std::vector<std::vector<Vec2>> lines = {{{1, 1}, {2.0004, 1}, {2, 2}, {1, 1}}};
  EXPECT_THAT(format_pdf(sheet_with(Path{lines, true, Stroke{{255, 0, 51}, 0.25, true}})),
              HasSubstr("1 0 0.2 RG\n0.25 w\n[3 1.5 ] 0 d\n1 1 m\n2 1 l\n2 2 l\nh\nS\n"));
  EXPECT_THAT(format_pdf(sheet_with(Path{lines, true, {}, Color{0, 255, 0}})),
              HasSubstr("0 1 0 rg\n1 1 m\n2 1 l\n2 2 l\nh\nf*\n"));
  EXPECT_THAT(format_pdf(sheet_with(Path{lines, false, Stroke{}, Color{}})),
              HasSubstr("2 2 l\n1 1 l\nB*\n"));
}

TEST(WritePdf, SetsTextByTheHeightOfItsCapitals) {
  EXPECT_THAT(format_pdf(sheet_with(Text{{5.0, 7.0}, 3.59, "A(b)"})),
              HasSubstr("BT\n/F1 5 Tf\n5 7 Td\n(A\\(b\\)) Tj\nET\n"));
  // Two times 556 thousandths of 10 mm: the middle is 5.56 mm behind the start.
  EXPECT_THAT(format_pdf(sheet_with(Text{{50.0, 7.0}, 7.18, "44", {}, true})),
              HasSubstr("44.44 7 Td\n"));
}

TEST(WritePdf, DrawsTextThatTheFontHasNotGot) {
  const std::string pdf = format_pdf(sheet_with(Text{{5.0, 7.0}, 8.0, "Ł"}));
  EXPECT_THAT(pdf, Not(HasSubstr("BT\n")));
  EXPECT_THAT(pdf, HasSubstr("6 15 m\n6 7 l\n11 7 l\n"));
}

TEST(WritePdf, SpellsLettersThatNeitherFontHas) {
  EXPECT_THAT(format_pdf(sheet_with(Text{{}, 8.0, "Перед"})), HasSubstr("(Pered) Tj"));
  EXPECT_THAT(format_pdf(sheet_with(Text{{}, 8.0, "Ωμέγα"})), HasSubstr("(Omega) Tj"));
  EXPECT_THAT(format_pdf(sheet_with(Text{{}, 8.0, "前片"})), HasSubstr("(u524Du7247) Tj"));
  EXPECT_EQ(in_pdf_letters("Größe ™"), "Größe ™");
}

TEST(WinAnsi, HoldsWindows1252AndTakesADashForAMinus) {
  EXPECT_EQ(win_ansi("aé€…×"), "a\xE9\x80\x85\xD7");
  EXPECT_EQ(win_ansi("−1–"),
            "\x96"
            "1\x96");
  EXPECT_EQ(win_ansi("Łódź"), std::nullopt);
  EXPECT_EQ(win_ansi("\xFF"), std::nullopt);
}

TEST(HelveticaWidth, IsThatOfItsMetrics) {
  EXPECT_DOUBLE_EQ(helvetica_width("Wi "), 0.944 + 0.222 + 0.278);
  EXPECT_DOUBLE_EQ(helvetica_width("~@"), 0.584 + 1.015);
  EXPECT_DOUBLE_EQ(helvetica_width("\xE9\xEE\xFC\xDF"), 0.556 + 0.278 + 0.556 + 0.556);
}

TEST(PdfString, EscapesWhatEndsItAndWhatIsNoAscii) {
  EXPECT_EQ(pdf_string("a(b)\\\n\xE9"), "(a\\(b\\)\\\\\\012\\351)");
  EXPECT_EQ(pdf_unicode_string("é😀"), "<FEFF00E9D83DDE00>");
}

TEST(WritePdf, LeavesOutWhatIsNowhere) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Drawing drawing = sheet_with(Path{{{{1, 2}, {nan, 2}, {4, 2}}}, false, Stroke{}});
  drawing.layers[0].shapes.emplace_back(Text{{nan, 0.0}, 3.0, "lost"});
  const std::string pdf = format_pdf(drawing);
  EXPECT_THAT(pdf, HasSubstr("1 2 m\n4 2 l\nS\n"));
  EXPECT_THAT(pdf, Not(HasSubstr("nan")));
  EXPECT_THAT(pdf, Not(HasSubstr("lost")));
}

TEST(WritePdf, TellsFilesApartAndGivesTheSameBytesForTheSameDrawing) {
  const auto id = [](const std::string& pdf) { return pdf.substr(pdf.find("/ID ["), 40); };
  const std::string one = format_pdf(sheet_with(Text{{}, 3.0, "a"}));
  EXPECT_EQ(one, format_pdf(sheet_with(Text{{}, 3.0, "a"})));
  EXPECT_NE(id(one), id(format_pdf(sheet_with(Text{{}, 3.0, "b"}))));
}

}  // namespace
}  // namespace planish
