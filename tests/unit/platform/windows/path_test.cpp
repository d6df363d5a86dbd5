#include "platform/path.h"

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(WindowsPathOf, HasSlashesInItsText) {
  EXPECT_EQ(utf8_of(path_of("C:\\a\\b c")), "C:/a/b c");
  EXPECT_EQ(utf8_of(path_of("a") / path_of("b")), "a/b");
  EXPECT_EQ(utf8_of(path_of("\\\\server\\share\\a")), "//server/share/a");
}

TEST(WindowsPathOf, KeepsNamesThatTheSystemTakesWithoutAnyChange) {
  const std::string verbatim = "\\\\?\\C:\\a\\b";
  EXPECT_EQ(utf8_of(path_of(verbatim)), verbatim);
}

TEST(WindowsPathOf, TakesOtherBytesForLettersThatNoFileHas) {
  EXPECT_EQ(path_of("a\xFF.obj").native(), L"a\xFFFD.obj");
  EXPECT_EQ(utf8_of(path_of("a\xFF.obj")), "a\xEF\xBF\xBD.obj");
  EXPECT_EQ(utf8_of(std::filesystem::path(L"\xD83E")), "\xEF\xBF\xBD");
}

TEST(WindowsForbiddenLetter, IsTheFirstThatNoNameCanHave) {
  EXPECT_EQ(forbidden_letter(path_of("C:\\a b\\\xC3\xB6.obj")), 0);
  EXPECT_EQ(forbidden_letter(path_of("\\\\?\\C:\\a")), 0);
  EXPECT_EQ(forbidden_letter(path_of("out dm\" --unit *")), '"');
  EXPECT_EQ(forbidden_letter(path_of("a*.obj")), '*');
}

}  // namespace
}  // namespace planish
