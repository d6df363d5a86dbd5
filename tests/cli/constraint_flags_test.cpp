#include <planish/io/read_mesh.h>
#include <planish/mesh/patch.h>

#include <gmock/gmock.h>

#include "cli_run.h"

namespace planish::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ConstraintFlags : public CliTest {
 protected:
  static void write_text(const std::string& path, const std::string& text) {
    std::ofstream(path) << text;
  }
};

/// The numbers of the inner vertices, every third one.
std::vector<Index> some_inner_vertices() {
  const Patch patch(read_mesh("panel.obj").mesh);
  std::vector<Index> some;
  for (std::size_t i = 0; i < patch.inner_vertices().size(); i += 3)
    some.push_back(patch.inner_vertices()[i]);
  return some;
}

/// How many of the vertices are elsewhere in two files.
std::size_t moved(const std::vector<Index>& vertices, const std::string& from,
                  const std::string& to) {
  const TriMesh before = read_mesh(from).mesh, after = read_mesh(to).mesh;
  std::size_t count = 0;
  for (const Index v : vertices)
    count += before.positions[v] != after.positions[v];
  return count;
}

TEST_F(ConstraintFlags, RemeshKeepsTheBorderAndTellsTheDeviationOfTheSurfaces) {
  ASSERT_EQ(planish({"sample", "panel", "-o", "dense.obj", "--vertices", "9000"}).exit_code, 0);
  const CliResult evolved = planish({"evolve", "dense.obj", "-o", "coarse.obj", "--method", "auto",
                                     "--remesh", "--json", "--quiet"});
  ASSERT_EQ(evolved.exit_code, k_exit_done) << evolved.err;
  const TriMesh before = read_mesh("dense.obj").mesh, after = read_mesh("coarse.obj").mesh;
  EXPECT_LT(after.positions.size(), 6000U);
  const Patch fine(before), coarse(after);
  EXPECT_EQ(fine.border_loops().front().size(), coarse.border_loops().front().size());
  EXPECT_THAT(evolved.out, HasSubstr("\"remeshed_from\": {"));
  EXPECT_THAT(evolved.out, HasSubstr("\"vertices\": " + std::to_string(before.positions.size())));
  EXPECT_THAT(evolved.out, HasSubstr("\"vertices\": " + std::to_string(after.positions.size())));
}

TEST_F(ConstraintFlags, SmoothFirstKeepsTheBorderAndTellsWhatItMoved) {
  const CliResult evolved = planish({"evolve", "panel.obj", "-o", "smoothed.obj", "--smooth-first",
                                     "2cm", "--sweeps", "3", "--method", "classical", "--json"});
  ASSERT_EQ(evolved.exit_code, k_exit_done) << evolved.err;
  EXPECT_THAT(evolved.out, HasSubstr("\"smoothed_first\": {\n    \"length\": 20.0,"));
  const CliResult flattened = planish({"flatten", "panel.obj", "--smooth-first", "20", "--sweeps",
                                       "3", "--method", "classical", "-o", "smoothed"});
  ASSERT_EQ(flattened.exit_code, k_exit_done) << flattened.err;
  EXPECT_THAT(flattened.out, HasSubstr("design smoothed first: waves shorter than 20.0 mm"));
  EXPECT_EQ(content_of("smoothed/processed.obj"), content_of("smoothed.obj"));
  planish({"evolve", "panel.obj", "-o", "raw.obj", "--sweeps", "3", "--method", "classical"});
  EXPECT_NE(content_of("smoothed.obj"), content_of("raw.obj"));
}

TEST_F(ConstraintFlags, SmoothFirstIsRefusedWhereItCannotBe) {
  write_text("held.txt", "1\n");
  for (const Names& other : {Names{"--remesh"}, Names{"--fix", "held.txt"}}) {
    Names words = {"flatten", "panel.obj", "--smooth-first", "20"};
    words.insert(words.end(), other.begin(), other.end());
    const CliResult refused = planish(words);
    EXPECT_EQ(refused.exit_code, k_exit_usage);
    EXPECT_THAT(refused.err, HasSubstr("--smooth-first and " + other[0] + " do not go together"));
  }
  EXPECT_EQ(planish({"flatten", "panel.obj", "--smooth-first", "0"}).exit_code, k_exit_usage);
  const CliResult far = planish({"evolve", "panel.obj", "-o", "x.obj", "--smooth-first", "1m"});
  EXPECT_EQ(far.exit_code, k_exit_usage);
  EXPECT_THAT(far.err, HasSubstr("smooth_first is 1000 but must be from 0 to "));
}

TEST_F(ConstraintFlags, FixHoldsTheVerticesOfAList) {
  const auto vertices = some_inner_vertices();
  std::string list = "# held\n";
  for (const Index v : vertices)
    list += std::to_string(v) + ",";
  write_text("held.txt", list);
  const CliResult evolved =
      planish({"evolve", "panel.obj", "-o", "held.obj", "--fix", "held.txt", "--sweeps", "3"});
  EXPECT_EQ(evolved.exit_code, k_exit_done) << evolved.err;
  EXPECT_THAT(
      evolved.err,
      HasSubstr("note: held.txt: fixed vertices: " + std::to_string(vertices.size()) + "\n"));
  EXPECT_EQ(moved(vertices, "panel.obj", "held.obj"), 0U);
  planish({"evolve", "panel.obj", "-o", "free.obj", "--sweeps", "3"});
  EXPECT_GT(moved(vertices, "panel.obj", "free.obj"), vertices.size() / 2);
  EXPECT_NE(content_of("held.obj"), content_of("panel.obj"));

  const CliResult flattened = planish({"flatten", "panel.obj", "--fix", "held.txt", "--method",
                                       "classical", "--sweeps", "3", "--quiet"});
  EXPECT_EQ(flattened.exit_code, k_exit_done) << flattened.err;
  EXPECT_EQ(flattened.err, "");
  EXPECT_EQ(moved(vertices, "panel.obj", "panel-pattern/processed.obj"), 0U);
}

TEST_F(ConstraintFlags, FixHoldsWhatADrawingLiesOn) {
  const TriMesh panel = read_mesh("panel.obj").mesh;
  const auto vertices = some_inner_vertices();
  std::string drawing;
  for (const Index v : {vertices.front(), vertices.back()}) {
    const Vec3 p = panel.positions[v];
    drawing += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z);
    drawing += "\n";
  }
  write_text("seam.obj", drawing + "l 1 2\n");
  const CliResult result =
      planish({"evolve", "panel.obj", "-o", "out.obj", "--fix", "seam.obj", "--sweeps", "3"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err, HasSubstr("note: seam.obj: fixed vertices: "));
  EXPECT_THAT(result.err, HasSubstr("what is drawn is at most "));
  EXPECT_EQ(moved({vertices.front(), vertices.back()}, "panel.obj", "out.obj"), 0U);
}

TEST_F(ConstraintFlags, FaultsOfTheirFilesNameTheFileAndWriteNothing) {
  write_text("far.txt", "0\n1000000\n");
  write_text("words.obj", "v 0 0 0\nl 1 two\n");
  for (const char* verb : {"evolve", "flatten"}) {
    for (const auto& [file, code] :
         {std::pair{"far.txt", "index_out_of_range"}, std::pair{"words.obj", "bad_number"},
          std::pair{"missing.txt", "file_not_found"}}) {
      const CliResult result =
          planish({verb, "panel.obj", "-o", "out.obj", "--fix", file, "--json"});
      EXPECT_EQ(result.exit_code, k_exit_failed);
      EXPECT_EQ(result.json()["error"]["code"], code);
      EXPECT_EQ(result.json()["error"]["path"], file);
    }
  }
  EXPECT_THAT(names(), ElementsAre("far.txt", "panel.obj", "words.obj"));
}

TEST_F(ConstraintFlags, OfAMeshThatCannotBeUsedTheMeshIsNamed) {
  write_text("twice.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\n");
  write_text("seam.obj", "v 0 0 0\np 1\n");
  const auto error =
      planish({"evolve", "twice.obj", "-o", "out.obj", "--fix", "seam.obj", "--strict", "--json"})
          .json()["error"];
  EXPECT_EQ(error["code"], "duplicate_triangle");
  EXPECT_EQ(error["path"], "twice.obj");
}

TEST_F(ConstraintFlags, WhatTheMethodCannotHonourIsAUsageErrorBeforeAnythingIsRead) {
  for (const char* verb : {"evolve", "flatten"}) {
    for (const char* flag : {"--weights", "--obstacle"}) {
      const CliResult result = planish({verb, "missing.obj", "-o", "out.obj", flag, "missing.txt",
                                        "--method", "classical", "--json"});
      EXPECT_EQ(result.exit_code, k_exit_usage);
      EXPECT_THAT(result.json()["error"]["message"].get<std::string>(),
                  HasSubstr("method classical cannot honour " + std::string(flag)));
    }
  }
}

}  // namespace
}  // namespace planish::cli
