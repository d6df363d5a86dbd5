#include "draw/text/stroke_text.h"

#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "draw/text/stroke_font.h"
#include "draw/text/stroke_glyphs.h"

namespace planish {
namespace {

using Lines = std::vector<std::vector<Vec2>>;

struct Box {
  double left = 1e300, bottom = 1e300, right = -1e300, top = -1e300;
};

Box box_of(const Lines& lines) {
  Box box;
  for (const auto& line : lines) {
    for (const Vec2 p : line) {
      box = {std::min(box.left, p.x), std::min(box.bottom, p.y), std::max(box.right, p.x),
             std::max(box.top, p.y)};
    }
  }
  return box;
}

// ASCII, and all letters of Latin-1 and Latin Extended-A but the few that no living spelling needs.
std::u32string letters() {
  std::u32string all;
  for (char32_t c = U'!'; c <= U'~'; ++c)
    all += c;
  const std::u32string without = U"ĲĳĿŀŉŊŋſĸ";
  for (char32_t c = U'À'; c <= U'ž'; ++c) {
    if (without.find(c) == std::u32string::npos) all += c;
  }
  return all + U"ȘșȚț°–—…−€±²³µ≤≥‘’“”„";
}

TEST(StrokeFont, HasALetterOfItsOwnForEveryCommonCharacter) {
  for (const char32_t c : letters()) {
    const auto glyph = stroke_glyph(c);
    ASSERT_TRUE(glyph) << static_cast<unsigned>(c);
    EXPECT_FALSE(glyph->lines.empty()) << static_cast<unsigned>(c);
  }
  EXPECT_FALSE(stroke_glyph(U'\uE000')) << "of private use: nobody's letter";
}

TEST(StrokeFont, DrawsNoTwoLettersAlike) {
  const auto less = [](const Lines& a, const Lines& b) {
    return std::lexicographical_compare(
        a.begin(), a.end(), b.begin(), b.end(), [](const auto& p, const auto& q) {
          return std::lexicographical_compare(
              p.begin(), p.end(), q.begin(), q.end(),
              [](Vec2 u, Vec2 v) { return u.x != v.x ? u.x < v.x : u.y < v.y; });
        });
  };
  std::set<Lines, decltype(less)> seen(less);
  // These are one shape with two meanings each.
  const std::u32string twins = U"Đ—−’‚´";
  for (const char32_t c : letters()) {
    if (twins.find(c) != std::u32string::npos) continue;
    EXPECT_TRUE(seen.insert(stroke_glyph(c)->lines).second) << static_cast<unsigned>(c);
  }
}

TEST(StrokeFont, KeepsEveryStrokeWithinItsGlyph) {
  for (const char32_t c : letters()) {
    const Glyph glyph = *stroke_glyph(c);
    const Box box = box_of(glyph.lines);
    EXPECT_GE(box.left, 0.0) << static_cast<unsigned>(c);
    EXPECT_LE(box.right, glyph.width) << static_cast<unsigned>(c);
    EXPECT_GE(box.bottom, -3.0) << static_cast<unsigned>(c);
    EXPECT_LE(box.top, 12.0) << static_cast<unsigned>(c);
    for (const auto& line : glyph.lines)
      EXPECT_GE(line.size(), 2U) << static_cast<unsigned>(c);
  }
  for (char32_t c = U'A'; c <= U'Z'; ++c) {
    const Box box = box_of(stroke_glyph(c)->lines);
    EXPECT_EQ(box.bottom, 0.0);
    EXPECT_EQ(box.top, k_font_capital);
  }
}

TEST(StrokeFont, ListsOtherGlyphsInTheOrderThatTheyAreFoundBy) {
  const auto in_order = [](const DrawnGlyph& a, const DrawnGlyph& b) {
    return a.code_point < b.code_point;
  };
  EXPECT_TRUE(std::is_sorted(std::begin(k_others), std::end(k_others), in_order));
  for (const DrawnGlyph& glyph : k_others)
    EXPECT_TRUE(stroke_glyph(glyph.code_point));
}

TEST(StrokeFont, PutsAMarkAboveItsLetterAndInPlaceOfADot) {
  const Glyph small = *stroke_glyph(U'é'), capital = *stroke_glyph(U'É');
  EXPECT_GT(box_of({small.lines.back()}).bottom, 5.0);
  EXPECT_GT(box_of({capital.lines.back()}).bottom, 8.0);
  EXPECT_EQ(stroke_glyph(U'í')->lines.size(), 2U) << "stem and accent";
  EXPECT_EQ(stroke_glyph(U'ï')->lines.size(), 3U);
}

TEST(TextStrokes, AreAsHighAsAskedAndBeginAtTheirPlace) {
  const Box box = box_of(text_strokes({{10.0, 20.0}, 4.0, "EH"}));
  EXPECT_DOUBLE_EQ(box.left, 10.0);
  EXPECT_DOUBLE_EQ(box.bottom, 20.0);
  EXPECT_DOUBLE_EQ(box.top, 24.0);
  EXPECT_DOUBLE_EQ(box.right, 10.0 + text_strokes_width("EH", 4.0));
}

TEST(TextStrokes, StandAroundTheirPlaceWhereCentred) {
  const Box box = box_of(text_strokes({{10.0, 20.0}, 4.0, "EH", {}, true}));
  EXPECT_DOUBLE_EQ(box.left + box.right, 20.0);
}

TEST(TextStrokes, SpellWhatTheFontDoesNotHave) {
  EXPECT_EQ(in_stroke_letters("Größe 38 ± 0.5° × €"), "Größe 38 ± 0.5° × €");
  EXPECT_EQ(in_stroke_letters("Łódź перед Ωμέγα"), "Łódź pered Omega");
  EXPECT_EQ(in_stroke_letters("布\xFF"), "u5E03uFFFD");
  EXPECT_NE(in_stroke_letters("前片"), in_stroke_letters("后片")) << "pieces stay different";
  for (const char* text : {"Юбка", "ψυχή", "布", "\xFF", "e\xCC\x81"}) {
    EXPECT_EQ(text_strokes({{}, 8.0, text}), text_strokes({{}, 8.0, in_stroke_letters(text)}));
    EXPECT_FALSE(text_strokes({{}, 8.0, text}).empty()) << text;
  }
  EXPECT_TRUE(text_strokes({{}, 8.0, " \t\n"}).empty());
  EXPECT_GT(text_strokes_width("a b", 1.0), text_strokes_width("ab", 1.0));
}

TEST(WithStrokedText, TurnsTextIntoPathsAndLeavesTheRest) {
  const Path path{{{{1, 2}, {3, 4}}}, false, Stroke{}};
  Text text{{5.0, 6.0}, 12.0, "Aé", {1, 2, 3}, false, 7};
  const Drawing stroked = with_stroked_text({"t", 1.0, 2.0, {Layer{"notes", {path, text}, false}}});
  ASSERT_EQ(stroked.layers.at(0).shapes.size(), 2U);
  EXPECT_FALSE(stroked.layers[0].visible);
  EXPECT_EQ(std::get<Path>(stroked.layers[0].shapes[0]).lines, path.lines);
  const Path& letters = std::get<Path>(stroked.layers[0].shapes[1]);
  EXPECT_EQ(letters.lines, text_strokes(text));
  EXPECT_EQ(letters.stroke->color, text.color);
  EXPECT_EQ(letters.piece, 7U);
  EXPECT_FALSE(letters.closed);
  EXPECT_FALSE(letters.fill);
}

}  // namespace
}  // namespace planish
