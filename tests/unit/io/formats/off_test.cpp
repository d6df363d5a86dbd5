#include <string>

#include <planish/io/mesh_format.h>

#include <gtest/gtest.h>

#include "unit/io/io_testing.h"

namespace planish {
namespace {

const std::string k_off_square = "OFF\n4 2 0\n" + k_square_positions + "3 0 1 2\n3 0 2 3\n";

ReadResult read_off(std::string_view text) {
  return parse_mesh(text, MeshFormat::off, "mesh");
}

void expect_off_square(std::string_view text) {
  const ReadResult result = read_off(text);
  EXPECT_TRUE(same_bits(result.mesh, square())) << text;
  EXPECT_EQ(result.format, MeshFormat::off);
}

void expect_off_refused(std::string_view text, ErrorCode code, std::size_t line,
                        std::string_view part = {}) {
  expect_refused(text, MeshFormat::off, code, line, part);
}

TEST(ReadOff, ReadsVerticesAndTrianglesInTheirOrder) {
  expect_off_square(k_off_square);
  EXPECT_TRUE(read_off(k_off_square).notes.empty());
}

TEST(ReadOff, ReadsCountsOnTheLineOfTheHeaderAndWithoutEdges) {
  expect_off_square("OFF 4 2 0\n" + k_square_positions + "3 0 1 2\n3 0 2 3");
  expect_off_square("OFF\n4 2\n" + k_square_positions + "3 0 1 2\n3 0 2 3");
}

TEST(ReadOff, SkipsCommentsBlankLinesAndByteOrderMark) {
  expect_off_square(
      "\xef\xbb\xbf# made by hand\n\nOFF # here\n\n# counts\n4 2 5\n\n0 0 0\n1 0 0 # two\n"
      "# between\n\t1 1 0\n\n0 1 0\n3 0 1 2\n#\n3  0 2 3\n");
}

TEST(ReadOff, AcceptsEveryLineEnd) {
  for (const std::string end : {"\r\n", "\r"}) {
    std::string text;
    for (const char c : k_off_square)
      text += c == '\n' ? end : std::string(1, c);
    expect_off_square(text);
  }
}

TEST(ReadOff, SplitsPolygonsIntoTrianglesAndSaysSo) {
  const ReadResult result = read_off("OFF\n4 1 0\n" + k_square_positions + "4 0 1 2 3\n");
  EXPECT_TRUE(same_bits(result.mesh, square()));
  EXPECT_EQ(result.notes, std::vector<std::string>{"split 1 polygon into 2 triangles"});
  expect_off_refused("OFF\n4 2 0\n" + k_square_positions + "3 0 1 2\n4 0 2 1 3\n",
                     ErrorCode::malformed_file, 8, "face 1: a face of 4 corners crosses itself");
}

TEST(ReadOff, SkipsColoursOfFaces) {
  const std::string text =
      "OFF\n4 2 0\n" + k_square_positions + "3 0 1 2 255 0 0\n3 0 2 3 0.5 0.5 0.5 1\n";
  expect_off_square(text);
  EXPECT_TRUE(read_off(text).notes.empty());
}

TEST(ReadOff, DropsColoursAndNormalsOfVerticesWithANote) {
  for (const std::string kind : {"OFF", "COFF", "NOFF", "CNOFF", "STOFF"}) {
    const ReadResult result = read_off(kind + "\n4 2 0\n0 0 0 1 0 0\n1 0 0 1 0 0\n1 1 0 1 0 0\n" +
                                       "0 1 0 x y z\n3 0 1 2\n3 0 2 3\n");
    EXPECT_TRUE(same_bits(result.mesh, square()));
    EXPECT_EQ(result.notes.size(), 1U);
    EXPECT_NE(result.notes[0].find("of 4 vertices"), std::string::npos);
  }
}

TEST(ReadOff, RefusesVerticesOfDifferentlyManyNumbers) {
  expect_off_refused("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0 5\n0 1 0\n3 0 1 2\n3 0 2 3\n",
                     ErrorCode::malformed_file, 5, "vertex 2: its line has 4 numbers");
  // One vertex too many is announced: a face would be one.
  expect_off_refused("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n3 0 1 2\n",
                     ErrorCode::malformed_file, 6, "4 numbers");
}

TEST(ReadOff, TellsOfWordsBehindTheLastFaceAndRefusesNumbers) {
  const std::string triangle = "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n";
  EXPECT_EQ(read_off(triangle + "\nend\n").notes,
            std::vector<std::string>{"ignored what follows the last item, from line 8 on"});
  EXPECT_TRUE(read_off(triangle + "# end\n").notes.empty());
  expect_off_refused(triangle + "3 0 2 1\n", ErrorCode::malformed_file, 7, "after the 1 face that");
}

TEST(ReadOff, RefusesOtherKindsByName) {
  constexpr auto k_code = ErrorCode::unsupported_format;
  expect_off_refused("4OFF\n4 2 0\n", k_code, 1, "\"4OFF\"");
  expect_off_refused("nOFF\n3 4 2 0\n", k_code, 1, "\"nOFF\"");
  expect_off_refused("OFF BINARY\n1", k_code, 1, "binary");
}

TEST(ReadOff, RefusesWhatIsNoOffFile) {
  constexpr auto k_code = ErrorCode::malformed_file;
  expect_off_refused("4 2 0\n" + k_square_positions, k_code, 1, "begins with OFF");
  expect_off_refused("\nhello\n", k_code, 2, "\"hello\"");
  expect_off_refused(std::string("\xfe\xff\0O\0F", 6), k_code, 1, "UTF-16");
  expect_off_refused("# nothing\n", ErrorCode::no_triangles, 2);
}

TEST(ReadOff, RefusesCountsThatAreNone) {
  for (const std::string counts : {"-4 2 0", "x 2 0", "4 2.5 0", "4 2 z", "4"}) {
    expect_off_refused("OFF\n" + counts + "\n" + k_square_positions, ErrorCode::malformed_file, 2);
  }
  expect_off_refused("OFF", ErrorCode::truncated_file, 1);
}

TEST(ReadOff, RefusesCountsThatTheFileCannotHoldBeforeItAllocates) {
  for (const std::string counts :
       {"4000000000 2 0", "4 4000000000 0", "18446744073709551615 18446744073709551615 0",
        "99999999999999999999 1", "3074457345618258603 2 0"}) {
    expect_off_refused("OFF\n" + counts + "\n" + k_square_positions + "3 0 1 2\n3 0 2 3\n",
                       ErrorCode::truncated_file, 2, "announces");
  }
}

TEST(ReadOff, RefusesFilesThatEndEarly) {
  expect_off_refused(
      "OFF\n4 3 0\n" + k_square_positions + "3 0 1 2 255 255 255\n3 0 2 3 255 255 255\n",
      ErrorCode::truncated_file, 9, "face 2");
  expect_off_refused("OFF\n5 1 0\n" + k_square_positions + "# a comment, no data\n",
                     ErrorCode::truncated_file, 8, "vertex 4");
}

TEST(ReadOff, RefusesFilesWithoutFaces) {
  expect_off_refused("OFF\n4 0 0\n" + k_square_positions, ErrorCode::no_triangles, 2);
}

TEST(ReadOff, RefusesBadNumbersAndNamesVertexAndLine) {
  expect_off_refused("OFF\n4 2 0\n0 0 0\n1 0,5 0\n" + k_off_square, ErrorCode::bad_number, 4,
                     "vertex 1");
  expect_off_refused("OFF\n4 2 0\n0 0 0\n1 0\n" + k_off_square, ErrorCode::malformed_file, 4,
                     "vertex 1");
  expect_off_refused("OFF\n4 2 0\n0 0 0\n1 nan 0\n" + k_off_square,
                     ErrorCode::non_finite_coordinate, 4, "vertex 1");
}

TEST(ReadOff, RefusesBadFacesAndNamesFaceAndLine) {
  const std::string start = "OFF\n4 2 0\n" + k_square_positions + "3 0 1 2\n";
  expect_off_refused(start + "3 0 2 4\n", ErrorCode::index_out_of_range, 8, "face 1");
  expect_off_refused(start + "3 0 2 -1\n", ErrorCode::index_out_of_range, 8, "face 1");
  expect_off_refused(start + "3 0 2 1.5\n", ErrorCode::bad_number, 8, "face 1");
  expect_off_refused(start + "2 0 2 3 4\n", ErrorCode::malformed_file, 8, "3 corners");
  expect_off_refused(start + "4 0 2 3\n3", ErrorCode::malformed_file, 8, "a number should follow");
  expect_off_refused(start + "4 0 2 3 2\n", ErrorCode::malformed_file, 8, "twice");
  expect_off_refused(start + "-3 0 2 3\n", ErrorCode::malformed_file, 8, "not a count");
  expect_off_refused(start + "99999999999999999999 0 1 2\n", ErrorCode::malformed_file, 8);
}

TEST(WriteOff, WritesTheTextOfTheFormat) {
  EXPECT_EQ(format_mesh(square(), MeshFormat::off), k_off_square);
}

}  // namespace
}  // namespace planish
