#include "shell/text.h"

#include <sstream>

#include <gtest/gtest.h>

namespace planish::cli {
namespace {

TEST(Wrapped, BreaksBetweenWordsWithinTheWidth) {
  std::string words;
  for (int i = 0; i < 40; ++i)
    words += "word" + std::to_string(i) + " ";
  const std::string text = std::string(10, ' ') + wrapped(words, 10);
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    EXPECT_LE(end - begin, k_text_width);
    EXPECT_EQ(text.substr(begin, 11).find_first_not_of(' '), 10U);
    begin = end + 1;
  }
}

TEST(Wrapped, KeepsAWordThatIsTooLongWhole) {
  EXPECT_EQ(wrapped("a " + std::string(100, 'b'), 2), "a\n  " + std::string(100, 'b'));
  EXPECT_EQ(wrapped("", 2), "");
}

TEST(Digits, KeepsFourThatSignify) {
  EXPECT_EQ(digits(0.0635), "0.06350");
  EXPECT_EQ(digits(11.8249), "11.82");
  EXPECT_EQ(digits(1234.4), "1234");
  EXPECT_EQ(digits(0.0), "0.000");
  EXPECT_EQ(digits(1.7764e-15), "1.776e-15");
}

TEST(Digits, HasNoExponentBelowAMillion) {
  EXPECT_EQ(digits(174.6, 2), "175");
  EXPECT_EQ(digits(99.7, 2), "100");
  EXPECT_EQ(digits(-123456.7), "-123457");
  EXPECT_EQ(digits(1.234e6), "1.234e+06");
}

TEST(Beginning, NeverEndsWithinALetter) {
  EXPECT_EQ(beginning("abc", 3), "abc");
  EXPECT_EQ(beginning("abcd", 3), "abc");
  const std::string letters = "a\u00e9\u65e5";  // of one, two and three bytes
  EXPECT_EQ(beginning(letters, 6), letters);
  EXPECT_EQ(beginning(letters, 5), "a\u00e9");
  EXPECT_EQ(beginning(letters, 2), "a");
  EXPECT_EQ(beginning(letters, 0), "");
}

TEST(Percent, NeverRoundsSomethingToNothing) {
  EXPECT_EQ(percent(0.0), "0 %");
  EXPECT_EQ(percent(0.076), "7.60 %");
  EXPECT_EQ(percent(0.301), "30.1 %");
  EXPECT_EQ(percent(3.1e-5), "0.0031 %");
  EXPECT_EQ(percent(2.6e-16), "0 %") << "rounding";
}

TEST(Counted, PutsTheNounInItsNumber) {
  EXPECT_EQ(counted(1, "sweep"), "1 sweep");
  EXPECT_EQ(counted(0, "sweep"), "0 sweeps");
}

TEST(Text, IsShownWithoutWhatATerminalObeys) {
  std::ostringstream shown;
  shown << Shown{"a\x1b[31m\x07\x7f\r\n\tb \xc3\xa9 \xc2\x9b \xe2\x80\x9b"};
  EXPECT_EQ(shown.str(), "a?[31m???\n\tb \xc3\xa9 \xc2? \xe2\x80\x9b");
}

}  // namespace
}  // namespace planish::cli
