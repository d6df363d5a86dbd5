#include "draw/text/text_lines.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace planish {
namespace {

using Words = std::vector<std::string>;

TEST(LettersIn, CountsLettersAndNotBytesAndHasRoomForSpellings) {
  EXPECT_EQ(letters_in(""), 0U);
  EXPECT_EQ(letters_in("Größe ±"), 7U);
  EXPECT_EQ(letters_in("подъём"), 6U) << "as podyom is, though one letter has no spelling";
  EXPECT_EQ(letters_in("前片"), 10U) << "u524Du7247";
}

TEST(BrokenLines, EndBetweenPartsOrWords) {
  EXPECT_EQ(broken_lines("red: cut · grey: sew · pink: notch", 20),
            (Words{"red: cut · grey: sew", "pink: notch"}));
  EXPECT_EQ(broken_lines("red: cut · grey: sew", 19), (Words{"red: cut", "grey: sew"}));
  EXPECT_EQ(broken_lines("one two three", 7), (Words{"one two", "three"}));
  EXPECT_EQ(broken_lines("unbreakable", 3), (Words{"unbreakable"}));
  EXPECT_EQ(broken_lines("short", 30), (Words{"short"}));
}

}  // namespace
}  // namespace planish
