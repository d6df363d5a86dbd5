#include "draw/text/ascii_text.h"

#include <string>

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(AsciiText, KeepsAsciiAndDropsControlCharacters) {
  EXPECT_EQ(ascii_text("Seat panel 42 (x)"), "Seat panel 42 (x)");
  EXPECT_EQ(ascii_text("a\tb\nc\x7F"), "a b c ");
}

TEST(AsciiText, SpellsLettersOfOtherAlphabets) {
  EXPECT_EQ(ascii_text("Größe ÄÖÜäöüß"), "Groesse AeOeUeaeoeuess");
  EXPECT_EQ(ascii_text("Łódź Čapek Ærø Þór ÿ"), "Lodz Capek AEro Thor y");
  EXPECT_EQ(ascii_text("Ωμέγα ψυχή"), "Omega psychi");
  EXPECT_EQ(ascii_text("Юбка перед ёж"), "Yubka pered yozh");
  EXPECT_EQ(ascii_text("3 × 4 ± 0.5° – “a” … −1 €"), "3 x 4 +- 0.5deg - \"a\" ... -1 EUR");
}

TEST(AsciiText, KeepsNamesInOtherScriptsDifferent) {
  EXPECT_EQ(ascii_text("布"), "u5E03");
  EXPECT_EQ(ascii_text("😀"), "u01F600");
  EXPECT_NE(ascii_text("前身頃"), ascii_text("後身頃"));
  EXPECT_EQ(ascii_text("e\xCC\x81"), "e") << "an accent by itself";
  EXPECT_EQ(ascii_text("\xFF"), "uFFFD");
}

TEST(AsciiText, IsPrintableAsciiForEveryCharacter) {
  for (unsigned point = 0x80; point < 0x2100; ++point) {
    std::string text;
    if (point < 0x800) {
      text = {static_cast<char>(0xC0U | (point >> 6U)), static_cast<char>(0x80U | (point & 0x3FU))};
    } else {
      text = {static_cast<char>(0xE0U | (point >> 12U)),
              static_cast<char>(0x80U | ((point >> 6U) & 0x3FU)),
              static_cast<char>(0x80U | (point & 0x3FU))};
    }
    for (const char c : ascii_text(text))
      ASSERT_TRUE(c >= ' ' && c < 0x7F) << point;
  }
}

}  // namespace
}  // namespace planish
