#include <planish/io/write_file.h>

#include <gtest/gtest.h>

#include "platform/windows/handle.h"
#include "unit/io/file/expect_unwritable.h"

namespace planish {
namespace {

class WriteFilesOnWindows : public OwnFolder {};

TEST_F(WriteFilesOnWindows, NamesTheFileThatAnotherProgramHasOpenAndTakesTheOthersBack) {
  put_file(folder_ / "a", "old");
  put_file(folder_ / "b", "old, too");
  const Handle held(CreateFileW((folder_ / "b").c_str(), GENERIC_READ, FILE_SHARE_READ, nullptr,
                                OPEN_EXISTING, 0, nullptr));
  ASSERT_TRUE(held);
  for (const bool several : {true, false}) {
    std::vector<OutputFile> files = {{folder_ / "b", "new"}};
    if (several) files = {{folder_ / "a", "new"}, {folder_ / "b", "new"}, {folder_ / "c", "new"}};
    const Error error = error_of([&] { write_files(files); });
    EXPECT_EQ(error.code(), ErrorCode::file_unwritable);
    EXPECT_EQ(error.place().path, utf8_of(folder_ / "b"));
    EXPECT_NE(error.message().find("another program has it open"), std::string::npos)
        << error.message();
  }
  EXPECT_EQ(content_of(folder_ / "a"), "old");
  EXPECT_EQ(content_of(folder_ / "b"), "old, too");
  EXPECT_EQ(names(), (std::vector<std::string>{"a", "b"}));
}

TEST_F(WriteFilesOnWindows, RefusesNamesOfDevices) {
  for (const char* const name : {"NUL", "nul.obj", "COM1"}) {
    const Error error = error_of([&] { write_files(std::vector<OutputFile>{{name, "1"}}); });
    EXPECT_EQ(error.code(), ErrorCode::file_unwritable);
    EXPECT_NE(error.message().find("device"), std::string::npos) << error.message();
  }
}

}  // namespace
}  // namespace planish
