#include "shell/file_name.h"

#include <gmock/gmock.h>

#include "cli_run.h"
#include "platform/path.h"

namespace planish::cli {
namespace {

using testing::Contains;
using testing::HasSubstr;

TEST(FileName, HasAStemAndAnExtension) {
  EXPECT_EQ(stem_of("folder/part.v2.OBJ"), "part.v2");
  EXPECT_EQ(extension_of("folder/part.v2.OBJ"), ".OBJ");
  EXPECT_EQ(lower_extension("folder/part.v2.OBJ"), ".obj");
  EXPECT_EQ(stem_of("folder.d/part"), "part");
  EXPECT_EQ(extension_of("folder.d/part"), "");
  EXPECT_EQ(stem_of(""), "");
}

TEST(FileName, MayHaveLettersBeyondAscii) {
  EXPECT_EQ(stem_of("\xC3\xB6/\xE6\x97\xA5\xE6\x9C\xAC.obj"), "\xE6\x97\xA5\xE6\x9C\xAC");
  EXPECT_EQ(lower_extension("a.\xC3\x96\xD0\x96"), ".\xC3\x96\xD0\x96");
}

class FileNames : public CliTest {
 protected:
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator("."))
      names.push_back(utf8_of(entry.path().lexically_relative(".")));
    return names;
  }
};

TEST_F(FileNames, BeyondAsciiAreThoseOfTheFilesWritten) {
  const std::string name = "Schlo\xC3\x9F \xE6\x97\xA5\xE6\x9C\xAC \xD0\x96";
  ASSERT_EQ(planish({"convert", "panel.obj", name + ".ply"}).exit_code, k_exit_done);
  EXPECT_THAT(names(), Contains(name + ".ply"));
  const CliResult result =
      planish({"flatten", name + ".ply", "--method", "fairing", "--history", name + ".csv"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.out, HasSubstr(name + "-pattern/report.html"));
  EXPECT_THAT(names(), Contains(name + "-pattern/report.html"));
  EXPECT_THAT(names(), Contains(name + ".csv"));
  const CliResult missing = planish({"measure", name + ".obj"});
  EXPECT_THAT(missing.err, HasSubstr(name + ".obj: cannot be read: "));
}

TEST_F(FileNames, OfASlashAndALetterAreNoFlags) {
  for (const std::string path : {"/p", "/p:a.obj", "/panel.obj"}) {
    const CliResult result = planish({"convert", path, "out.ply"});
    EXPECT_THAT(result.err, testing::StartsWith("error: " + path)) << path;
    EXPECT_EQ(result.exit_code, k_exit_failed) << path;
  }
}

}  // namespace
}  // namespace planish::cli
