#include <thread>

#include <planish/io/write_file.h>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/size_limit.h"
#include "unit/io/io_testing.h"

namespace planish {
namespace {

using std::filesystem::path;

class WriteFiles : public OwnFolder {
 protected:
  /// Writes and checks that it is refused with the path of the file at fault.
  void expect_refused(const std::vector<OutputFile>& files, const path& at_fault) {
    const Error error = error_of([&] { write_files(files); });
    EXPECT_EQ(error.code(), ErrorCode::file_unwritable) << error.what();
    EXPECT_EQ(error.place().path, at_fault.string());
    EXPECT_TRUE(error.message().starts_with("cannot be written: ")) << error.what();
  }
};

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

TEST_F(WriteFiles, GivesFilesThatItReplacesTheModeThatTheMaskLeaves) {
  put_file(folder_ / "a", "old");
  ASSERT_EQ(chmod((folder_ / "a").c_str(), 0600), 0);
  const mode_t before = umask(027);
  write_files(std::vector<OutputFile>{{folder_ / "a", "1"}});
  umask(before);
  struct stat status = {};
  ASSERT_EQ(stat((folder_ / "a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST_F(WriteFiles, WritesThroughSymbolicLinks) {
  put_file(folder_ / "real", "old");
  std::filesystem::create_symlink("real", folder_ / "link");
  write_files(std::vector<OutputFile>{{folder_ / "link", "new"}});
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link"));
  EXPECT_EQ(content_of(folder_ / "real"), "new");
}

TEST_F(WriteFiles, ReplacesLinksBelowItsFolder) {
  put_file(folder_ / "real", "old");
  std::filesystem::create_directory(folder_ / "out");
  for (const char* to : {"../real", "nowhere", "a"}) {
    std::filesystem::create_symlink(to, folder_ / "out" / "a");
    write_files(std::vector<OutputFile>{{folder_ / "out" / "a", "new"}}, folder_ / "out");
    EXPECT_FALSE(std::filesystem::is_symlink(folder_ / "out" / "a"));
    EXPECT_EQ(content_of(folder_ / "out" / "a"), "new");
    std::filesystem::remove(folder_ / "out" / "a");
  }
  EXPECT_EQ(content_of(folder_ / "real"), "old");
}

TEST_F(WriteFiles, RefusesLinksAndPipesOnTheWayBelowItsFolder) {
  std::filesystem::create_directories(folder_ / "out" / "x");
  std::filesystem::create_directory(folder_ / "elsewhere");
  std::filesystem::create_symlink("../../elsewhere", folder_ / "out" / "x" / "link");
  ASSERT_EQ(mkfifo((folder_ / "out" / "pipe").c_str(), 0600), 0);
  for (const path& place :
       {path("x/link/a"), path("x/link/y/a"), path("x/../x/link/a"), path("pipe")}) {
    const std::vector<OutputFile> files = {{folder_ / "out" / "b", "1"},
                                           {folder_ / "out" / place, "1"}};
    const Error error = error_of([&] { write_files(files, folder_ / "out"); });
    EXPECT_EQ(error.code(), ErrorCode::file_unwritable) << error.what();
  }
  std::filesystem::remove(folder_ / "out" / "x" / "link");
  EXPECT_EQ(names(), (std::vector<std::string>{"elsewhere", "out", "out/pipe", "out/x"}));
}

TEST_F(WriteFiles, FollowsLinksToAndBesideItsFolder) {
  std::filesystem::create_directory(folder_ / "real");
  std::filesystem::create_symlink("real", folder_ / "out");
  put_file(folder_ / "history", "old");
  std::filesystem::create_symlink("history", folder_ / "link");
  write_files(std::vector<OutputFile>{{folder_ / "out" / "a", "new"}, {folder_ / "link", "new"}},
              folder_ / "out");
  EXPECT_EQ(content_of(folder_ / "real" / "a"), "new");
  EXPECT_EQ(content_of(folder_ / "history"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link"));
}

TEST_F(WriteFiles, WritesIntoPipesDirectly) {
  const path pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = content_of(pipe); });
  const std::string content(300'000, 'x');
  write_files(std::vector<OutputFile>{{pipe, content}});
  reader.join();
  EXPECT_EQ(got, content);
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST_F(WriteFiles, AcceptsTheNullDevice) {
  EXPECT_NO_THROW(write_files(std::vector<OutputFile>{{"/dev/null", "1"}}));
}

TEST_F(WriteFiles, RefusesAFullDeviceAndTakesTheOthersBack) {
  if (!std::filesystem::exists("/dev/full")) return;
  put_file(folder_ / "a", "old");
  expect_refused({{folder_ / "a", "new"}, {folder_ / "x" / "b", "new"}, {"/dev/full", "1"}},
                 "/dev/full");
  EXPECT_EQ(content_of(folder_ / "a"), "old");
  EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

TEST_F(WriteFiles, RefusesFoldersAndPathsThatNameNoFile) {
  std::filesystem::create_directory(folder_ / "x");
  expect_refused({{folder_ / "a", "1"}, {folder_ / "x", "1"}}, folder_ / "x");
  expect_refused({{folder_ / "a", "1"}, {folder_ / "x" / "", "1"}}, folder_ / "x" / "");
  expect_refused({{folder_ / "a", "1"}, {folder_ / "new" / "", "1"}}, folder_ / "new" / "");
  expect_refused({{"", "1"}}, "");
  EXPECT_EQ(names(), std::vector<std::string>{"x"});
}

TEST_F(WriteFiles, RefusesPathsBelowAFileAndKeepsTheOldContent) {
  put_file(folder_ / "a", "old");
  expect_refused({{folder_ / "a", "new"},
                  {folder_ / "n" / "m" / "b", "new"},
                  {folder_ / "a" / "b" / "c", "1"}},
                 folder_ / "a" / "b" / "c");
  EXPECT_EQ(content_of(folder_ / "a"), "old");
  EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

TEST_F(WriteFiles, RefusesNamesThatAreTooLong) {
  const path name = folder_ / std::string(300, 'x');
  expect_refused({{folder_ / "a", "1"}, {name, "1"}}, name);
  EXPECT_TRUE(names().empty());
}

TEST_F(WriteFiles, LeavesAllAsItWasWhenTheDiskIsFull) {
  put_file(folder_ / "a", "old");
  put_file(folder_ / "b", "old, too");
  {
    const SizeLimit limit(1000);
    expect_refused({{folder_ / "a", "new"}, {folder_ / "b", std::string(2000, 'x')}},
                   folder_ / "b");
    expect_refused({{folder_ / "b", std::string(2000, 'x')}}, folder_ / "b");
    expect_refused({{folder_ / "c", std::string(2000, 'x')}}, folder_ / "c");
  }
  EXPECT_EQ(content_of(folder_ / "a"), "old");
  EXPECT_EQ(content_of(folder_ / "b"), "old, too");
  EXPECT_EQ(names(), (std::vector<std::string>{"a", "b"}));
}

TEST_F(WriteFiles, PutsOldContentBackWhenALaterFileCannotTakeItsPlace) {
  put_file(folder_ / "a", "old");
  // "x" is wanted as a file and, for the sake of "x/b", as a folder: renaming fails.
  expect_refused({{folder_ / "a", "new"},
                  {folder_ / "fresh", "new"},
                  {folder_ / "x", "1"},
                  {folder_ / "x" / "b", "1"}},
                 folder_ / "x");
  EXPECT_EQ(content_of(folder_ / "a"), "old");
  EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

TEST_F(WriteFiles, KeepsOtherPeoplesPartialFiles) {
  const std::string stranger = "a.planish-partial-" + std::to_string(getpid()) + "-0";
  put_file(folder_ / stranger, "not ours");
  write_files(std::vector<OutputFile>{{folder_ / "a", "1"}});
  EXPECT_EQ(content_of(folder_ / stranger), "not ours");
  EXPECT_EQ(names(), (std::vector<std::string>{"a", stranger}));
}

}  // namespace
}  // namespace planish
