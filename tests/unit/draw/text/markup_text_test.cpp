#include "draw/text/markup_text.h"

#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace planish {
namespace {

using namespace std::string_literals;

TEST(EscapeMarkup, TurnsTheCharactersOfMarkupIntoEntities) {
  EXPECT_EQ(escape_markup("<b a=\"1\" c='2'>&amp;"),
            "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;amp;");
}

TEST(EscapeMarkup, KeepsSoundUtf8OfAnyLength) {
  const std::string text = "a é € 😀 \u07FF \uFFFD \U0010FFFD";
  EXPECT_EQ(escape_markup(text), text);
}

TEST(EscapeMarkup, ReplacesEveryByteThatIsNoUtf8) {
  const std::string bad = "\uFFFD";
  for (const auto& [text, shown] : {
           std::pair{"a\xFF"s + "b", "a" + bad + "b"},
           std::pair{"\x80"s, bad},                                // goes on with nothing
           std::pair{"\xC3"s, bad},                                // ends too early
           std::pair{"\xE2\x82"s, bad + bad},                      // likewise
           std::pair{"\xC0\xAF"s, bad + bad},                      // too long a form of '/'
           std::pair{"\xE0\x80\xAF"s, bad + bad + bad},            // likewise
           std::pair{"\xED\xA0\x80"s, bad + bad + bad},            // half of a surrogate pair
           std::pair{"\xF4\x90\x80\x80"s, bad + bad + bad + bad},  // beyond the last code point
           std::pair{"\xC3<"s, bad + "&lt;"},                      // what follows is not swallowed
       }) {
    EXPECT_EQ(escape_markup(text), shown);
  }
}

TEST(EscapeMarkup, LeavesNoControlCharacter) {
  EXPECT_EQ(escape_markup("a\tb\nc\rd"), "a b c d");
  EXPECT_EQ(escape_markup("\0\x1B\x7F"s), "\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(escape_markup("\u0085\uFFFE\uFFFF"), "\uFFFD\uFFFD\uFFFD");
}

}  // namespace
}  // namespace planish
