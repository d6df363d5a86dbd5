#include <chrono>
#include <string>

#include <planish/io/mesh_format.h>

#include <gtest/gtest.h>

#include "oracle/polygon_division.h"
#include "unit/io/io_testing.h"

namespace planish {
namespace {

const std::string k_obj_corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";  // lines 1 to 4
const std::string k_obj_square = k_obj_corners + "f 1 2 3\nf 1 3 4\n";

ReadResult read_obj(std::string_view text) {
  return parse_mesh(text, MeshFormat::obj, "mesh");
}

void expect_obj_square(std::string_view text) {
  const ReadResult result = read_obj(text);
  EXPECT_TRUE(same_bits(result.mesh, square())) << text.substr(0, 300);
  EXPECT_EQ(result.format, MeshFormat::obj);
}

void expect_obj_refused(std::string_view text, ErrorCode code, std::size_t line,
                        std::string_view part = {}) {
  expect_refused(text, MeshFormat::obj, code, line, part);
}

TEST(ReadObj, ReadsVerticesAndTrianglesInTheirOrder) {
  expect_obj_square(k_obj_square);
  EXPECT_TRUE(read_obj(k_obj_square).notes.empty());
}

TEST(ReadObj, ReadsFacesOfEveryForm) {
  expect_obj_square(k_obj_corners + "vt 0 0\nvn 0 0 1\nf 1/1 2/1 3/1\nf 1//1 3//1 4//1\n");
  expect_obj_square(k_obj_corners + "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 1/-1/-1 3/ 4//\n");
}

TEST(ReadObj, CountsNegativeIndicesBackFromTheLastVertexSoFar) {
  expect_obj_square(k_obj_corners + "f -4 -3 -2\nf -4/1 -2//1 -1\n");
  expect_obj_square("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf 1 -2 -1\n");
}

TEST(ReadObj, AcceptsAPlusSign) {
  expect_obj_square("v +0 +0.0 0\nv +1e0 0 0\nv 1 +1 0\nv 0 +10e-1 0\nf +1 2 +3\nf 1 3 4\n");
}

TEST(ReadObj, ReadsFacesThatComeBeforeTheirVertices) {
  expect_obj_square("f 1 2 3\nf 1 3 4\n" + k_obj_corners);
}

TEST(ReadObj, SplitsPolygonsIntoTrianglesAndSaysSo) {
  const ReadResult result = read_obj(k_obj_corners + "f 1 2 3 4\n");
  EXPECT_TRUE(same_bits(result.mesh, square()));
  EXPECT_EQ(result.notes, std::vector<std::string>{"split 1 polygon into 2 triangles"});
  EXPECT_EQ(read_obj(k_obj_corners + "v -2 2 0\nf 1 2 3 4\nf 1 2 3 4 5\nf 1 2 3\n").notes,
            std::vector<std::string>{"split 2 polygons into 5 triangles"});
}

TEST(ReadObj, DividesPolygonsInsideThemselvesAlsoBeforeTheirVertices) {
  const std::string nook = "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\n";
  const std::vector<Triangle> inside = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(read_obj(nook + "f 1 2 3 4\n").mesh.triangles, inside);
  EXPECT_EQ(read_obj("f 1 2 3 4\n" + nook).mesh.triangles, inside);
  EXPECT_EQ(sorted_triangles(read_obj(nook + "f 2 3 4 1\n").mesh.triangles), inside);
  EXPECT_EQ(sorted_triangles(read_obj(nook + "f 4 3 2 1\n").mesh.triangles), inside);
}

TEST(ReadObj, KeepsTheGroupsOfPolygonsAndTheOrderOfFaces) {
  const ReadResult result = read_obj(
      k_obj_corners + "v 3 0 0\nv 3 1 0\nv 2 3 0\ng a\nf 1 2 3\ng b\nf 2 5 6 7 3\ng a\nf 1 3 4\n");
  EXPECT_EQ(result.groups.of_triangle, std::vector<Index>({0, 1, 1, 1, 0}));
  EXPECT_EQ(result.mesh.triangles.front(), (Triangle{0, 1, 2}));
  EXPECT_EQ(result.mesh.triangles.back(), (Triangle{0, 2, 3}));
}

TEST(ReadObj, DropsCornersThatComeTwiceInARow) {
  const ReadResult result = read_obj(k_obj_corners + "f 1 2 2 3 4 1\nf 1 1 2 3\nf 4 4 4 4\n");
  EXPECT_EQ(result.mesh.triangles,
            std::vector<Triangle>({{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {3, 3, 3}}));
  EXPECT_EQ(result.notes.front(), "dropped 6 corners that a face names twice in a row");
  const Error error = error_of([] {
    parse_mesh(k_obj_corners + "f 1 2 2 3 4\n", MeshFormat::obj, "mesh", {.strict = true});
  });
  EXPECT_EQ(error.place().line, 5U);
  EXPECT_NE(error.message().find("twice in a row"), std::string::npos);
}

TEST(ReadObj, RefusesPolygonsThatCrossThemselvesWithTheirLine) {
  expect_obj_refused(k_obj_corners + "f 1 2 3\nf 1 3 2 4\nf 1 3 4\n", ErrorCode::malformed_file, 6,
                     "4 corners crosses itself; divide it");
}

TEST(ReadObj, TakesColoursThatAreNoNumbers) {
  const std::string corners = "v 0 0 0 nan NaN -nan\nv 1 0 0 1 1 1\nv 1 1 0 1 1 1\nf 1 2 3\n";
  EXPECT_EQ(read_obj(corners).notes, std::vector<std::string>{"dropped the colours of 3 vertices"});
  EXPECT_EQ(
      error_of([&] { parse_mesh(corners, MeshFormat::obj, "mesh", {.strict = true}); }).code(),
      ErrorCode::non_finite_coordinate);
  expect_obj_refused("v 0 0 nan 0 0 0\n", ErrorCode::non_finite_coordinate, 1);
  expect_obj_refused("v 0 0 0 nan\n", ErrorCode::non_finite_coordinate, 1);  // a weight
}

TEST(ReadObj, KeepsVerticesThatNoFaceUses) {
  const ReadResult result = read_obj("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 8 8 8\nf 2 3 4\n");
  EXPECT_EQ(result.mesh.positions.size(), 5U);
  EXPECT_EQ(result.mesh.triangles, std::vector<Triangle>({{1, 2, 3}}));
}

TEST(ReadObj, WeldsNothing) {
  EXPECT_EQ(
      read_obj("v 0 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 4\nf 2 3 4\n").mesh.positions.size(), 4U);
}

TEST(ReadObj, AcceptsEveryLineEnd) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (const char c : k_obj_square)
      text += c == '\n' ? end : std::string(1, c);
    expect_obj_square(text);
    text.resize(text.size() - end.size());
    expect_obj_square(text);
  }
}

TEST(ReadObj, CountsLinesOfEveryLineEnd) {
  expect_obj_refused("v 0 0 0\r\n\r\nv 1 x 0\r\n", ErrorCode::bad_number, 3);
  expect_obj_refused("v 0 0 0\r\rv 1 x 0\r", ErrorCode::bad_number, 3);
  expect_obj_refused("v 0 0 0\n\nv 1 x 0", ErrorCode::bad_number, 3);
}

TEST(ReadObj, SkipsAUtf8ByteOrderMark) {
  expect_obj_square("\xef\xbb\xbf" + k_obj_square);
}

TEST(ReadObj, RefusesUtf16WithAWordAboutTheEncoding) {
  expect_obj_refused(std::string("\xff\xfev\0 \0", 6), ErrorCode::malformed_file, 1, "UTF-16");
  expect_obj_refused(std::string("\xfe\xff\0v\0 ", 6), ErrorCode::malformed_file, 1, "UTF-16");
}

TEST(ReadObj, AcceptsCommentsBlankLinesTabsAndIndentation) {
  expect_obj_square(
      "# a comment\n\n\t v\t0  0 0 # behind data\n   \nv 1 0 0\n#\nv 1 1 0 \t\n"
      "v 0 1 0\n\f\vf 1 2 3 # 4\nf 1 3 4\n#no line end");
}

TEST(ReadObj, JoinsLinesThatEndInABackslash) {
  expect_obj_square(
      "v 0 \\\n0 0\nv 1 0\\\r\n 0\nv \\\r1 1 0\nv 0 1 0\nf 1 2 \\\n \\\n3\nf 1 3 4\n");
  expect_obj_square(k_obj_corners + "g a \\\n f 1 2 4\nf 1 2 3\nf 1 3 4\n");
  expect_obj_refused("v 0 0 \\\n0\nv \\\n\\\n1 x 0\n", ErrorCode::bad_number, 5);
}

TEST(ReadObj, DoesNotJoinALineToAComment) {
  expect_obj_square("# C:\\models\\\n" + k_obj_square);
  expect_obj_square("v 0 0 0 # \\\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
}

TEST(ReadObj, PassesOverGroupsMaterialsAndNormalsWithoutAWord) {
  const std::string text = "mtllib a.mtl\no square\n" + k_obj_corners +
                           "vt 0 0\nvn 0 0 1\ng a b\nusemtl m\ns off\nf 1 2 3\ns 1\nf 1 3 4\n";
  expect_obj_square(text);
  EXPECT_TRUE(read_obj(text).notes.empty());
}

TEST(ReadObj, AcceptsAnyBytesInNames) {
  expect_obj_square("g \xe4\xff\x80\x01\nusemtl " + std::string("a\0b", 3) + "\n" + k_obj_square);
}

TEST(ReadObj, NotesWhichStatementsItSkipped) {
  const ReadResult result =
      read_obj(k_obj_square + "l 1 2\np 1\nl 2 3\nvp 0 1\ncurv 0 1 1 2\nparm u 0 1\nend\n");
  EXPECT_TRUE(same_bits(result.mesh, square()));
  EXPECT_EQ(result.notes,
            std::vector<std::string>{"skipped 7 statements of kinds l, p, vp, curv, parm, end"});
}

TEST(ReadObj, NotesUnknownStatementsAndTheFirstOfThem) {
  EXPECT_EQ(
      read_obj(k_obj_square + "hello\nw\x01rld 1\n").notes,
      std::vector<std::string>{"skipped 2 unknown statements, the first \"hello\" on line 7"});
}

TEST(ReadObj, DropsColoursWithANote) {
  const ReadResult result = read_obj("v 0 0 0 1 0 0\nv 1 0 0 1 0 0 1\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(result.notes, std::vector<std::string>{"dropped the colours of 2 vertices"});
  EXPECT_EQ(result.mesh.positions[1], (Vec3{1, 0, 0}));
}

TEST(ReadObj, AcceptsAWeight) {
  EXPECT_TRUE(read_obj("v 0 0 0 1.0\nv 1 0 0 1.0\nv 0 1 0 0.5\nf 1 2 3\n").notes.empty());
}

TEST(ReadObj, RefusesOddCountsOfNumbersOfAVertex) {
  expect_obj_refused("v 1 2\nv 0 0 0\n", ErrorCode::malformed_file, 1);
  expect_obj_refused("v\nv 0 0 0\n", ErrorCode::malformed_file, 1);
  expect_obj_refused("\nv 1 2", ErrorCode::truncated_file, 2);
  expect_obj_refused("v 1 2 3 4 5\n", ErrorCode::malformed_file, 1, "5 numbers");
  expect_obj_refused("v 1 2 3 4 5 6 7 8\n", ErrorCode::malformed_file, 1, "8 numbers");
}

TEST(ReadObj, RefusesWhatIsNotANumber) {
  for (const std::string word : {"x", "0x10", "1abc", "1.2.3", "1e", "--1", "+-1", "++1", "1d5",
                                 "-", "+", ".", "1_000", "\xd9\xa1", "1;", "infinit", "nane"}) {
    expect_obj_refused("v 0 0 0\nv 1 " + word + " 0\n", ErrorCode::bad_number, 2, "not a number");
  }
  expect_obj_refused("v 0 0 0 zero\n", ErrorCode::bad_number, 1);
}

TEST(ReadObj, SaysThatDecimalsNeedAPoint) {
  expect_obj_refused("v 0,1 0,2 0,3\n", ErrorCode::bad_number, 1, "a point, not a comma");
}

TEST(ReadObj, RefusesNumbersThatAreNotFinite) {
  for (const std::string word :
       {"nan", "NaN", "-nan", "+nan", "nan(1)", "inf", "INF", "-inf", "+inf", "Infinity"}) {
    expect_obj_refused("v 0 0 0\nv 1 0 " + word + "\n", ErrorCode::non_finite_coordinate, 2, word);
  }
}

TEST(ReadObj, RefusesNumbersThatADoubleCannotHold) {
  expect_obj_refused("v 0 0 1e999\n", ErrorCode::bad_number, 1, "too large");
  expect_obj_refused("v 0 0 -1" + std::string(400, '0') + "\n", ErrorCode::bad_number, 1,
                     "too large");
  EXPECT_EQ(read_obj("v 0 0 1e-999\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").mesh.positions[0], Vec3());
}

TEST(ReadObj, ReadsNumbersToTheLastBit) {
  const TriMesh mesh =
      read_obj(
          "v 0.1 1e300 5e-324\nv -0 2.2250738585072011e-308 1.7976931348623157e308\n"
          "v .5 5. 123456789012345678901234567890\nf 1 2 3\n")
          .mesh;
  const TriMesh expected = {.positions = {{0.1, 1e300, 5e-324},
                                          {-0.0, 2.2250738585072011e-308, 1.7976931348623157e308},
                                          {0.5, 5.0, 123456789012345678901234567890.0}},
                            .triangles = {{0, 1, 2}}};
  EXPECT_TRUE(same_bits(mesh, expected));
}

TEST(ReadObj, RefusesIndicesOutOfRangeAndNamesTheLine) {
  constexpr auto k_code = ErrorCode::index_out_of_range;
  expect_obj_refused(k_obj_corners + "f 1 2 5\n", k_code, 5, "vertex 5 but the file has 4");
  expect_obj_refused(k_obj_corners + "f 1 2 3\n\nf 0 1 2\n", k_code, 7, "counts from 1");
  expect_obj_refused(k_obj_corners + "f -0 1 2\n", k_code, 5);
  expect_obj_refused(k_obj_corners + "f -5 1 2\n", k_code, 5, "only 4 vertices");
  expect_obj_refused("f -1 -2 -3\n" + k_obj_corners, k_code, 1);
  for (const std::string large : {"4294967295", "4294967296", "4294967297", "18446744073709551617",
                                  "99999999999999999999", "-99999999999999999999"}) {
    expect_obj_refused(k_obj_corners + "f 1 2 " + large + "\n", k_code, 5, large);
  }
}

TEST(ReadObj, NamesTheFirstOfSeveralFacesOutOfRange) {
  expect_obj_refused("f 1 2 3\nf 1 2 7\nf 1 2 4\nf 1 2 99\nf 1 2 6\n" + k_obj_corners,
                     ErrorCode::index_out_of_range, 2, "vertex 7");
}

TEST(ReadObj, RefusesWhatIsNotACorner) {
  for (const std::string word :
       {"x", "1.0", "1x", "/1", "//", "-", "+", "--1", "1/2/3/4", "1/a", "1,2", "0x1", "1\\2"}) {
    expect_obj_refused(k_obj_corners + "f 1 2 " + word + "\n", ErrorCode::bad_number, 5);
  }
}

TEST(ReadObj, RefusesFacesOfFewerThanThreeCorners) {
  expect_obj_refused(k_obj_corners + "f\n", ErrorCode::malformed_file, 5, "has 0");
  expect_obj_refused(k_obj_corners + "f 1\n", ErrorCode::malformed_file, 5, "has 1");
  expect_obj_refused(k_obj_corners + "f 1 2 # 3\n", ErrorCode::malformed_file, 5, "has 2");
}

TEST(ReadObj, KeepsATriangleThatNamesAVertexTwice) {
  EXPECT_EQ(read_obj(k_obj_corners + "f 1 2 2\n").mesh.triangles,
            std::vector<Triangle>({{0, 1, 1}}));
}

TEST(ReadObj, RefusesPolygonsThatNameAVertexTwice) {
  expect_obj_refused(k_obj_corners + "f 1 2 3 2\n", ErrorCode::malformed_file, 5,
                     "names a vertex twice");
  expect_obj_refused(k_obj_corners + "f 1 2 3 4 2\n", ErrorCode::malformed_file, 5, "twice");
}

TEST(ReadObj, RefusesFilesWithoutFaces) {
  expect_obj_refused("# nothing\n\n", ErrorCode::no_triangles, 3, "no faces");
  expect_obj_refused(k_obj_corners, ErrorCode::no_triangles, 5, "4 vertices but no faces");
  expect_obj_refused(k_obj_corners + "l 1 2\n", ErrorCode::no_triangles, 6);
  expect_obj_refused(" ", ErrorCode::no_triangles, 1);
  EXPECT_EQ(error_of([] { read_obj(""); }).code(), ErrorCode::no_triangles);
}

TEST(ReadObj, RefusesProseAndOtherFormats) {
  constexpr auto k_code = ErrorCode::malformed_file;
  expect_obj_refused("Dear reader,\nthis is a letter.\n", k_code, 1, "no OBJ statement");
  expect_obj_refused("\nply\nformat ascii 1.0\n", k_code, 1, "\"ply\" on line 2");
  expect_obj_refused("OFF\n3 1 0\n0 0 0\n", k_code, 1, "no OBJ statement");
  expect_obj_refused(std::string("\0\1\2\x89PNG\xff", 8), k_code, 1,
                     "\\x00\\x01\\x02\\x89PNG\\xff");
}

TEST(ReadObj, CutsLongWordsInMessages) {
  const Error error = error_of([] { read_obj("v 0 0 " + std::string(100000, 'x') + "\n"); });
  EXPECT_LT(error.message().size(), 100U);
}

TEST(ReadObj, NeedsLinearTimeForLongLinesAndManyLines) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const std::string junk(10'000'000, 'x');
  expect_obj_square("# " + junk + "\n" + k_obj_square);
  expect_obj_square("g " + junk + "\n" + k_obj_square);
  expect_obj_square(std::string(10'000'000, '\r') + k_obj_square);
  std::string polygon = k_obj_corners + "f";
  for (int i = 0; i < 500'000; ++i)
    polygon += i % 2 == 0 ? " 1" : " 2";
  expect_obj_refused(polygon, ErrorCode::malformed_file, 5, "500000 corners");
  std::string continued = "f 1 2 3\nf 1 3 4\n";
  for (int i = 0; i < 1'000'000; ++i)
    continued += " \\\n";
  expect_obj_square(continued + "\n" + k_obj_corners);
  EXPECT_LT(Clock::now() - begin, std::chrono::seconds(20));  // tenths of a second, optimised
}

TEST(ReadObj, ReadsALargePolygonOverManyVertices) {
  std::string text;
  std::string face = "f";
  for (int i = 0; i < 1000; ++i) {
    text += "v " + std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  EXPECT_EQ(read_obj(text + face).mesh.triangles.size(), 998U);
}

}  // namespace
}  // namespace planish
