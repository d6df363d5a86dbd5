#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "fault/child.h"
#include "fault/markup.h"
#include "support/products.h"

// Names in meshes and of files are anybody's. They may neither become markup or commands in what is
// written, nor lead out of the folder that is written into.

namespace planish::cli {
namespace {

namespace fs = std::filesystem;
using fault::Files;
using fault::Markup;
using fault::markup_of;

/// As they could stand in one line of a mesh.
const std::vector<std::string> k_bad_names = {
    "<script>alert(1)<script>",
    "<script>alert(1)</script>",
    "\"onload=\"alert(1)",
    "'><svg/onload=alert(1)>",
    "--><!--",
    "]]>&lt;&#60;&",
    "../../escape",
    "../escape.svg",
    "/escape",
    "..",
    ".",
    "C:\\escape",
    "\\\\server\\share",
    "CON",
    "nul.txt",
    "garment.json",
    "GARMENT.SVG",
    "layout.svg",
    "layout-1.pdf",
    "-rf",
    "--help",
    ".hidden",
    "~",
    "$(id)`id`${HOME}",
    "a|b>c<d*e?f",
    "%s%n%d%%d",
    ") Tj ET (",
    "(((\\)",
    "x;PU0,0;SP9;\x03",
    "\x1b]0;title\x07\x1b[31m",
    "\x7f\x08\x08",
    "\xc2\x9b"
    "31m",
    "\xff\xfe\xc0\xaf",
    "\xe2\x80\xae"
    "gvs.exe",
    "a",
    "A",
    "\xc3\xa9",
    std::string(3000, 'x'),
    std::string(200, '.'),
};

/// Two triangles for each name, far from each other, each an object.
void write_named_patches(const std::string& path, const std::vector<std::string>& names) {
  std::ofstream file(path, std::ios::binary);
  for (std::size_t k = 0; k < names.size(); ++k) {
    file << "o " << names[k] << "\n";
    for (const char* corner : {" 0 0", " 50 0", " 50 40", " 0 40"})
      file << "v " << 100 * k + (corner[1] == '5' ? 1 : 0) << corner << "\n";
    file << "f -4 -3 -2\nf -4 -2 -1\n";
  }
}

std::set<std::string> values_of_dxf(const std::string& dxf, const std::string& code) {
  std::istringstream lines(dxf);
  std::set<std::string> found;
  for (std::string key, value; std::getline(lines, key) && std::getline(lines, value);) {
    EXPECT_EQ(key.find_first_not_of(" 0123456789"), std::string::npos) << "group code " << key;
    if (key == code) found.insert(value);
  }
  return found;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

/// Compares what is written for a bad name with what is written for a good one.
void expect_no_more_than(const fs::path& bad, const fs::path& good, const std::string& name) {
  for (const char* file : {"report.html", "pattern.svg"}) {
    const bool is_xml = std::string(file) != "report.html";
    const Markup got = markup_of(content_of(bad / file), is_xml);
    EXPECT_EQ(got.fault, "") << file << " of " << name;
    EXPECT_THAT(markup_of(content_of(good / file), is_xml).tags, testing::IsSupersetOf(got.tags))
        << file << " of " << name;
  }
  const std::string dxf = content_of(bad / "pattern.dxf");
  EXPECT_TRUE(dxf.ends_with("0\nEOF\n")) << name;
  for (const char* code : {"0", "8"}) {
    EXPECT_THAT(values_of_dxf(content_of(good / "pattern.dxf"), code),
                testing::IsSupersetOf(values_of_dxf(dxf, code)))
        << name;
  }
  const std::string pdf = content_of(bad / "pattern.pdf");
  EXPECT_EQ(count_of(pdf, "\nendobj"), count_of(content_of(good / "pattern.pdf"), "\nendobj"));
  for (const char* action : {"/JavaScript", "/OpenAction", "/URI", "/Launch"})
    EXPECT_EQ(pdf.find(action), std::string::npos) << name;
  const std::string plt = content_of(bad / "pattern.plt");
  EXPECT_EQ(plt.find_first_not_of("INSPUD0123456789,;-\n"), std::string::npos) << name;
  EXPECT_TRUE(nlohmann::json::accept(content_of(bad / "report.json"))) << name;
}

class NamesTest : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    fs::create_directories("inner/folder");
    fs::current_path("inner/folder");
    write_mesh("panel.obj", make_shape("panel", 100));
  }

  /// All but what is below the output folder.
  static Files outside(const std::string& folder) {
    Files found = fault::contents("../..");
    const std::string root = "inner/folder/" + folder + "/";
    std::erase_if(found, [&](const auto& file) { return file.first.starts_with(root); });
    return found;
  }
};

const Names k_fast = {"--method", "fairing", "--formats", "svg,dxf,pdf,plt"};

Names flatten_into(const std::string& folder, const std::string& input) {
  Names args = {"flatten", "-o", folder};
  args.insert(args.end(), k_fast.begin(), k_fast.end());
  args.insert(args.end(), {"--", input});
  return args;
}

TEST_F(NamesTest, OfPatchesNeitherLeadOutOfTheFolderNorBecomeMarkupOrCommands) {
  write_named_patches("bad.obj", k_bad_names);
  write_named_patches("good.obj", {"plain", "simple"});
  ASSERT_EQ(planish(flatten_into("good", "good.obj")).exit_code, k_exit_done);
  fs::create_directory("bad");
  const Files before = outside("bad");
  const CliResult result = planish(flatten_into("bad", "bad.obj"));
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_EQ(outside("bad"), before);
  const auto product = nlohmann::json::parse(content_of("bad/garment.json"));
  std::set<std::string> folders;
  for (const auto& patch : product["patches"]) {
    const std::string folder = patch["folder"];
    folders.insert(folder);
    EXPECT_TRUE(fs::is_directory("bad/" + folder)) << folder;
    EXPECT_EQ(fs::path(folder).filename(), folder);
    expect_no_more_than("bad/" + folder, "good/plain", folder);
  }
  EXPECT_EQ(folders.size(), k_bad_names.size());
  const Markup got = markup_of(content_of("bad/garment.svg"), true);
  EXPECT_EQ(got.fault, "");
  EXPECT_THAT(markup_of(content_of("good/garment.svg"), true).tags,
              testing::IsSupersetOf(got.tags));
  // Nothing that a terminal obeys.
  for (const std::string& text : {result.out, result.err}) {
    EXPECT_EQ(text.find_first_of("\x1b\x07\x08\x7f"), std::string::npos);
    EXPECT_EQ(text.find("\xc2\x9b"), std::string::npos);
  }
}

TEST_F(NamesTest, OfFilesBecomeNoMarkupAndNoCommands) {
  fs::create_directory("good");
  fs::copy_file("panel.obj", "plain.obj");
  ASSERT_EQ(planish(flatten_into("good", "plain.obj")).exit_code, k_exit_done);
  for (const std::string& name :
       {k_bad_names[0], k_bad_names[1], std::string("&amp;'"), std::string("\x1b[31m)\\("),
        std::string("\xff\xfe"), std::string("-"), std::string("%s%n"),
        std::string("x\n0\nENDSEC\n0\nEOF"), std::string("tab\tcr\r")}) {
    if (name.find('/') != std::string::npos) continue;
    const std::string file = name + ".obj";
    fs::copy_file("panel.obj", file);
    const CliResult result = planish(flatten_into("bad", file));
    ASSERT_EQ(result.exit_code, k_exit_done) << name << result.err;
    expect_no_more_than("bad", "good", name);
    fs::remove_all("bad");
    fs::remove(file);
  }
}

TEST_F(NamesTest, OfPiecesBecomeNoMarkupAndNoCommands) {
  ASSERT_EQ(planish({"flatten", "panel.obj", "-o", "good", "--method", "fairing", "--formats",
                     "svg,dxf,pdf,plt", "--piece-name", "a", "--size", "b", "--fabric", "c",
                     "--note", "d", "--date", "e"})
                .exit_code,
            k_exit_done);
  std::vector<std::string> names = k_bad_names;
  names.insert(names.begin(), {"two\nlines", "x\n0\nENDSEC\n0\nEOF"});
  for (std::size_t k = 0; k + 4 < names.size(); k += 5) {
    const CliResult result =
        planish({"flatten", "panel.obj", "-o", "bad", "--method", "fairing", "--formats",
                 "svg,dxf,pdf,plt", "--piece-name=" + names[k], "--size=" + names[k + 1],
                 "--fabric=" + names[k + 2], "--note=" + names[k + 3], "--date=" + names[k + 4]});
    ASSERT_EQ(result.exit_code, k_exit_done) << names[k] << result.err;
    expect_no_more_than("bad", "good", names[k]);
  }
}

TEST_F(NamesTest, OfLayersStayNames) {
  for (const std::string& name : k_bad_names) {
    if (name.find_first_of(",=") != std::string::npos) continue;
    const CliResult result =
        planish({"unfold", "panel.obj", "-o", "o.dxf", "--dxf-layers", "cut=" + name});
    ASSERT_EQ(result.exit_code, k_exit_done) << name << result.err;
    for (const std::string& layer : values_of_dxf(content_of("o.dxf"), "8"))
      EXPECT_EQ(layer.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                        "0123456789$-_"),
                std::string::npos)
          << layer;
  }
}

TEST_F(NamesTest, ThatAreLinksInTheOutputFolderAreReplaced) {
  std::ofstream("../treasure") << "treasure";
  fs::create_directory("out");
  for (const char* name : {"report.html", "pattern.svg", "processed.obj"})
    fs::create_symlink("../../treasure", fs::path("out") / name);
  const Files before = outside("out");
  const CliResult result = planish(flatten_into("out", "panel.obj"));
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_EQ(outside("out"), before);
  EXPECT_FALSE(fs::is_symlink("out/report.html"));
  EXPECT_TRUE(fs::is_regular_file("out/report.html"));
}

TEST_F(NamesTest, ThatAreLinksToFoldersAreRefused) {
  write_product("product.obj", in_strips(make_shape("panel", 100), 2));
  fs::create_directories("../elsewhere");
  fs::create_directory("out");
  fs::create_symlink("../../elsewhere", "out/strip-1");
  const Files before = outside("out");
  const CliResult result = planish(flatten_into("out", "product.obj"));
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_NE(result.err.find("symbolic link"), std::string::npos) << result.err;
  EXPECT_EQ(outside("out"), before);
  EXPECT_TRUE(fs::exists("out/strip-2/report.html"));
}

TEST_F(NamesTest, ThatTheCallerGaveMayBeLinks) {
  fs::create_directory("../elsewhere");
  fs::create_symlink("../elsewhere", "out");
  EXPECT_EQ(planish(flatten_into("out", "panel.obj")).exit_code, k_exit_done);
  EXPECT_TRUE(fs::exists("../elsewhere/report.html"));
  std::ofstream("../real.svg") << "old";
  fs::create_symlink("../real.svg", "link.svg");
  EXPECT_EQ(planish({"unfold", "panel.obj", "-o", "link.svg"}).exit_code, k_exit_done);
  EXPECT_TRUE(fs::is_symlink("link.svg"));
  EXPECT_NE(content_of("../real.svg"), "old");
}

TEST_F(NamesTest, InAJobThatIsResumedAreNotFollowed) {
  write_product("product.obj", in_strips(make_shape("panel", 100), 2));
  const Names args = {"flatten", "product.obj", "-o", "out", "--resume"};
  ASSERT_EQ(planish(args).exit_code, k_exit_done);
  const std::string job = content_of("out/strip-1/job.json");
  std::vector<std::string> forged;
  for (const char* name : {"../../panel.obj", "/dev/zero", "/etc/passwd"}) {
    auto json = nlohmann::ordered_json::parse(job);
    json["files"][name] = "0000000000000000";
    forged.push_back(json.dump(2));
  }
  forged.push_back(std::string(1'000'000, '['));
  forged.push_back("{\"files\":" + std::string(500'000, '[') + std::string(500'000, ']') + "}");
  forged.push_back(job.substr(0, job.size() / 2));
  forged.push_back("{\"files\": 3}");
  forged.push_back("");
  for (const std::string& text : forged) {
    std::ofstream("out/strip-1/job.json") << text;
    const CliResult result = planish(args);
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    EXPECT_EQ(nlohmann::json::parse(content_of("out/strip-1/job.json")).size(),
              nlohmann::json::parse(job).size());
  }
}

}  // namespace
}  // namespace planish::cli
