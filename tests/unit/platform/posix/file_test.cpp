#include "platform/file.h"

#include <thread>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/own_folder.h"
#include "support/size_limit.h"

namespace planish {
namespace {

namespace fs = std::filesystem;

/// Root may read everything: while this lives, the process acts as the user "nobody".
class WithoutPrivileges {
 public:
  WithoutPrivileges() {
    constexpr uid_t nobody = 65534;
    EXPECT_EQ(seteuid(before_ == 0 ? nobody : before_), 0);
  }
  ~WithoutPrivileges() { EXPECT_EQ(seteuid(before_), 0); }
  WithoutPrivileges(const WithoutPrivileges&) = delete;
  WithoutPrivileges& operator=(const WithoutPrivileges&) = delete;

 private:
  uid_t before_ = geteuid();
};

class PosixFile : public OwnFolder {
 protected:
  mode_t mode_of(const char* name) const {
    struct stat status = {};
    EXPECT_EQ(stat((folder_ / name).c_str(), &status), 0);
    return status.st_mode & 0777U;
  }
};

TEST_F(PosixFile, ThatIsAPipeIsReadToItsEnd) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string content(300'000, 'x');  // more than a pipe holds at once
  std::thread writer([&] { put_file(pipe, content); });
  const FileContent file(pipe);
  writer.join();
  EXPECT_FALSE(file.fault());
  EXPECT_EQ(file.bytes(), content);
}

TEST_F(PosixFile, ThatTellsNoSizeIsReadToItsEnd) {
  EXPECT_TRUE(FileContent("/proc/self/status").bytes().starts_with("Name:"));
}

TEST_F(PosixFile, ThatFailsWhileItIsReadHasItsCauseAndNoBytes) {
  const FileContent file("/proc/self/mem");
  EXPECT_EQ(file.fault(), std::errc::io_error);
  EXPECT_TRUE(file.bytes().empty());
}

TEST_F(PosixFile, IsNotReadWhereItIsADevice) {
  fs::create_symlink("/dev/zero", folder_ / "zero");
  const FileContent file(folder_ / "zero");
  EXPECT_TRUE(file.is_device());
  EXPECT_FALSE(file.fault());
  EXPECT_TRUE(file.bytes().empty());
}

TEST_F(PosixFile, IsReadThroughLinksButNotThroughLoops) {
  put_file(folder_ / "a", "1");
  fs::create_symlink("a", folder_ / "link");
  fs::create_symlink("loop", folder_ / "loop");
  EXPECT_EQ(FileContent(folder_ / "link").bytes(), "1");
  EXPECT_EQ(FileContent(folder_ / "loop").fault(), std::errc::too_many_symbolic_link_levels);
}

TEST_F(PosixFile, KeepsItsContentWhenItsNameIsGone) {
  put_file(folder_ / "a", "old");
  put_file(folder_ / "b", "new");
  const FileContent file(folder_ / "a");
  EXPECT_FALSE(replace_file(folder_ / "b", folder_ / "a"));
  EXPECT_EQ(file.bytes(), "old");
}

TEST_F(PosixFile, ThatMayNotBeReadHasItsCause) {
  put_file(folder_ / "a", "1");
  put_file(folder_ / "b", "2");
  fs::permissions(folder_ / "a", fs::perms::none);
  const WithoutPrivileges user;
  EXPECT_EQ(FileContent(folder_ / "a").fault(), std::errc::permission_denied);
  EXPECT_EQ(FileContent(folder_ / "b").bytes(), "2");
}

TEST_F(PosixFile, HasTheModeThatTheMaskLeaves) {
  const mode_t before = umask(027);
  EXPECT_FALSE(write_new_file(folder_ / "a", "1"));
  umask(before);
  EXPECT_EQ(mode_of("a"), 0640U);
}

TEST_F(PosixFile, IsNotMadeThroughALinkThatLeadsNowhere) {
  fs::create_symlink("nowhere", folder_ / "link");
  EXPECT_EQ(write_new_file(folder_ / "link", "1"), std::errc::file_exists);
  EXPECT_EQ(names(), std::vector<std::string>{"link"});
}

TEST_F(PosixFile, ThatDoesNotFitOnTheDiskHasItsCause) {
  const SizeLimit limit(1000);
  EXPECT_EQ(write_new_file(folder_ / "a", std::string(1001, 'x')), std::errc::file_too_large);
  EXPECT_FALSE(write_new_file(folder_ / "b", std::string(1000, 'x')));
  if (!fs::exists("/dev/full")) return;
  EXPECT_EQ(write_into("/dev/full", "1"), std::errc::no_space_on_device);
}

TEST_F(PosixFile, IsNotMadeByWritingInto) {
  EXPECT_EQ(write_into(folder_ / "none", "1"), std::errc::no_such_file_or_directory);
  EXPECT_TRUE(names().empty());
}

TEST_F(PosixFile, ThatIsAPipeTakesAll) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = content_of(pipe); });
  const std::string content(300'000, 'x');
  EXPECT_FALSE(write_into(pipe, content));
  reader.join();
  EXPECT_EQ(got, content);
}

TEST_F(PosixFile, ThatTakesAPlaceKeepsItsOwnMode) {
  put_file(folder_ / "a", "old");
  put_file(folder_ / "b", "new");
  chmod((folder_ / "a").c_str(), 0600);
  chmod((folder_ / "b").c_str(), 0644);
  EXPECT_FALSE(replace_file(folder_ / "b", folder_ / "a"));
  EXPECT_EQ(mode_of("a"), 0644U);
}

TEST_F(PosixFile, TakesThePlaceOfALinkAndLeavesWhereItLed) {
  put_file(folder_ / "real", "old");
  put_file(folder_ / "b", "new");
  fs::create_symlink("real", folder_ / "link");
  EXPECT_FALSE(replace_file(folder_ / "b", folder_ / "link"));
  EXPECT_FALSE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(content_of(folder_ / "link"), "new");
  EXPECT_EQ(content_of(folder_ / "real"), "old");
}

TEST_F(PosixFile, LeavesTheOldContentItsOtherNames) {
  put_file(folder_ / "a", "old");
  put_file(folder_ / "b", "new");
  fs::create_hard_link(folder_ / "a", folder_ / "second");
  EXPECT_FALSE(replace_file(folder_ / "b", folder_ / "a"));
  EXPECT_EQ(content_of(folder_ / "second"), "old");
}

}  // namespace
}  // namespace planish
