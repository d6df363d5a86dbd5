#include "platform/path.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "support/own_folder.h"

namespace planish {
namespace {

TEST(PosixPathOf, KeepsBytesThatAreNoText) {
  for (const std::string name : {"\xFF\xFE", "a\xC3", "\xED\xA0\x80", "C:\\a\\b", "a//b/./c/"}) {
    EXPECT_EQ(path_of(name).native(), name);
    EXPECT_EQ(utf8_of(path_of(name)), name);
  }
}

class MayWriteInto : public OwnFolder {};

TEST_F(MayWriteInto, SaysWhatTheSystemAllows) {
  EXPECT_TRUE(may_write_into(folder_));
  EXPECT_FALSE(may_write_into(folder_ / "none"));
  std::filesystem::permissions(folder_, std::filesystem::perms::owner_read);
  const bool is_root = geteuid() == 0;  // it may write anywhere
  EXPECT_EQ(may_write_into(folder_), is_root);
  std::filesystem::permissions(folder_, std::filesystem::perms::owner_all);
}

}  // namespace
}  // namespace planish
