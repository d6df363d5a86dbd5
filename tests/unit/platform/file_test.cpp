#include "platform/file.h"

#include <gtest/gtest.h>

#include "support/own_folder.h"

namespace planish {
namespace {

class PlatformFile : public OwnFolder {};

TEST_F(PlatformFile, HasEveryByteOfLargeAndBinaryContent) {
  std::string content(3'000'000, '\0');
  for (std::size_t i = 0; i < content.size(); ++i)
    content[i] = static_cast<char>(i * i >> 8);
  put_file(folder_ / "a", content);
  const FileContent file(folder_ / "a");
  EXPECT_FALSE(file.fault());
  EXPECT_FALSE(file.is_device());
  EXPECT_EQ(file.bytes(), content);
}

TEST_F(PlatformFile, KeepsCarriageReturnsAndEndsOfFile) {
  const std::string content = "a\r\nb\nc\r\x1a\0d";
  ASSERT_FALSE(write_new_file(folder_ / "a", content));
  EXPECT_EQ(content_of(folder_ / "a"), content);
  EXPECT_EQ(FileContent(folder_ / "a").bytes(), content);
}

TEST_F(PlatformFile, OfNothingHasNoBytesAndNoFault) {
  ASSERT_FALSE(write_new_file(folder_ / "a", ""));
  const FileContent file(folder_ / "a");
  EXPECT_FALSE(file.fault());
  EXPECT_TRUE(file.bytes().empty());
}

TEST_F(PlatformFile, ThatIsMissingOrAFolderHasItsCause) {
  put_file(folder_ / "a", "1");
  EXPECT_EQ(FileContent(folder_ / "none").fault(), std::errc::no_such_file_or_directory);
  EXPECT_EQ(FileContent(folder_ / "none" / "a").fault(), std::errc::no_such_file_or_directory);
  // Windows has one cause for both.
  const std::error_code below_a_file = FileContent(folder_ / "a" / "b").fault();
  EXPECT_TRUE(below_a_file == std::errc::not_a_directory ||
              below_a_file == std::errc::no_such_file_or_directory)
      << below_a_file.message();
  EXPECT_EQ(FileContent(folder_).fault(), std::errc::is_a_directory);
  EXPECT_TRUE(FileContent(folder_).bytes().empty());
}

TEST_F(PlatformFile, ThatIsThereIsNotWrittenAnew) {
  put_file(folder_ / "a", "old");
  EXPECT_EQ(write_new_file(folder_ / "a", "new"), std::errc::file_exists);
  EXPECT_EQ(content_of(folder_ / "a"), "old");
  EXPECT_EQ(write_new_file(folder_ / "none" / "a", "new"), std::errc::no_such_file_or_directory);
  EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

TEST_F(PlatformFile, TakesThePlaceOfAnotherOrOfNone) {
  put_file(folder_ / "a", "old");
  put_file(folder_ / "b", "new");
  EXPECT_FALSE(replace_file(folder_ / "b", folder_ / "a"));
  EXPECT_EQ(names(), std::vector<std::string>{"a"});
  EXPECT_EQ(content_of(folder_ / "a"), "new");
  EXPECT_FALSE(replace_file(folder_ / "a", folder_ / "c"));
  EXPECT_EQ(names(), std::vector<std::string>{"c"});
}

TEST_F(PlatformFile, StaysWhereItCannotTakeAPlace) {
  put_file(folder_ / "a", "old");
  std::filesystem::create_directory(folder_ / "x");
  EXPECT_EQ(replace_file(folder_ / "none", folder_ / "a"), std::errc::no_such_file_or_directory);
  EXPECT_TRUE(replace_file(folder_ / "a", folder_ / "x"));
  EXPECT_TRUE(replace_file(folder_ / "a", folder_ / "none" / "a"));
  EXPECT_EQ(content_of(folder_ / "a"), "old");
  EXPECT_EQ(names(), (std::vector<std::string>{"a", "x"}));
}

TEST(ProcessNumber, IsOneOfThisProcess) {
  EXPECT_GT(process_number(), 0);
  EXPECT_EQ(process_number(), process_number());
}

}  // namespace
}  // namespace planish
