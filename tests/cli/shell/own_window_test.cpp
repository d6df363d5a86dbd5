#include "shell/own_window.h"

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "platform/path.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;

std::vector<std::string> opened;

std::string open_well(const std::filesystem::path& page) {
  opened.push_back(utf8_of(page));
  return {};
}

std::string open_badly(const std::filesystem::path&) {
  return "no browser";
}

class OwnWindowTest : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    opened.clear();
  }

  /// @return exit code; what was said is in err
  int run(const std::vector<std::string>& words, std::string (*open)(const std::filesystem::path&),
          const std::string& typed = "\n") {
    std::istringstream in(typed);
    std::ostringstream out, all;
    const int exit_code = run_in_own_window(words, {in, out, all, open}, {});
    waited = in.peek() == std::istream::traits_type::eof();
    err = all.str();
    return exit_code;
  }
  std::string in_folder(const std::string& name) const { return utf8_of(folder_ / path_of(name)); }

  bool waited = false;
  std::string err;
};

TEST_F(OwnWindowTest, WithoutWordsSaysWhatToDoAndWaits) {
  EXPECT_EQ(run({}, open_well), k_exit_usage);
  EXPECT_TRUE(waited);
  EXPECT_THAT(err, HasSubstr("Drop a mesh"));
}

TEST_F(OwnWindowTest, FlattensADroppedFileBesideItselfAndOpensThePage) {
  std::filesystem::create_directory(folder_ / path_of("\xE6\x97\xA5"));
  const std::string mesh = in_folder("\xE6\x97\xA5/\xC3\xB6 b.obj");
  std::filesystem::rename("panel.obj", path_of(mesh));
  EXPECT_EQ(run({mesh}, open_well), k_exit_done) << err;
  const std::string folder = in_folder("\xE6\x97\xA5/\xC3\xB6 b-pattern");
  EXPECT_TRUE(std::filesystem::exists(path_of(folder + "/pattern.svg")));
  EXPECT_EQ(opened, std::vector<std::string>{folder + "/report.html"});
  EXPECT_FALSE(waited);
}

TEST_F(OwnWindowTest, FlattensSeveralDroppedFilesAsOneProduct) {
  std::filesystem::copy_file("panel.obj", "second.obj");
  EXPECT_EQ(run({in_folder("panel.obj"), in_folder("second.obj")}, open_well), k_exit_done) << err;
  EXPECT_EQ(opened, std::vector<std::string>{in_folder("panel-and-more-pattern/garment.html")});
}

/// The panel as if it had been made in another unit than millimetres.
class DroppedUnitTest : public OwnWindowTest {
 protected:
  std::string unit_of_run(double scale, const std::string& typed) {
    TriMesh mesh = make_shape("panel", 300);
    for (Vec3& position : mesh.positions)
      position = scale * position;
    write_mesh("small.obj", mesh);
    EXPECT_EQ(run({in_folder("small.obj")}, open_well, typed), k_exit_done) << err;
    std::ifstream file("small-pattern/report.json");
    return nlohmann::json::parse(file).at("unfold").at("unit").get<std::string>();
  }
};

TEST_F(DroppedUnitTest, IsAskedForWhereTheSizeIsUnusual) {
  EXPECT_EQ(unit_of_run(0.001, "cm\n"), "cm");
  EXPECT_THAT(err, HasSubstr("Type mm, cm, dm, m or in"));
  EXPECT_THAT(err, HasSubstr("m (713 mm)"));
  EXPECT_EQ(unit_of_run(0.001, "\nyards\n Inches \n"), "in");
  EXPECT_THAT(err, HasSubstr("yards is not one of them"));
  EXPECT_EQ(unit_of_run(0.001, ""), "mm") << "at the end of what is typed";
}

TEST_F(DroppedUnitTest, IsAskedForWhereOneOfSeveralIsUnusual) {
  TriMesh mesh = make_shape("panel", 300);
  for (Vec3& position : mesh.positions)
    position = 0.01 * position;
  write_mesh("small.obj", mesh);
  run({in_folder("panel.obj"), in_folder("small.obj")}, open_well, "mm\n");
  EXPECT_THAT(err, HasSubstr("In which unit is the mesh?"));
}

TEST_F(DroppedUnitTest, IsMillimetresWithoutAQuestionWhereThatIsUsual) {
  EXPECT_EQ(unit_of_run(2.0, ""), "mm");
  EXPECT_THAT(err, testing::Not(HasSubstr("In which unit")));
}

TEST_F(OwnWindowTest, SaysWhereThePageIsIfItCannotBeOpened) {
  EXPECT_EQ(run({in_folder("panel.obj")}, open_badly), k_exit_done);
  EXPECT_TRUE(waited);
  EXPECT_THAT(err,
              HasSubstr(in_folder("panel-pattern/report.html") + " in a browser (no browser)"));
}

TEST_F(OwnWindowTest, WaitsAfterAFailure) {
  std::ofstream("bad.obj") << "v 0 0 nan\n";
  EXPECT_EQ(run({in_folder("bad.obj")}, open_well), k_exit_failed);
  EXPECT_TRUE(waited);
  EXPECT_TRUE(opened.empty());
  EXPECT_THAT(err, HasSubstr("error: "));
}

TEST_F(OwnWindowTest, DoesAllElseWithoutWaiting) {
  EXPECT_EQ(run({"measure", "panel.obj"}, open_well), k_exit_done);
  EXPECT_FALSE(waited);
  EXPECT_EQ(run({"none.obj"}, open_well), k_exit_usage);
  EXPECT_FALSE(waited);
}

TEST_F(OwnWindowTest, TellsDroppedFilesByTheirBeingThere) {
  EXPECT_TRUE(are_dropped(Names{in_folder("panel.obj")}));
  EXPECT_FALSE(are_dropped(Names{in_folder("panel.obj"), "--json"}));
  EXPECT_FALSE(are_dropped(Names{"flatten", in_folder("panel.obj")}));
  EXPECT_FALSE(are_dropped(Names{"panel.obj"}));
  EXPECT_FALSE(are_dropped(Names{}));
}

}  // namespace
}  // namespace planish::cli
