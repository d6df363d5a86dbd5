#include "io/file/text_cursor.h"

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "unit/io/io_testing.h"

namespace planish {
namespace {

TEST(TextCursor, GivesTheWordsOfALineAndThenNothing) {
  TextCursor cursor(" one\ttwo \nthree", "a");
  EXPECT_EQ(cursor.token(), "one");
  EXPECT_EQ(cursor.token(), "two");
  EXPECT_EQ(cursor.token(), "");
  EXPECT_EQ(cursor.token(), "");
  cursor.next_line();
  EXPECT_EQ(cursor.token(), "three");
  EXPECT_TRUE(cursor.at_end());
  cursor.next_line();
  EXPECT_EQ(cursor.line(), 2U);
}

TEST(TextCursor, FindsTheNextWordOverLines) {
  TextCursor cursor("\n \r\n# not this\r  word", "a", {.comments = true});
  EXPECT_TRUE(cursor.skip_to_token());
  EXPECT_EQ(cursor.line(), 4U);
  EXPECT_EQ(cursor.token(), "word");
  EXPECT_FALSE(cursor.skip_to_token());
}

TEST(TextCursor, KnowsCommentsAndContinuationsOnlyWhereAsked) {
  TextCursor plain("#a \\\nb", "a");
  EXPECT_EQ(plain.token(), "#a");
  EXPECT_EQ(plain.token(), "\\");
  EXPECT_EQ(plain.token(), "");
  TextCursor joined("a\\\nb\\c \\", "a", {.continuation = true});
  EXPECT_EQ(joined.token(), "a");
  EXPECT_EQ(joined.token(), "b\\c");
  EXPECT_EQ(joined.line(), 2U);
  EXPECT_EQ(joined.token(), "\\");
}

TEST(TextCursor, LooksAtNothingBehindItsText) {
  const std::string text = "12345";
  TextCursor cursor(std::string_view(text).substr(0, 2), "a");
  EXPECT_EQ(cursor.number(), 12.0);
  EXPECT_TRUE(cursor.at_line_end());
}

TEST(TextCursor, ReadsCountsUpTo64Bits) {
  TextCursor cursor("0 18446744073709551615 18446744073709551616 -1", "a");
  EXPECT_EQ(cursor.count(), 0U);
  EXPECT_EQ(cursor.count(), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(cursor.count(), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(error_of([&] { cursor.count(); }).message(), "\"-1\" is not a count");
}

TEST(TextCursor, NamesFileLineAndItem) {
  TextCursor cursor("\nx", "a.ply");
  cursor.next_line();
  cursor.begin_item("vertex", 7);
  const Error error = error_of([&] { cursor.number(); });
  EXPECT_STREQ(error.what(), "a.ply:2: vertex 7: \"x\" is not a number");
  EXPECT_EQ(error.place().first, 7U);
}

TEST(InQuotes, MakesAnyBytesPrintableAndShort) {
  EXPECT_EQ(in_quotes("a b"), "\"a b\"");
  EXPECT_EQ(in_quotes("\x1b[2J\xff"), "\"\\x1b[2J\\xff\"");
  EXPECT_EQ(in_quotes(std::string(41, 'a')), "\"" + std::string(40, 'a') + "...\"");
}

}  // namespace
}  // namespace planish
