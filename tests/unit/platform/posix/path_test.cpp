#include "platform/path.h"

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(PosixPathOf, KeepsBytesThatAreNoText) {
  for (const std::string name : {"\xFF\xFE", "a\xC3", "\xED\xA0\x80", "C:\\a\\b", "a//b/./c/"}) {
    EXPECT_EQ(path_of(name).native(), name);
    EXPECT_EQ(utf8_of(path_of(name)), name);
  }
}

}  // namespace
}  // namespace planish
