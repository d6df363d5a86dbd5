#include <gmock/gmock.h>

#include "cli_run.h"

namespace planish::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class Failures : public CliTest {
 protected:
  static void write_text(const std::string& path, const std::string& text) {
    std::ofstream(path) << text;
  }
};

/// Two domes side by side.
TriMesh two_patches() {
  TriMesh mesh = make_shape("dome", 100);
  const std::size_t vertices = mesh.positions.size(), triangles = mesh.triangles.size();
  for (std::size_t v = 0; v < vertices; ++v) {
    mesh.positions.push_back(mesh.positions[v] + Vec3{1000.0, 0.0, 0.0});
  }
  for (std::size_t t = 0; t < triangles; ++t) {
    Triangle copy = mesh.triangles[t];
    for (Index& v : copy)
      v += static_cast<Index>(vertices);
    mesh.triangles.push_back(copy);
  }
  return mesh;
}

const char* const k_three_triangles_on_an_edge =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n";

TEST_F(Failures, OfTheInputEndWithOneAndWriteNothing) {
  write_text("broken.obj", "v 0 0 0\nv 1 0 zero\n");
  for (const std::string input : {"missing.obj", "broken.obj", "panel.xyz"}) {
    for (const Names& args :
         {Names{"measure", input}, Names{"evolve", input, "-o", "out.obj"},
          Names{"unfold", input, "-o", "out.svg"}, Names{"flatten", input, "-o", "out"},
          Names{"compare", input, "-o", "out"}, Names{"frontier", input, "-o", "out.svg"},
          Names{"measure", input, "--map", "map.csv"}, Names{"convert", input, "out.ply"}}) {
      const CliResult result = planish(args);
      EXPECT_EQ(result.exit_code, k_exit_failed) << args.front() << " " << input;
      EXPECT_EQ(result.out, "");
      EXPECT_THAT(result.err, HasSubstr(input));
    }
  }
  EXPECT_THAT(names(), ElementsAre("broken.obj", "panel.obj"));
}

TEST_F(Failures, AreOneJsonObjectWithCodeAndPlace) {
  write_text("broken.obj", "v 0 0 0\nv 1 0 zero\nf 1 1 2\n");
  const CliResult result = planish({"measure", "broken.obj", "--json"});
  EXPECT_EQ(result.exit_code, k_exit_failed);
  const auto error = result.json()["error"];
  EXPECT_EQ(error["code"], "bad_number");
  EXPECT_EQ(error["path"], "broken.obj");
  EXPECT_EQ(error["line"], 2);
  EXPECT_THAT(result.err, HasSubstr("broken.obj:2: "));
}

TEST_F(Failures, OfAMeshNameItsFileAndListAllProblems) {
  write_text("edge.obj", k_three_triangles_on_an_edge);
  const CliResult result = planish({"measure", "edge.obj", "--strict"});
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_THAT(result.out, HasSubstr("non_manifold_edge"));
  EXPECT_THAT(result.err, HasSubstr("error: edge.obj: "));
  const auto error = planish({"measure", "edge.obj", "--strict", "--json"}).json()["error"];
  EXPECT_EQ(error["code"], "non_manifold_edge");
  EXPECT_EQ(error["path"], "edge.obj");
}

TEST_F(Failures, MeshesThatAreNoDisksAreMeasuredButNotUnfolded) {
  write_mesh("apart.obj", two_patches());
  const CliResult measured = planish({"measure", "apart.obj"});
  EXPECT_EQ(measured.exit_code, k_exit_done) << measured.err;
  EXPECT_THAT(measured.out, HasSubstr("several_components"));
  const CliResult unfolded = planish({"unfold", "apart.obj", "-o", "out.svg", "--json"});
  EXPECT_EQ(unfolded.exit_code, k_exit_failed);
  EXPECT_EQ(unfolded.json()["error"]["code"], "several_components");
  EXPECT_THAT(names(), ElementsAre("apart.obj", "panel.obj"));
}

TEST_F(Failures, OfTheOutputAreToldAndNothingIsLeft) {
  write_text("taken", "not a folder");
  const CliResult folder = planish({"flatten", "panel.obj", "-o", "taken", "--json"});
  EXPECT_EQ(folder.exit_code, k_exit_failed);
  EXPECT_EQ(folder.json()["error"]["code"], "file_unwritable");
  EXPECT_EQ(content_of("taken"), "not a folder");
  EXPECT_EQ(planish({"evolve", "panel.obj", "-o", "taken/out.obj"}).exit_code, k_exit_failed);
  EXPECT_EQ(planish({"evolve", "panel.obj", "-o", "out.xyz"}).exit_code, k_exit_failed);
  EXPECT_EQ(planish({"evolve", "panel.obj", "-o", "out.obj", "--history", "taken/h.csv"}).exit_code,
            k_exit_failed);
  EXPECT_THAT(names(), ElementsAre("panel.obj", "taken"));
}

TEST_F(Failures, ATargetThatIsMissedEndsWithThreeAndIsWritten) {
  const Names args = {"evolve", "panel.obj",      "-o",   "out.obj", "--sweeps",
                      "1",      "--target-e-max", "1e-9", "--json",  "--require-target"};
  const CliResult missed = planish(args);
  EXPECT_EQ(missed.exit_code, k_exit_target_missed);
  EXPECT_EQ(missed.json()["stop"], "sweep_limit");
  EXPECT_THAT(missed.err, HasSubstr("error: target not met"));
  EXPECT_TRUE(std::filesystem::exists("out.obj"));
  EXPECT_EQ(planish({"flatten", "panel.obj", "--sweeps", "1", "--require-target"}).exit_code,
            k_exit_target_missed);
  EXPECT_TRUE(std::filesystem::exists("panel-pattern/report.html"));
}

TEST_F(Failures, ATargetThatIsMetEndsWithNought) {
  const CliResult met =
      planish({"evolve", "panel.obj", "-o", "out.obj", "--target-e-max", "10", "--require-target"});
  EXPECT_EQ(met.exit_code, k_exit_done) << met.err;
  EXPECT_EQ(content_of("out.obj"), content_of("panel.obj"));
}

TEST_F(Failures, AnInterruptEndsWith130AndWritesNothing) {
  const std::atomic<bool> interrupted = true;
  const RunContext context = {.interrupted = &interrupted};
  for (const Names& args :
       {Names{"measure", "panel.obj"}, Names{"evolve", "panel.obj", "-o", "out.obj"},
        Names{"unfold", "panel.obj", "-o", "out.svg"}, Names{"flatten", "panel.obj"},
        Names{"compare", "panel.obj", "-o", "out"}, Names{"frontier", "panel.obj", "-o", "out.svg"},
        Names{"measure", "panel.obj", "--map", "m.csv", "--picture", "m.svg"},
        Names{"convert", "panel.obj", "out.ply"}, Names{"sample", "dome", "-o", "out.obj"}}) {
    const CliResult result = planish(args, context);
    EXPECT_EQ(result.exit_code, k_exit_interrupted) << args.front();
    EXPECT_EQ(result.out, "");
    Names with_json = args;
    with_json.push_back("--json");
    EXPECT_EQ(planish(with_json, context).json()["error"]["code"], "interrupted");
  }
  EXPECT_THAT(names(), ElementsAre("panel.obj"));
}

/// Sets the flag as soon as something is drawn: in the midst of the work.
class InterruptingBuffer : public std::stringbuf {
 public:
  explicit InterruptingBuffer(std::atomic<bool>& flag) : flag_(flag) {}

 protected:
  int sync() override {
    flag_ = true;
    return std::stringbuf::sync();
  }

 private:
  std::atomic<bool>& flag_;
};

TEST_F(Failures, AnInterruptInTheMidstOfWorkIsHeard) {
  for (const Names& args : {Names{"evolve", "panel.obj", "-o", "out.obj", "--sweeps", "100000"},
                            Names{"unfold", "panel.obj", "-o", "out.svg"},
                            Names{"flatten", "panel.obj", "--sweeps", "100000"},
                            Names{"compare", "panel.obj", "-o", "out", "--sweeps", "100000"},
                            Names{"frontier", "panel.obj", "-o", "out.svg"}}) {
    std::atomic<bool> interrupted = false;
    InterruptingBuffer buffer(interrupted);
    std::ostream err(&buffer);
    std::ostringstream out;
    const RunContext context = {.err_is_terminal = true, .interrupted = &interrupted};
    EXPECT_EQ(run(args, out, err, context), k_exit_interrupted) << args.front();
  }
  EXPECT_THAT(names(), ElementsAre("panel.obj"));
}

TEST_F(Failures, StandardOutputThatCannotBeWrittenIsAFailure) {
  std::ostringstream out, err;
  out.setstate(std::ios::badbit);
  EXPECT_EQ(run(Names{"measure", "panel.obj"}, out, err), k_exit_failed);
  EXPECT_THAT(err.str(), HasSubstr("cannot write to standard output"));
}

TEST_F(Failures, ProgressIsDrawnOnTerminalsOnlyAndCleared) {
  const Names args = {"evolve", "panel.obj", "-o", "out.obj"};
  const std::string plain = planish(args).err;
  EXPECT_THAT(plain, Not(HasSubstr("measuring")));
  const RunContext terminal = {.err_is_terminal = true};
  const std::string drawn = planish(args, terminal).err;
  EXPECT_THAT(drawn, HasSubstr("measuring [              ]   0 %  panel.obj"));
  const std::size_t end = drawn.rfind('\r');
  ASSERT_NE(end, std::string::npos);
  EXPECT_GT(drawn.find('\n'), end);
  EXPECT_EQ(drawn.substr(end - 2), "  \r" + plain) << "what is noted stands on a clear line";
  Names quiet = args;
  quiet.push_back("-q");
  EXPECT_EQ(planish(quiet, terminal).err, "");
}

}  // namespace
}  // namespace planish::cli
