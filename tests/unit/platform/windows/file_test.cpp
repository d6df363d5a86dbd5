#include "platform/file.h"

#include <gtest/gtest.h>

#include "platform/windows/handle.h"
#include "support/own_folder.h"

namespace planish {
namespace {

class WindowsFile : public OwnFolder {
 protected:
  /// As another program opens a file: with all that it needs, and sharing only so much.
  Handle open(const char* name, DWORD access, DWORD share) const {
    return Handle(
        CreateFileW((folder_ / name).c_str(), access, share, nullptr, OPEN_EXISTING, 0, nullptr));
  }
};

TEST_F(WindowsFile, ThatAnotherProgramHasOpenIsNotReplaced) {
  put_file(folder_ / "a", "old");
  put_file(folder_ / "b", "new");
  {
    const Handle held = open("a", GENERIC_READ, FILE_SHARE_READ);
    ASSERT_TRUE(held);
    const std::error_code fault = replace_file(folder_ / "b", folder_ / "a");
    EXPECT_EQ(fault, std::errc::text_file_busy) << fault.message();
    EXPECT_TRUE(fault.message().starts_with("another program has it open")) << fault.message();
  }
  EXPECT_EQ(content_of(folder_ / "a"), "old");
  EXPECT_EQ(content_of(folder_ / "b"), "new");
  EXPECT_FALSE(replace_file(folder_ / "b", folder_ / "a"));
  EXPECT_EQ(content_of(folder_ / "a"), "new");
}

TEST_F(WindowsFile, ThatIsMappedIsNotReplaced) {
  put_file(folder_ / "a", "old");
  put_file(folder_ / "b", "new");
  {
    const FileContent content(folder_ / "a");
    EXPECT_TRUE(replace_file(folder_ / "b", folder_ / "a"));
    EXPECT_EQ(content.bytes(), "old");
  }
  EXPECT_FALSE(replace_file(folder_ / "b", folder_ / "a"));
}

TEST_F(WindowsFile, ThatAnotherProgramDoesNotShareHasItsCause) {
  put_file(folder_ / "a", "old");
  const Handle held = open("a", GENERIC_READ | GENERIC_WRITE, 0);
  ASSERT_TRUE(held);
  EXPECT_EQ(FileContent(folder_ / "a").fault(), std::errc::text_file_busy);
  EXPECT_EQ(write_into(folder_ / "a", "1"), std::errc::text_file_busy);
  EXPECT_EQ(hold_on(folder_ / "a"), std::errc::text_file_busy);
  EXPECT_FALSE(hold_on(folder_ / "none"));
}

TEST_F(WindowsFile, ThatIsReadOnlyIsNotReplaced) {
  put_file(folder_ / "a", "old");
  put_file(folder_ / "b", "new");
  ASSERT_NE(SetFileAttributesW((folder_ / "a").c_str(), FILE_ATTRIBUTE_READONLY), 0);
  EXPECT_EQ(replace_file(folder_ / "b", folder_ / "a"), std::errc::permission_denied);
  EXPECT_EQ(content_of(folder_ / "a"), "old");
  SetFileAttributesW((folder_ / "a").c_str(), FILE_ATTRIBUTE_NORMAL);
}

TEST_F(WindowsFile, IsADeviceByItsName) {
  const FileContent file("NUL");
  EXPECT_TRUE(file.is_device());
  EXPECT_FALSE(file.fault());
  EXPECT_FALSE(write_into("NUL", "1"));
}

TEST_F(WindowsFile, IsNotMadeWithTheNameOfADevice) {
  for (const char* name : {"NUL", "nul.obj", "COM1", "con.svg"}) {
    const std::error_code fault = write_new_file(folder_ / name, "1");
    EXPECT_EQ(fault, std::errc::invalid_argument) << name;
    EXPECT_NE(fault.message().find("device"), std::string::npos) << fault.message();
  }
  EXPECT_FALSE(write_new_file(folder_ / "null.obj", "1"));
}

TEST_F(WindowsFile, IsNotMadeByWritingInto) {
  EXPECT_EQ(write_into(folder_ / "none", "1"), std::errc::no_such_file_or_directory);
  EXPECT_TRUE(names().empty());
}

TEST(WindowsFault, HasTheCauseThatOtherSystemsName) {
  EXPECT_EQ(fault_of(ERROR_PATH_NOT_FOUND), std::errc::no_such_file_or_directory);
  EXPECT_EQ(fault_of(ERROR_ALREADY_EXISTS), std::errc::file_exists);
  EXPECT_EQ(fault_of(ERROR_ACCESS_DENIED), std::errc::permission_denied);
  EXPECT_EQ(fault_of(ERROR_DISK_FULL), std::errc::no_space_on_device);
  EXPECT_EQ(fault_of(ERROR_NOT_ENOUGH_MEMORY), std::errc::not_enough_memory);
  EXPECT_EQ(fault_of(ERROR_LOCK_VIOLATION), std::errc::text_file_busy);
  EXPECT_EQ(fault_of(ERROR_CRC), std::errc::io_error);
}

}  // namespace
}  // namespace planish
