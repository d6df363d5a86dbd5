#include <planish/io/write_file.h>

#include <gtest/gtest.h>

#include "platform/file.h"
#include "unit/io/file/expect_unwritable.h"

namespace planish {
namespace {

using std::filesystem::path;

class WriteFiles : public OwnFolder {};

TEST_F(WriteFiles, WritesSeveralFilesAndNothingElse) {
  write_files(std::vector<OutputFile>{{folder_ / "a", "one"}, {folder_ / "b", ""}});
  EXPECT_EQ(names(), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(content_of(folder_ / "a"), "one");
  EXPECT_EQ(content_of(folder_ / "b"), "");
  EXPECT_NO_THROW(write_files({}));
}

TEST_F(WriteFiles, WritesEveryByteOfLargeAndBinaryContent) {
  std::string content(5'000'000, '\0');
  for (std::size_t i = 0; i < content.size(); ++i)
    content[i] = static_cast<char>(i * i >> 8);
  write_files(std::vector<OutputFile>{{folder_ / "a", content}});
  EXPECT_EQ(content_of(folder_ / "a"), content);
}

TEST_F(WriteFiles, ReplacesFilesThatAreThere) {
  put_file(folder_ / "a", "old and longer");
  put_file(folder_ / "b", "old");
  write_files(std::vector<OutputFile>{{folder_ / "a", "new"}, {folder_ / "b", "new, too"}});
  EXPECT_EQ(content_of(folder_ / "a"), "new");
  EXPECT_EQ(content_of(folder_ / "b"), "new, too");
  EXPECT_EQ(names().size(), 2U);
}

TEST_F(WriteFiles, MakesFoldersThatAreMissing) {
  write_files(
      std::vector<OutputFile>{{folder_ / "x" / "y" / "a", "1"}, {folder_ / "x" / "b", "2"}});
  EXPECT_EQ(names(), (std::vector<std::string>{"x", "x/b", "x/y", "x/y/a"}));
}

TEST_F(WriteFiles, WritesIntoTheFolderOfTheProcess) {
  const path before = std::filesystem::current_path();
  std::filesystem::current_path(folder_);
  write_files(std::vector<OutputFile>{{"a", "1"}, {"./x/../x/b", "2"}});
  std::filesystem::current_path(before);
  EXPECT_EQ(names(), (std::vector<std::string>{"a", "x", "x/b"}));
}

TEST_F(WriteFiles, RefusesFoldersAndPathsThatNameNoFile) {
  std::filesystem::create_directory(folder_ / "x");
  expect_unwritable({{folder_ / "a", "1"}, {folder_ / "x", "1"}}, folder_ / "x");
  expect_unwritable({{folder_ / "a", "1"}, {folder_ / "x" / "", "1"}}, folder_ / "x" / "");
  expect_unwritable({{folder_ / "a", "1"}, {folder_ / "new" / "", "1"}}, folder_ / "new" / "");
  expect_unwritable({{"", "1"}}, "");
  EXPECT_EQ(names(), std::vector<std::string>{"x"});
}

TEST_F(WriteFiles, RefusesPathsBelowAFileAndKeepsTheOldContent) {
  put_file(folder_ / "a", "old");
  expect_unwritable({{folder_ / "a", "new"},
                     {folder_ / "n" / "m" / "b", "new"},
                     {folder_ / "a" / "b" / "c", "1"}},
                    folder_ / "a" / "b" / "c");
  EXPECT_EQ(content_of(folder_ / "a"), "old");
  EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

TEST_F(WriteFiles, RefusesNamesThatAreTooLong) {
  const path name = folder_ / std::string(300, 'x');
  expect_unwritable({{folder_ / "a", "1"}, {name, "1"}}, name);
  EXPECT_TRUE(names().empty());
}

TEST_F(WriteFiles, PutsOldContentBackWhenALaterFileCannotTakeItsPlace) {
  put_file(folder_ / "a", "old");
  // "x" is wanted as a file and, for the sake of "x/b", as a folder: renaming fails.
  expect_unwritable({{folder_ / "a", "new"},
                     {folder_ / "fresh", "new"},
                     {folder_ / "x", "1"},
                     {folder_ / "x" / "b", "1"}},
                    folder_ / "x");
  EXPECT_EQ(content_of(folder_ / "a"), "old");
  EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

TEST_F(WriteFiles, KeepsOtherPeoplesPartialFiles) {
  const std::string stranger = "a.planish-partial-" + std::to_string(process_number()) + "-0";
  put_file(folder_ / stranger, "not ours");
  write_files(std::vector<OutputFile>{{folder_ / "a", "1"}});
  EXPECT_EQ(content_of(folder_ / stranger), "not ours");
  EXPECT_EQ(names(), (std::vector<std::string>{"a", stranger}));
}

}  // namespace
}  // namespace planish
