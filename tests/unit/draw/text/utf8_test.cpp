#include "draw/text/utf8.h"

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(CodePoints, DecodesEveryLengthAndReplacesWhatIsNoUtf8) {
  EXPECT_EQ(code_points("aé€😀"), U"aé€😀");
  EXPECT_EQ(code_points("a\xFF\xC3z"), U"a\uFFFD\uFFFDz");
  EXPECT_EQ(code_points(""), U"");
}

TEST(Utf16Units, MakesPairsBeyondTheFirst65536) {
  EXPECT_EQ(utf16_units(U'é'), u"é");
  EXPECT_EQ(utf16_units(U'\uFFFD'), u"\uFFFD");
  EXPECT_EQ(utf16_units(U'😀'), u"😀");
  EXPECT_EQ(utf16_units(U'\U0010FFFF'), u"\U0010FFFF");
}

}  // namespace
}  // namespace planish
