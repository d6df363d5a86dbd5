#include <planish/io/read_features.h>

#include "support/meshes.h"
#include "unit/io/io_testing.h"

namespace planish {
namespace {

using Indices = std::vector<Index>;

/// 25 vertices, number 5 y + x at (x, y).
const TriMesh& sheet() {
  static const TriMesh mesh = meshes::flat_grid(4, 4);
  return mesh;
}

CutLines cuts_listed(std::string_view text) {
  return parse_cuts(text, sheet(), "cuts.txt");
}
CutLines cuts_drawn(std::string_view text) {
  return parse_cuts(text, sheet(), "cuts.OBJ");
}

void refuses(CutLines (*read)(std::string_view), std::string_view text, ErrorCode code,
             std::size_t line, std::string_view part) {
  const Error error = error_of([&] { read(text); });
  EXPECT_EQ(to_string(error.code()), to_string(code)) << error.what();
  EXPECT_NE(error.message().find(part), std::string::npos) << error.what();
  EXPECT_EQ(error.place().line, line) << error.what();
  EXPECT_FALSE(error.place().path.empty());
}

TEST(ReadCuts, TakesACutALine) {
  const CutLines cuts = cuts_listed("# darts\n2 7 12\n\n  4,8, 12 # two\r\n");
  ASSERT_EQ(cuts.paths.size(), 2U);
  EXPECT_EQ(cuts.paths[0].vertices, (Indices{2, 7, 12}));
  EXPECT_EQ(cuts.paths[0].place.line, 2U);
  EXPECT_EQ(cuts.paths[1].vertices, (Indices{4, 8, 12}));
  EXPECT_EQ(cuts.paths[1].place.line, 4U);
  EXPECT_EQ(cuts.paths[1].place.path, "cuts.txt");
  EXPECT_EQ(cuts.farthest, 0.0);
}

TEST(ReadCuts, SnapsWhatIsDrawn) {
  const CutLines cuts = cuts_drawn("v 0.1 2 0\nv 2 2.2 0\nv 4.3 2 0\nl 1 2 3\nl -3 \\\n -1\np 2\n");
  ASSERT_EQ(cuts.paths.size(), 2U);
  EXPECT_EQ(cuts.paths[0].vertices, (Indices{10, 12, 14}));
  EXPECT_EQ(cuts.paths[1].vertices, (Indices{10, 14}));
  EXPECT_EQ(cuts.paths[1].place.line, 5U);
  EXPECT_NEAR(cuts.farthest, 0.3, 1e-15);
}

TEST(ReadCuts, AreReadAsTheyAreWritten) {
  const std::vector<Indices> paths = {{2, 7, 12}, {24, 18}};
  const CutLines cuts = cuts_listed(format_cuts(paths));
  ASSERT_EQ(cuts.paths.size(), 2U);
  EXPECT_EQ(cuts.paths[0].vertices, paths[0]);
  EXPECT_EQ(cuts.paths[1].vertices, paths[1]);
}

TEST(ReadCuts, RefusesWhatIsNoCut) {
  refuses(cuts_listed, "1 2\n3 25\n", ErrorCode::index_out_of_range, 2, "no vertex 25");
  refuses(cuts_listed, "1 x\n", ErrorCode::bad_number, 1, "is not the number of a vertex");
  refuses(cuts_listed, "# nothing\n", ErrorCode::malformed_file, 1, "names no cut");
  refuses(cuts_drawn, "v 0 0 0\np 1\n", ErrorCode::malformed_file, 1, "has no line");
  refuses(cuts_drawn, "v 0 0 0\nl 1\n", ErrorCode::malformed_file, 2, "a line needs two vertices");
  refuses(cuts_drawn, "v 0 2 0\nv 9 2 0\n\nl 1 2\n", ErrorCode::misplaced_cut, 4,
          "cut 1 leaves the mesh at (9, 2, 0): the nearest vertex, 14 at (4, 2, 0)");
  const Error error = error_of([] { parse_cuts("0 1", {}, "cuts.txt"); });
  EXPECT_EQ(error.code(), ErrorCode::no_triangles);
  EXPECT_EQ(error_of([] { read_cuts("no/such/file", sheet()); }).code(), ErrorCode::file_not_found);
}

CutLinesOnPatch lines_of(std::string_view text, const std::string& name,
                         const TriMesh& mesh = sheet()) {
  return parse_cut_lines(text, Patch(mesh), name, false);
}

TEST(ReadCutLines, GoTheShortestWayFromVertexToVertex) {
  const CutLinesOnPatch cuts = lines_of("2 7 12\n10 14 # across\n", "cuts.txt");
  ASSERT_EQ(cuts.lines.size(), 2U);
  EXPECT_NEAR(length_of(cuts.lines[0], sheet().positions), 2, 1e-14);
  EXPECT_NEAR(length_of(cuts.lines[1], sheet().positions), 4, 1e-14);
  EXPECT_EQ(cuts.places[1].line, 2U);
}

TEST(ReadCutLines, TakeDrawnLinesAndSayWhatLiesOutside) {
  const CutLinesOnPatch cuts = lines_of("v -1 2.5 0\nv 4 2.5 0\nl 1 2\n", "cuts.obj");
  ASSERT_EQ(cuts.lines.size(), 1U);
  EXPECT_NEAR(length_of(cuts.lines[0], sheet().positions), 4, 1e-12);
  EXPECT_NEAR(cuts.outside_length, 1, 1e-10);
  EXPECT_NEAR(cuts.farthest, 1, 1e-14);
}

TEST(ReadCutLines, RefuseWhatIsNoLineOnTheMesh) {
  TriMesh loose = sheet();
  loose.positions.push_back({9, 9, 0});
  const auto refuses = [](const TriMesh& mesh, const char* name, std::string_view text,
                          ErrorCode code, std::size_t line, std::string_view part) {
    const Error error = error_of([&] { lines_of(text, name, mesh); });
    EXPECT_EQ(to_string(error.code()), to_string(code)) << error.what();
    EXPECT_NE(error.message().find(part), std::string::npos) << error.what();
    EXPECT_EQ(error.place().line.value_or(0), line) << error.what();
    EXPECT_FALSE(error.place().path.empty()) << error.what();
  };
  refuses(loose, "cuts.txt", "2 7\n3 25\n", ErrorCode::misplaced_cut, 2, "no triangle uses");
  refuses(sheet(), "cuts.txt", "2 2\n", ErrorCode::misplaced_cut, 1, "one vertex only");
  refuses(sheet(), "cuts.obj", "v 1 1 0\np 1\n", ErrorCode::malformed_file, 1, "no line");
  refuses(sheet(), "cuts.obj", "v 1 1 0\nv 1 9 0\nl 1 2\n", ErrorCode::misplaced_cut, 3,
          "other units");
  refuses(sheet(), "cuts.obj", "v -2 0 0\nv -2 4 0\nl 1 2\n", ErrorCode::misplaced_cut, 0,
          "no line of the drawing lies on the mesh");
}

TEST(ReadCutLines, RefuseMoreWaysThanCanBeSearched) {
  const TriMesh mesh = meshes::flat_grid(100, 100);
  std::string there_and_back;
  for (int i = 0; i < 502; ++i)
    there_and_back += i % 2 == 0 ? "0 " : "2 ";
  const Error error = error_of([&] { lines_of(there_and_back, "cuts.txt", mesh); });
  EXPECT_EQ(error.code(), ErrorCode::too_large) << error.what();
  EXPECT_NE(error.message().find("cut 1 is one too many"), std::string::npos) << error.what();
}

}  // namespace
}  // namespace planish
