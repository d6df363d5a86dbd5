#include "platform/path.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "platform/file.h"
#include "support/own_folder.h"

namespace planish {
namespace {

// "ö" in one letter and in two, letters of three and four bytes, and of two writing directions.
const std::vector<std::string> k_names = {
    "Schlo\xC3\x9F \xC3\xB6",   "Schlo\xC3\x9F o\xCC\x88",
    "\xE6\x97\xA5\xE6\x9C\xAC", "\xD0\x96",
    "\xF0\x9F\xA7\xB5",         "\xD7\xA9\xD7\x9C\xD7\x95\xD7\x9D",
    "plain name.obj",           ""};

TEST(PathOf, ComesBackAsTheSameText) {
  for (const std::string& name : k_names) {
    EXPECT_EQ(utf8_of(path_of(name)), name);
    EXPECT_EQ(utf8_of(path_of("folder/" + name)), "folder/" + name);
  }
}

TEST(PathOf, IsThePathOfItsCodePoints) {
  EXPECT_EQ(path_of("\xC3\xB6"), std::filesystem::path(U"\u00F6"));
  EXPECT_EQ(utf8_of(std::filesystem::path(U"\u65E5\u672C")), "\xE6\x97\xA5\xE6\x9C\xAC");
}

TEST(PathOf, IsTakenApartAtSlashesAndDots) {
  const std::filesystem::path path = path_of("\xC3\xB6/\xE6\x97\xA5.\xD0\x96");
  EXPECT_EQ(utf8_of(path.parent_path()), "\xC3\xB6");
  EXPECT_EQ(utf8_of(path.stem()), "\xE6\x97\xA5");
  EXPECT_EQ(utf8_of(path.extension()), ".\xD0\x96");
}

class PathOfFile : public OwnFolder {};

TEST_F(PathOfFile, IsTheNameThatTheSystemLists) {
  for (const std::string& name : k_names) {
    if (name.empty()) continue;
    ASSERT_FALSE(write_new_file(folder_ / path_of(name), name)) << name;
    std::vector<std::string> listed;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      listed.push_back(utf8_of(entry.path().filename()));
    EXPECT_EQ(listed, std::vector<std::string>{name});
    EXPECT_EQ(FileContent(folder_ / path_of(name)).bytes(), name);
    std::filesystem::remove(folder_ / path_of(name));
  }
}

TEST_F(PathOfFile, HasItsEntriesWhateverTheyAre) {
  std::filesystem::create_directory(folder_ / "inner");
  for (const char* name : {"a.obj", ".hidden"})
    put_file(folder_ / name, "content");
  std::error_code failure;
  std::vector<std::filesystem::path> entries = entries_of(folder_, failure);
  std::sort(entries.begin(), entries.end());
  EXPECT_EQ(entries, (std::vector<std::filesystem::path>{folder_ / ".hidden", folder_ / "a.obj",
                                                         folder_ / "inner"}));
  EXPECT_FALSE(failure);
  EXPECT_TRUE(entries_of(folder_ / "missing", failure).empty());
  EXPECT_EQ(failure, std::errc::no_such_file_or_directory);
}

}  // namespace
}  // namespace planish
