#include <thread>

#include <planish/io/write_file.h>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "support/size_limit.h"
#include "unit/io/file/expect_unwritable.h"

namespace planish {
namespace {

using std::filesystem::path;

class WriteFilesOnPosix : public OwnFolder {};

TEST_F(WriteFilesOnPosix, GivesFilesThatItReplacesTheModeThatTheMaskLeaves) {
  put_file(folder_ / "a", "old");
  ASSERT_EQ(chmod((folder_ / "a").c_str(), 0600), 0);
  const mode_t before = umask(027);
  write_files(std::vector<OutputFile>{{folder_ / "a", "1"}});
  umask(before);
  struct stat status = {};
  ASSERT_EQ(stat((folder_ / "a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST_F(WriteFilesOnPosix, WritesThroughSymbolicLinks) {
  put_file(folder_ / "real", "old");
  std::filesystem::create_symlink("real", folder_ / "link");
  write_files(std::vector<OutputFile>{{folder_ / "link", "new"}});
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link"));
  EXPECT_EQ(content_of(folder_ / "real"), "new");
}

TEST_F(WriteFilesOnPosix, ReplacesLinksBelowItsFolder) {
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

TEST_F(WriteFilesOnPosix, RefusesLinksAndPipesOnTheWayBelowItsFolder) {
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

TEST_F(WriteFilesOnPosix, FollowsLinksToAndBesideItsFolder) {
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

TEST_F(WriteFilesOnPosix, WritesIntoPipesDirectly) {
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

TEST_F(WriteFilesOnPosix, AcceptsTheNullDevice) {
  EXPECT_NO_THROW(write_files(std::vector<OutputFile>{{"/dev/null", "1"}}));
}

TEST_F(WriteFilesOnPosix, RefusesAFullDeviceAndTakesTheOthersBack) {
  if (!std::filesystem::exists("/dev/full")) return;
  put_file(folder_ / "a", "old");
  expect_unwritable({{folder_ / "a", "new"}, {folder_ / "x" / "b", "new"}, {"/dev/full", "1"}},
                    "/dev/full");
  EXPECT_EQ(content_of(folder_ / "a"), "old");
  EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

TEST_F(WriteFilesOnPosix, LeavesAllAsItWasWhenTheDiskIsFull) {
  put_file(folder_ / "a", "old");
  put_file(folder_ / "b", "old, too");
  {
    const SizeLimit limit(1000);
    expect_unwritable({{folder_ / "a", "new"}, {folder_ / "b", std::string(2000, 'x')}},
                      folder_ / "b");
    expect_unwritable({{folder_ / "b", std::string(2000, 'x')}}, folder_ / "b");
    expect_unwritable({{folder_ / "c", std::string(2000, 'x')}}, folder_ / "c");
  }
  EXPECT_EQ(content_of(folder_ / "a"), "old");
  EXPECT_EQ(content_of(folder_ / "b"), "old, too");
  EXPECT_EQ(names(), (std::vector<std::string>{"a", "b"}));
}

}  // namespace
}  // namespace planish
