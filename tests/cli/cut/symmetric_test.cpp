#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <planish/io/read_mesh.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/symmetry.h>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "support/meshes.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A hill, symmetric in x = 6 vertex by vertex, and one with a bump on the left.
class Symmetric : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    const auto hill = [](double x, double y) {
      return 4.0 - 0.1 * (x - 6.0) * (x - 6.0) - 0.1 * (y - 4.0) * (y - 4.0);
    };
    write_mesh("hill.obj", meshes::height_field(12, 8, hill));
    write_mesh("bumpy.obj", meshes::height_field(12, 8, [&](double x, double y) {
                 return hill(x, y) + (x < 4.0 && y > 3.0 && y < 6.0 ? 0.5 : 0.0);
               }));
    std::ofstream("dart.obj") << "v 9.3 -0.3 1.3\nv 8.4 4.2 3\nl 1 2\n";
    std::ofstream("across.obj") << "v 9.3 -0.3 1.3\nv 9.6 8.3 1\nl 1 2\n";
  }
};

TriMesh flat_of(const std::string& path) {
  return read_mesh(path).mesh;
}

/// Whether lengths of a pattern are those of its mirror image, of the same vertices.
double asymmetry(const TriMesh& surface, const TriMesh& flat, double x) {
  const Symmetry symmetry = symmetry_in(Patch(surface), {{1.0, 0.0, 0.0}, x});
  EXPECT_EQ(symmetry.image.size(), flat.positions.size());
  double largest = symmetry.image.empty() ? 1e9 : 0.0;
  for (std::size_t v = 0; v < symmetry.image.size(); ++v) {
    for (std::size_t w = 0; w < v; w += 5) {
      const double here = norm(flat.positions[v] - flat.positions[w]);
      const double there =
          norm(flat.positions[symmetry.image[v]] - flat.positions[symmetry.image[w]]);
      largest = std::max(largest, std::abs(here - there));
    }
  }
  return largest;
}

CliResult flatten_symmetric(const std::string& input, const Names& more) {
  Names args = {"flatten", input, "-o", "out", "--formats", "svg"};
  args.insert(args.end(), more.begin(), more.end());
  return planish(args);
}

TEST_F(Symmetric, MirrorsADart) {
  const auto one = flatten_symmetric("hill.obj", {"--json", "--cut", "dart.obj"}).json();
  const CliResult result =
      flatten_symmetric("hill.obj", {"--json", "--cut", "dart.obj", "--symmetric", "auto"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err, HasSubstr("hill.obj: symmetric in x=6: its sides are equal"));
  const auto both = result.json();
  EXPECT_NEAR(both["cut"]["length"], 2.0 * one["cut"]["length"].get<double>(), 0.05);
  EXPECT_LE(asymmetry(flat_of("out/processed.obj"), flat_of("out/flat.obj"), 6.0), 1e-9);
}

TEST_F(Symmetric, GivesTwinsTheMirroredPattern) {
  const CliResult result =
      flatten_symmetric("hill.obj", {"--json", "--cut", "across.obj", "--symmetric", "x=6"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err,
              HasSubstr("1 piece gets the mirrored pattern of another one; 1 piece is its"));
  const auto json = result.json();
  ASSERT_EQ(json["patches"].size(), 3U);
  int twins = 0, across = 0;
  for (const auto& patch : json["patches"]) {
    twins += patch.contains("twin") && patch["twin"]["mirrored"] ? 1 : 0;
    const std::string folder = "out/" + patch["name"].get<std::string>();
    const TriMesh surface = flat_of(folder + "/processed.obj");
    if (symmetry_in(Patch(surface), {{1.0, 0.0, 0.0}, 6.0}).image.empty()) continue;
    ++across;
    EXPECT_LE(asymmetry(surface, flat_of(folder + "/flat.obj"), 6.0), 1e-9);
  }
  EXPECT_EQ(twins, 1);
  EXPECT_EQ(across, 1);
}

TEST_F(Symmetric, EvolvesBothSidesAlike) {
  const CliResult result = flatten_symmetric(
      "hill.obj", {"--json", "--cut", "dart.obj", "--symmetric", "auto", "--max-rms-strain", "1%"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_LE(asymmetry(flat_of("out/processed.obj"), flat_of("out/flat.obj"), 6.0), 1e-9);
  const CliResult evolved = planish(
      {"evolve", "hill.obj", "-o", "a.obj", "--symmetric", "auto", "--sweeps", "5", "--json"});
  ASSERT_EQ(evolved.exit_code, k_exit_done) << evolved.err;
  const Symmetry symmetry = symmetry_in(Patch(read_mesh("a.obj").mesh), {{1.0, 0.0, 0.0}, 6.0});
  ASSERT_FALSE(symmetry.image.empty());
  const TriMesh mesh = read_mesh("a.obj").mesh;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_LE(norm(mirrored(symmetry.plane, mesh.positions[v]) - mesh.positions[symmetry.image[v]]),
              1e-12);
  }
}

TEST_F(Symmetric, SaysByHowMuchAModelIsNot) {
  for (const char* plane : {"auto", "x=6"}) {
    const CliResult result =
        planish({"unfold", "bumpy.obj", "-o", "a.svg", "--symmetric", plane, "--json"});
    EXPECT_EQ(result.exit_code, k_exit_failed);
    EXPECT_EQ(result.json()["error"]["code"], "not_symmetric");
    EXPECT_THAT(result.json()["error"]["message"].get<std::string>(),
                HasSubstr("of its diagonal from it"));
    EXPECT_FALSE(std::filesystem::exists("a.svg"));
  }
}

TEST_F(Symmetric, PutsOneHalfInThePlaceOfTheOther) {
  const CliResult result = flatten_symmetric(
      "bumpy.obj", {"--cut", "dart.obj", "--symmetric", "x=6", "--mirror-surface"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  const TriMesh surface = flat_of("out/processed.obj");
  EXPECT_LE(asymmetry(surface, flat_of("out/flat.obj"), 6.0), 1e-9);
  // The side with the dart has no bump.
  for (const Vec3 p : surface.positions)
    EXPECT_LE(p.z, 4.0 - 0.1 * (p.x - 6.0) * (p.x - 6.0) - 0.1 * (p.y - 4.0) * (p.y - 4.0) + 0.1);
}

TEST_F(Symmetric, RefusesWhatMakesNoSense) {
  const auto error_of = [](const Names& more) {
    Names args = {"unfold", "hill.obj", "-o", "a.svg"};
    args.insert(args.end(), more.begin(), more.end());
    const CliResult result = planish(args);
    EXPECT_EQ(result.exit_code, k_exit_usage) << result.err;
    return result.err;
  };
  EXPECT_THAT(error_of({"--mirror-surface"}), HasSubstr("add --symmetric auto"));
  EXPECT_THAT(error_of({"--symmetric", "q=1"}), HasSubstr("a plane is \"x=0\""));
  EXPECT_THAT(error_of({"--symmetric", "auto", "--cut", "dart.obj", "--cut", "open"}),
              HasSubstr("--cut open"));
  EXPECT_THAT(error_of({"--symmetric", "auto", "--cut", "dart.obj", "--cut-along", "edges"}),
              HasSubstr("--cut-along edges"));
  write_mesh("two.obj", meshes::side_by_side(meshes::fan(6), meshes::fan(6)));
  const CliResult several = flatten_symmetric("two.obj", {"--symmetric", "auto"});
  EXPECT_EQ(several.exit_code, k_exit_usage);
  EXPECT_THAT(several.err, HasSubstr("--symmetric goes with one patch only"));
  EXPECT_EQ(planish({"unfold", "hill.obj", "-o", "a.svg", "--symmetric", "no"}).exit_code,
            k_exit_done);
}

TEST_F(Symmetric, TakesThePlaneInTheUnitOfTheModel) {
  const CliResult result = planish({"unfold", "hill.obj", "-o", "a.svg", "--cut", "dart.obj",
                                    "--symmetric", "x=6mm", "--unit", "cm", "--scale", "0.1"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err, HasSubstr("symmetric in x=6:"));
}

}  // namespace
}  // namespace planish::cli
