// --scale: as if the file had other coordinates.

#include <functional>

#include <gmock/gmock.h>

#include "cli_run.h"
#include "support/meshes.h"
#include "support/products.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;

TriMesh halved(TriMesh mesh) {
  for (Vec3& p : mesh.positions)
    p = 0.5 * p;
  return mesh;
}

class Scale : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    std::filesystem::create_directory("half");
    write_mesh("half/panel.obj", halved(make_shape("panel", 300)));
  }

  /// The JSON of a verb on the whole panel at half its size, and on the half one.
  static std::pair<nlohmann::json, nlohmann::json> both(const std::string& verb,
                                                        const Names& more) {
    Names one = {verb, "panel.obj", "--scale", "0.5", "--json"},
          other = {verb, "half/panel.obj", "--json"};
    for (Names* args : {&one, &other})
      args->insert(args->end(), more.begin(), more.end());
    const CliResult first = planish(one), second = planish(other);
    EXPECT_EQ(first.exit_code, k_exit_done) << first.err;
    EXPECT_EQ(second.exit_code, k_exit_done) << second.err;
    return {first.json(), second.json()};
  }
};

TEST_F(Scale, IsThatOfTheCoordinatesInEveryVerb) {
  const auto [measured, of_half] = both("measure", {});
  EXPECT_EQ(measured, of_half);
  const auto [cuts, cuts_of_half] = both("suggest-cuts", {"--max-strain", "50%"});
  EXPECT_EQ(cuts, cuts_of_half);
  const auto [compared, compared_of_half] = both("compare", {"--methods", "fairing"});
  EXPECT_EQ(compared["input"], compared_of_half["input"]);
  EXPECT_EQ(compared["unfold_before"], compared_of_half["unfold_before"]);
  const auto [frontier, frontier_of_half] = both("frontier", {"--methods", "fairing"});
  EXPECT_EQ(frontier["curve"][0]["deviation"], frontier_of_half["curve"][0]["deviation"]);
}

TEST_F(Scale, IsThatOfWhatIsWritten) {
  const auto same = [](const Names& args, const std::string& output) {
    Names one = args, other = args;
    one.insert(one.end(), {"--scale", "0.5"});
    std::replace(other.begin(), other.end(), std::string("panel.obj"),
                 std::string("half/panel.obj"));
    EXPECT_EQ(planish(one).exit_code, k_exit_done);
    std::string first = content_of(output);
    const std::string note = ", model multiplied by 0.5";
    const std::size_t at = first.find(note);
    EXPECT_EQ(at != std::string::npos, output.ends_with(".svg"));
    if (at != std::string::npos) first.erase(at, note.size());
    EXPECT_EQ(planish(other).exit_code, k_exit_done);
    EXPECT_EQ(first, content_of(output));
    EXPECT_FALSE(first.empty());
  };
  same({"evolve", "panel.obj", "-o", "out.obj", "--sweeps", "3"}, "out.obj");
  same({"unfold", "panel.obj", "-o", "out.svg", "--unit", "cm", "--allowance", "5mm"}, "out.svg");
  same({"flatten", "panel.obj", "-o", "out", "--formats", "svg"}, "out/processed.obj");
  same({"flatten", "panel.obj", "-o", "out", "--formats", "svg"}, "out/flat.obj");
}

TEST_F(Scale, IsAlsoThatOfEveryPatchOfAProduct) {
  write_product("coat.obj",
                {{"front", make_shape("dome", 100), {}}, {"back", make_shape("saddle", 100), {}}});
  Names args = {"flatten", "coat.obj", "-o",           "out",      "--formats",
                "svg",     "--method", "controllable", "--sweeps", "1"};
  planish(args);
  const auto whole = nlohmann::json::parse(content_of("out/garment.json"));
  args.insert(args.end(), {"--scale", "0.5"});
  args[3] = "half-out";
  planish(args);
  const auto half = nlohmann::json::parse(content_of("half-out/garment.json"));
  ASSERT_EQ(half["patches"].size(), 2U);
  for (std::size_t p = 0; p < 2; ++p) {
    EXPECT_DOUBLE_EQ(half["patches"][p]["unfold"]["width"].get<double>(),
                     0.5 * whole["patches"][p]["unfold"]["width"].get<double>());
  }
}

TEST_F(Scale, LeavesDrawingsInTheCoordinatesOfTheFile) {
  write_mesh("tube.obj", meshes::tube(12, 5));
  std::ofstream("seam.obj") << "v 1.1 0 0\nv 1 0 5.2\nl 1 2\n";
  std::ofstream("mark.obj") << "v -1 0 2.1\np 1\n";
  const CliResult result = planish({"unfold", "tube.obj", "-o", "a.svg", "--cut", "seam.obj",
                                    "--marks", "mark.obj", "--json", "--scale", "100"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err, HasSubstr("seam.obj: cut open along 6 edges, 500.0 mm"));
  EXPECT_THAT(result.err, HasSubstr("at most 20.0 mm from the surface"));
  EXPECT_EQ(result.json()["cut"]["length"], 500.0);
}

}  // namespace
}  // namespace planish::cli
