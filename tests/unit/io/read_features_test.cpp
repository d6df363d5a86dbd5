#include <planish/io/read_features.h>

#include "platform/path.h"
#include "support/meshes.h"
#include "unit/io/io_testing.h"

namespace planish {
namespace {

using Indices = std::vector<Index>;

/// 25 vertices, number 5 y + x at (x, y); diagonals go up to the right.
const Patch& grid() {
  static const Patch patch(meshes::flat_grid(4, 4));
  return patch;
}

Indices vertices_listed(std::string_view text) {
  return parse_fixed_vertices(text, grid(), "fixed.txt").vertices;
}
FixedVertices vertices_drawn(std::string_view text, const Patch& patch = grid()) {
  return parse_fixed_vertices(text, patch, "drawing.OBJ");
}

template <class Call>
void expect_refused(Call call, ErrorCode code, std::size_t line, std::string_view part) {
  const Error error = error_of(call);
  EXPECT_EQ(to_string(error.code()), to_string(code)) << error.what();
  EXPECT_NE(error.message().find(part), std::string::npos) << error.what();
  EXPECT_EQ(error.place().line, line) << error.what();
  EXPECT_FALSE(error.place().path.empty());
}

TEST(ReadFixedVertices, ListsNumbersFromNought) {
  EXPECT_EQ(vertices_listed("3\n0\n24\n"), (Indices{0, 3, 24}));
  EXPECT_EQ(vertices_listed("# seam\n7 8,9,\t10 , 11 # these\r\n,\n  8"),
            (Indices{7, 8, 9, 10, 11}));
  EXPECT_EQ(vertices_listed("\xef\xbb\xbf"
                            "2"),
            (Indices{2}));
  EXPECT_EQ(vertices_listed(""), (Indices{}));
}

TEST(ReadFixedVertices, RefusesWhatIsNoVertex) {
  const auto refused = [](std::string_view text, ErrorCode code, std::size_t line,
                          std::string_view part) {
    expect_refused([&] { vertices_listed(text); }, code, line, part);
  };
  refused("3\n25\n", ErrorCode::index_out_of_range, 2, "no vertex 25: the mesh has 25 vertices");
  refused("1 99999999999999999999999", ErrorCode::index_out_of_range, 1, "no vertex 9999999");
  for (const char* word : {"-1", "1.5", "x", "0x3", "+2", "3;"})
    refused("0 1\n\n" + std::string(word), ErrorCode::bad_number, 3, "is not the number");
}

TEST(ReadFixedVertices, JoinsTheCornersOfADrawnLineAlongEdges) {
  // From (0, 1) to (3, 1), and on along the column to (3, 4).
  const FixedVertices fixed = vertices_drawn("v 0.1 1 0\nv 3 1.2 0\nv 3 4 0.3\nl 1 2 3\n");
  EXPECT_EQ(fixed.vertices, (Indices{5, 6, 7, 8, 13, 18, 23}));
  EXPECT_NEAR(fixed.farthest, 0.3, 1e-15);
  // The diagonal, drawn backwards with relative numbers and over two lines of text.
  EXPECT_EQ(vertices_drawn("v 4 4 0\nv 0 0 0\nl -2 \\\n -1\n").vertices,
            (Indices{0, 6, 12, 18, 24}));
  EXPECT_EQ(vertices_drawn("v 4 4 0\nv 0 0 0\nl -2 -1\n").farthest, 0.0);
}

TEST(ReadFixedVertices, TakesPointsAndPassesOverTheRest) {
  const std::string text =
      "o seam\nvn 0 0 1\nl 1/1 3/3\nv 0 0 0 1 0 0\nv 2 2 0\nv 1 0 0\nv 4 4 0\nf 1 2 3\np 2 -1\n";
  EXPECT_EQ(vertices_drawn(text).vertices, (Indices{0, 1, 12, 24}));
}

TEST(ReadFixedVertices, SnapsAPointBetweenVerticesToTheSmallestNumber) {
  EXPECT_EQ(vertices_drawn("v 1.5 2.5 0\np 1\n").vertices, (Indices{11}));
}

TEST(ReadFixedVertices, RefusesDrawingsThatCannotBeRead) {
  const auto refused = [](std::string_view text, ErrorCode code, std::size_t line,
                          std::string_view part) {
    expect_refused([&] { vertices_drawn(text); }, code, line, part);
  };
  refused("v 0 0 0\nf 1 1 1\n", ErrorCode::malformed_file, 1, "draws nothing");
  refused("", ErrorCode::malformed_file, 1, "draws nothing");
  refused("v 0 0 0\nl 1\n", ErrorCode::malformed_file, 2, "two vertices");
  refused("v 0 0 0\np\n", ErrorCode::malformed_file, 2, "the line ends");
  refused("v 0 0 0\nl 1 0\n", ErrorCode::index_out_of_range, 2, "the line refers to vertex 0");
  refused("v 0 0 0\nl 1 -2\n", ErrorCode::index_out_of_range, 2, "only 1 vertices come before");
  refused("v 0 0 0\nl 1 7\n", ErrorCode::index_out_of_range, 2, "the file has 1 vertices");
  refused("v 0 0 0\np 1.5\n", ErrorCode::bad_number, 2, "\"1.5\" is not a corner of a point");
  refused("v 0 zero 0\np 1\n", ErrorCode::bad_number, 1, "\"zero\"");
  refused("v 0 nan 0\np 1\n", ErrorCode::non_finite_coordinate, 1, "nan");
}

/// The grid with the vertices of its first row red, and one hardly tinged.
std::string painted_grid(bool as_ply, double red, double most) {
  std::string text = as_ply ? "ply\nformat ascii 1.0\nelement vertex 25\nproperty float x\n"
                              "property float y\nproperty float z\nproperty uchar red\n"
                              "property uchar green\nproperty uchar blue\nelement face 1\n"
                              "property list uchar int vertex_indices\nend_header\n"
                            : "";
  for (int v = 0; v < 25; ++v) {
    const bool is_red = v < 5;
    const std::string other = std::to_string(is_red ? 0.0 : v == 7 ? 0.95 * most : most);
    const auto whole = [&](const std::string& number) {
      return as_ply ? number.substr(0, number.find('.')) : number;
    };
    text += (as_ply ? "" : "v ") + std::to_string(v % 5) + " " + std::to_string(v / 5) + " 0 " +
            whole(std::to_string(is_red ? red : most)) + " " + whole(other) + " " + whole(other) +
            "\n";
  }
  return text + (as_ply ? "3 0 1 5\n" : "f 1 2 6\n");
}

TEST(ReadFixedVertices, TakesPaintedVertices) {
  const auto painted_in = [](const std::string& text, const std::string& name) {
    return parse_fixed_vertices(text, grid(), name).vertices;
  };
  const Indices row = {0, 1, 2, 3, 4};
  EXPECT_EQ(painted_in(painted_grid(false, 0.5, 1.0), "a.obj"), row);
  EXPECT_EQ(painted_in(painted_grid(false, 200.0, 255.0), "a.obj"), row);
  EXPECT_EQ(painted_in(painted_grid(true, 200.0, 255.0), "a.ply"), row);
  // Drawn points come first.
  EXPECT_EQ(painted_in(painted_grid(false, 0.5, 1.0) + "p 25\n", "a.obj"), Indices{24});
}

TEST(ReadFixedVertices, RefusesColoursWithoutAGround) {
  std::string text;
  for (int v = 0; v < 5; ++v)
    text += "v " + std::to_string(v) + " " + std::to_string(v * v) + " 0 0 0 0." +
            std::to_string(v) + "\n";
  const auto read = [&] { vertices_drawn(text + "f 1 2 3\n"); };
  EXPECT_NE(error_of(read).message().find("no colour covers a quarter"), std::string::npos);
  const auto partly = [&] { vertices_drawn("v 0 0 0 1 1 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"); };
  EXPECT_NE(error_of(partly).message().find("not all vertices"), std::string::npos);
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
      "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_EQ(error_of([&] { parse_fixed_vertices(ply, grid(), "a.ply"); }).code(),
            ErrorCode::malformed_file);
}

TEST(ReadFixedVertices, RefusesALineBetweenPartsOfTheMesh) {
  const Patch mesh(meshes::side_by_side(meshes::flat_grid(2, 2), meshes::flat_grid(2, 2)));
  const auto read = [&] { vertices_drawn("v 0 0 0\nv 1000 0 0\nl 1 1\nl 1 2\n", mesh); };
  expect_refused(read, ErrorCode::several_components, 4, "to vertex 9, which is on another part");
  EXPECT_EQ(vertices_drawn("v 0 0 0\nv 1000 0 0\np 1 2\n", mesh).vertices, (Indices{0, 9}));
}

TEST(ReadFixedVertices, RefusesALineWhoseWaysAreTooLongTogether) {
  constexpr int length = 10'000, turns = 1500;
  std::string text = "v 0 0 0\nv 10000 1 0\nl";
  for (int i = 0; i < turns; ++i)
    text += " 1 2";
  const Patch strip(meshes::flat_grid(length, 1));  // few ways to choose from at a time
  expect_refused([&] { vertices_drawn(text + "\n", strip); }, ErrorCode::too_large, 3,
                 "draw more points");
}

TEST(ReadFixedVertices, NeedsTriangles) {
  EXPECT_EQ(error_of([] { vertices_drawn("v 0 0 0\np 1\n", {}); }).code(), ErrorCode::no_triangles);
}

TEST(ReadWeights, AreOneWhereNothingIsSaid) {
  std::vector<double> expected(25, 1.0);
  EXPECT_EQ(weights_in(parse_rows("", "weights"), 25), expected);
  expected[0] = 2.5, expected[24] = 1e-3;
  EXPECT_EQ(weights_in(parse_rows("# w\n24 1e-3\n\n 0\t2.5 # dear\n", "weights"), 25), expected);
}

TEST(ReadWeights, RefusesWhatIsNoWeight) {
  const auto refused = [](std::string_view text, ErrorCode code, std::size_t line,
                          std::string_view part) {
    expect_refused([&] { weights_in(parse_rows(text, "weights"), 25); }, code, line, part);
  };
  refused("1 2\n2 3\n1 2\n", ErrorCode::malformed_file, 3, "already, from line 1");
  refused("1 0\n", ErrorCode::malformed_file, 1, "the weight of vertex 1 is 0 but must be above 0");
  refused("1 -2\n", ErrorCode::malformed_file, 1, "is -2 but");
  refused("1\n2 3\n", ErrorCode::malformed_file, 1, "the weight is missing");
  refused("1 2 3\n", ErrorCode::malformed_file, 1, "more follows: \"3\"");
  refused("\n25 1\n", ErrorCode::index_out_of_range, 2, "no vertex 25");
  refused("one 1\n", ErrorCode::bad_number, 1, "\"one\"");
  for (const char* word : {"many", "nan", "inf", "1e999", "1,5"})
    refused("3 1\n4 " + std::string(word), ErrorCode::bad_number, 2, word);
}

class ReadFeatures : public OwnFolder {};

TEST_F(ReadFeatures, ReadFilesAndNameThem) {
  put_file(folder_ / "fixed.txt", "4 2");
  put_file(folder_ / "line.obj", "v 0 0 0\nv 2 0 0\nl 1 2\n");
  put_file(folder_ / "weights.txt", "3 7\n");
  EXPECT_EQ(read_fixed_vertices(folder_ / "fixed.txt", grid()).vertices, (Indices{2, 4}));
  EXPECT_EQ(read_fixed_vertices(folder_ / "line.obj", grid()).vertices, (Indices{0, 1, 2}));
  EXPECT_EQ(weights_in(read_rows(folder_ / "weights.txt"), 25)[3], 7.0);
  const auto missing = folder_ / "none.txt";
  for (const Error& error : {error_of([&] { read_fixed_vertices(missing, grid()); }),
                             error_of([&] { read_rows(missing); })}) {
    EXPECT_EQ(error.code(), ErrorCode::file_not_found);
    EXPECT_EQ(error.place().path, utf8_of(missing));
  }
}

}  // namespace
}  // namespace planish
