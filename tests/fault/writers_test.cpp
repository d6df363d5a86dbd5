#include <csignal>
#include <tuple>

#include <sys/stat.h>
#include <unistd.h>

#include "cli/cli_run.h"
#include "fault/child.h"
#include "support/products.h"

// The program in a process of its own, with outputs that cannot take what is written.

namespace planish::cli {
namespace {

namespace fs = std::filesystem;
using fault::Files;
using fault::run_program;
using fault::told;

/// Every way to write a file, and what is written.
struct Writer {
  Names args;
  Names outputs;
};

std::vector<Writer> writers() {
  const Names fast = {"--method", "fairing"};
  const auto with = [&](Names args) {
    args.insert(args.end(), fast.begin(), fast.end());
    return args;
  };
  std::vector<Writer> all;
  for (const std::string mesh : {"o.obj", "o.ply", "o.stl", "o.off"})
    all.push_back({{"convert", "panel.obj", mesh}, {mesh}});
  for (const std::string pattern : {"o.svg", "o.dxf", "o.pdf", "o.plt", "o.obj"})
    all.push_back({{"unfold", "panel.obj", "-o", pattern}, {pattern}});
  all.push_back({{"unfold", "panel.obj", "-o", "o.pdf", "--paper", "a4"}, {"o.pdf"}});
  all.push_back(
      {with({"evolve", "panel.obj", "-o", "o.obj", "--history", "h.csv"}), {"o.obj", "h.csv"}});
  all.push_back(
      {{"measure", "panel.obj", "--map", "m.csv", "--picture", "m.svg"}, {"m.csv", "m.svg"}});
  all.push_back({{"sample", "dome", "-o", "o.ply"}, {"o.ply"}});
  all.push_back({{"suggest-cuts", "panel.obj", "-o", "c.txt", "--picture", "c.svg", "--apply",
                  "c.obj", "--max-cuts", "0"},
                 {"c.txt", "c.svg", "c.obj"}});
  all.push_back({{"compare", "panel.obj", "-o", "out", "--methods", "fairing"},
                 {"out/compare.html", "out/compare.csv", "out/compare.json"}});
  for (const std::string chart : {"f.svg", "f.html", "f.csv"})
    all.push_back({{"frontier", "small.obj", "-o", chart, "--methods", "fairing"}, {chart}});
  all.push_back({with({"flatten", "panel.obj", "-o", "out", "--formats", "svg,dxf,pdf,plt",
                       "--paper", "a4", "--textured", "--history", "h.csv", "--sheet", "1m"}),
                 {"out/pattern.svg", "out/pattern.dxf", "out/pattern.pdf", "out/pattern.plt",
                  "out/pattern-a4.pdf", "out/processed.obj", "out/flat.obj", "out/textured.obj",
                  "out/report.json", "out/report.html", "h.csv", "out/layout.svg"}});
  return all;
}

class Writers : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    write_mesh("small.obj", make_shape("panel", 100));
  }
  static std::string line_of(const Names& args) {
    std::string line;
    for (const std::string& word : args)
      line += word + " ";
    return line;
  }
};

TEST_F(Writers, LeaveAllAsItWasOnAFullDisk) {
  for (const Writer& writer : writers()) {
    const auto whole = run_program(writer.args);
    ASSERT_EQ(whole.exit_code, k_exit_done) << line_of(writer.args) << told(whole);
    std::size_t longest = 0;
    for (const std::string& output : writer.outputs) {
      ASSERT_TRUE(fs::exists(output)) << line_of(writer.args) << output;
      longest = std::max<std::size_t>(longest, fs::file_size(output));
    }
    for (const std::string& output : writer.outputs)
      std::ofstream(output) << "as it was";
    const Files before = fault::contents(".");
    // What is printed goes to pipes, which no limit of size hits.
    for (const std::size_t room :
         {std::size_t{1}, longest / 7, longest / 2, longest - longest / 20 - 1}) {
      Names args = writer.args;
      args.push_back("--json");
      const auto ended = run_program(args, {.file_size = std::max<std::size_t>(room, 1)},
                                     {.out = "/dev/null", .err = "/dev/null"});
      EXPECT_EQ(ended.exit_code, k_exit_failed)
          << line_of(args) << "with room for " << room << ": " << told(ended);
      EXPECT_EQ(fault::contents("."), before) << line_of(args);
    }
    for (const std::string& output : writer.outputs)
      fs::remove(output);
    fs::remove_all("out");
  }
}

TEST_F(Writers, SayThatTheDiskIsFull) {
  // 4000 bytes are enough for what is printed, which goes into files here, and for no mesh.
  const auto ended = run_program({"convert", "panel.obj", "o.ply", "--json"}, {.file_size = 4000});
  EXPECT_EQ(ended.exit_code, k_exit_failed);
  EXPECT_EQ(nlohmann::json::parse(ended.out)["error"]["code"], "file_unwritable") << told(ended);
}

TEST_F(Writers, OfEveryPatchOfAProductLeaveItAsItWasOnAFullDisk) {
  write_product("product.obj", in_strips(make_shape("panel", 300), 2));
  const Names args = {"flatten", "product.obj", "-o", "out", "--sheet", "1500mm", "--json"};
  ASSERT_EQ(run_program(args).exit_code, k_exit_done);
  const Files whole = fault::contents("out");
  for (const auto& [name, content] : whole) {
    if (name.back() != '/') std::ofstream("out/" + name) << "as it was";
  }
  const Files before = fault::contents("out");
  for (const std::size_t room : {1, 2000, 20'000, 60'000}) {
    const auto ended =
        run_program(args, {.file_size = room}, {.out = "/dev/null", .err = "/dev/null"});
    EXPECT_EQ(ended.exit_code, k_exit_failed) << told(ended);
    // A patch is written as a whole or not; no patch of this product fits.
    for (const auto& [name, content] : fault::contents("out")) {
      ASSERT_TRUE(before.contains(name)) << name;
      if (name.find('/') != std::string::npos) {
        EXPECT_EQ(content, before.at(name)) << name << " with room for " << room;
      }
    }
  }
}

TEST_F(Writers, ToAFullDeviceFail) {
  const Files before = fault::contents(".");
  for (const Names& args :
       {Names{"evolve", "panel.obj", "-o", "o.obj", "--sweeps", "1", "--history", "/dev/full"},
        Names{"measure", "panel.obj", "--map", "/dev/full"},
        Names{"suggest-cuts", "panel.obj", "--max-cuts", "0", "-o", "/dev/full"},
        Names{"flatten", "panel.obj", "--method", "fairing", "-o", "out", "--history",
              "/dev/full"}}) {
    const auto ended = run_program(args);
    EXPECT_EQ(ended.exit_code, k_exit_failed) << line_of(args) << told(ended);
    EXPECT_NE(ended.err.find("No space left"), std::string::npos) << told(ended);
    EXPECT_EQ(fault::contents("."), before) << line_of(args);
  }
}

/// Verbs that print and write nothing.
std::vector<Names> printing() {
  return {{"measure", "panel.obj"},
          {"measure", "panel.obj", "--json"},
          {"compare", "panel.obj", "--methods", "fairing"},
          {"suggest-cuts", "panel.obj", "--max-cuts", "0"},
          {"frontier", "small.obj", "--methods", "fairing"},
          {"sample", "--list"},
          {"--help"},
          {"flatten", "--help"},
          {"--version"}};
}

TEST_F(Writers, OfStandardOutputFailWhereItIsFullClosedOrUnread) {
  for (const std::string out : {"/dev/full", "-", "|"}) {
    for (const Names& args : printing()) {
      const auto ended = run_program(args, {}, {.out = out});
      EXPECT_EQ(ended.exit_code, k_exit_failed) << line_of(args) << out << told(ended);
      EXPECT_TRUE(ended.err.ends_with("error: cannot write to standard output\n"))
          << line_of(args) << out << told(ended);
    }
  }
}

TEST_F(Writers, OfFilesFinishThemBeforeAnythingIsPrinted) {
  for (const Writer& writer : writers()) {
    const auto ended = run_program(writer.args, {}, {.out = "|"});
    EXPECT_EQ(ended.exit_code, k_exit_failed) << line_of(writer.args) << told(ended);
    for (const std::string& output : writer.outputs)
      EXPECT_TRUE(fs::exists(output)) << line_of(writer.args) << output;
  }
}

TEST_F(Writers, DoNotNeedStandardError) {
  write_product("product.obj", in_strips(make_shape("panel", 300), 2));
  for (const std::string err : {"-", "|", "/dev/full"}) {
    fs::remove_all("out");
    // A line for each patch goes to standard error while files are written.
    const auto ended = run_program({"flatten", "product.obj", "-o", "out"}, {}, {.err = err});
    EXPECT_EQ(ended.exit_code, k_exit_done) << err << told(ended);
    EXPECT_TRUE(fs::exists("out/garment.json")) << err;
    for (const auto& [name, content] : fault::contents("out"))
      EXPECT_EQ(content.find("  strain rms "), std::string::npos)
          << name << ": a message in a file";
  }
}

TEST_F(Writers, RefusePathsThatCannotBeWritten) {
  std::ofstream("file") << "a file";
  fs::create_directory("folder");
  fs::create_symlink("nowhere/at/all", "dangling");
  fs::create_symlink("loop", "loop");
  fs::create_directory("readonly");
  fs::permissions("readonly", fs::perms::owner_read | fs::perms::owner_exec);
  std::vector<std::string> places = {"file/o.obj",
                                     "file/deep/er/o.obj",
                                     "loop/o.obj",
                                     std::string(5000, 'x') + ".obj",
                                     std::string(300, 'x') + "/o.obj",
                                     "folder/../file/o.obj",
                                     "/proc/nothing/o.obj"};
  if (geteuid() != 0) places.push_back("readonly/o.obj");
  fs::create_directory("folder/o.obj");
  places.push_back("folder/o.obj");
  const Files before = fault::contents(".");
  for (const std::string& place : places) {
    for (const Names& args :
         {Names{"convert", "panel.obj", place}, Names{"unfold", "panel.obj", "-o", place},
          Names{"evolve", "panel.obj", "--sweeps", "1", "-o", "o.obj", "--history", place}}) {
      const CliResult result = planish(args);
      EXPECT_EQ(result.exit_code, k_exit_failed) << line_of(args) << result.err;
      EXPECT_NE(result.err.find("cannot be written"), std::string::npos) << result.err;
      EXPECT_EQ(fault::contents("."), before) << line_of(args);
    }
  }
  fs::permissions("readonly", fs::perms::owner_all);
}

TEST_F(Writers, RefuseFoldersThatCannotBeWritten) {
  std::ofstream("file") << "a file";
  fs::create_symlink("loop", "loop");
  const Files before = fault::contents(".");
  for (const std::string& place :
       {std::string("file"), std::string("file/out"), std::string("loop"), std::string(300, 'x')}) {
    for (const Names& args : {Names{"flatten", "panel.obj", "--method", "fairing", "-o", place},
                              Names{"compare", "panel.obj", "--methods", "fairing", "-o", place}}) {
      const CliResult result = planish(args);
      EXPECT_EQ(result.exit_code, k_exit_failed) << line_of(args) << result.err;
      EXPECT_EQ(fault::contents("."), before) << line_of(args);
    }
  }
}

TEST_F(Writers, RefuseInputsThatCannotBeRead) {
  fs::create_directory("folder.obj");
  fs::create_symlink("nowhere", "dangling.obj");
  fs::create_symlink("loop.obj", "loop.obj");
  fs::create_symlink("/proc/self/mem", "memory.obj");
  fs::create_symlink("/dev/zero", "endless.obj");
  std::ofstream("secret.obj") << "v 0 0 0\n";
  fs::permissions("secret.obj", fs::perms::none);
  std::vector<std::string> inputs = {"folder.obj",  "dangling.obj",    "loop.obj",
                                     "memory.obj",  "endless.obj",     "panel.obj/x.obj",
                                     "missing.obj", "/dev/tty0/x.obj", std::string(5000, 'x')};
  if (geteuid() != 0) inputs.push_back("secret.obj");
  const Files before = fault::contents(".");
  for (const std::string& input : inputs) {
    for (const Names& args :
         {Names{"measure", input}, Names{"convert", input, "o.ply"},
          Names{"evolve", "panel.obj", "-o", "o.obj", "--fix", input},
          Names{"evolve", "panel.obj", "-o", "o.obj", "--method", "least_norm", "--weights", input},
          Names{"evolve", "panel.obj", "-o", "o.obj", "--method", "local_perturbation",
                "--obstacle", input},
          Names{"unfold", "panel.obj", "-o", "o.svg", "--cut", input},
          Names{"unfold", "panel.obj", "-o", "o.svg", "--notches", input},
          Names{"unfold", "panel.obj", "-o", "o.svg", "--marks", input},
          Names{"unfold", "panel.obj", "-o", "o.svg", "--inner-lines", input},
          Names{"unfold", "panel.obj", "-o", "o.svg", "--seam-notches", input}}) {
      const CliResult result = planish(args);
      EXPECT_EQ(result.exit_code, k_exit_failed) << line_of(args).substr(0, 200) << result.err;
      EXPECT_EQ(fault::contents("."), before);
    }
  }
  fs::permissions("secret.obj", fs::perms::owner_all);
}

}  // namespace
}  // namespace planish::cli
