#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include <planish/io/mesh_format.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/io/io_testing.h"

namespace planish {
namespace {

using std::endian;
using namespace std::string_literals;

const std::string k_xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string k_corner_list = "property list uchar int vertex_indices\n";

std::string header(const std::string& format, const std::string& body) {
  return "ply\nformat " + format + " 1.0\n" + body + "end_header\n";
}

std::string square_header(const std::string& format) {
  return header(format, "element vertex 4\n" + k_xyz + "element face 2\n" + k_corner_list);
}

/// Lines 1 to 9 are the header, 10 to 13 the vertices, 14 and 15 the faces.
const std::string k_ascii_ply = square_header("ascii") + k_square_positions + "3 0 1 2\n3 0 2 3\n";

template <class Coordinate, class Count, class Corner>
std::string square_body(endian order) {
  std::string bytes;
  for (const Vec3& p : square().positions) {
    bytes += packed(order, static_cast<Coordinate>(p.x), static_cast<Coordinate>(p.y),
                    static_cast<Coordinate>(p.z));
  }
  for (const auto& [a, b, c] : square().triangles) {
    bytes += packed(order, static_cast<Count>(3), static_cast<Corner>(a), static_cast<Corner>(b),
                    static_cast<Corner>(c));
  }
  return bytes;
}

const std::string k_little = "binary_little_endian";
const std::string k_binary_square =
    square_header(k_little) + square_body<float, std::uint8_t, std::int32_t>(endian::little);
const std::size_t k_body = square_header(k_little).size();  // first byte of the vertices
const std::size_t k_faces = k_body + 48;                    // first byte of the faces

ReadResult read_ply(std::string_view bytes) {
  return parse_mesh(bytes, MeshFormat::ply, "mesh");
}

void expect_ply_square(std::string_view bytes) {
  const ReadResult result = read_ply(bytes);
  EXPECT_TRUE(same_bits(result.mesh, square())) << bytes.substr(0, 300);
  EXPECT_EQ(result.format, MeshFormat::ply);
  EXPECT_TRUE(result.notes.empty());
}

void expect_ply_refused(std::string_view text, ErrorCode code, std::size_t line,
                        std::string_view part = {}) {
  expect_refused(text, MeshFormat::ply, code, line, part);
}

void expect_ply_refused_at_byte(std::string_view bytes, ErrorCode code, std::size_t byte,
                                std::string_view part = {}) {
  expect_refused_at_byte(bytes, MeshFormat::ply, code, byte, part);
}

std::string replaced(std::string text, const std::string& old_part, const std::string& new_part) {
  return text.replace(text.find(old_part), old_part.size(), new_part);
}

TEST(ReadPly, ReadsAsciiAndBothByteOrders) {
  expect_ply_square(k_ascii_ply);
  expect_ply_square(k_binary_square);
  expect_ply_square(square_header("binary_big_endian") +
                    square_body<float, std::uint8_t, std::int32_t>(endian::big));
}

template <class Coordinate>
void expect_coordinates_of_type(const std::string& name) {
  std::string text = square_header(k_little);
  for (const std::string axis : {"x", "y", "z"}) {
    text = replaced(text, "float " + axis, name + " " + axis);
  }
  expect_ply_square(text + square_body<Coordinate, std::uint8_t, std::int32_t>(endian::little));
}

TEST(ReadPly, ReadsCoordinatesOfEveryType) {
  for (const std::string name : {"char", "int8"})
    expect_coordinates_of_type<std::int8_t>(name);
  for (const std::string name : {"uchar", "uint8"})
    expect_coordinates_of_type<std::uint8_t>(name);
  for (const std::string name : {"short", "int16"})
    expect_coordinates_of_type<std::int16_t>(name);
  for (const std::string name : {"ushort", "uint16"}) {
    expect_coordinates_of_type<std::uint16_t>(name);
  }
  for (const std::string name : {"int", "int32"})
    expect_coordinates_of_type<std::int32_t>(name);
  for (const std::string name : {"uint", "uint32"})
    expect_coordinates_of_type<std::uint32_t>(name);
  for (const std::string name : {"float", "float32"})
    expect_coordinates_of_type<float>(name);
  for (const std::string name : {"double", "float64"})
    expect_coordinates_of_type<double>(name);
}

template <class Count, class Corner>
void expect_lists_of_types(const std::string& types) {
  for (const std::string name : {"vertex_indices", "vertex_index"}) {
    const std::string list = "property list " + types + " " + name + "\n";
    expect_ply_square(
        header("binary_big_endian", "element vertex 4\n" + k_xyz + "element face 2\n" + list) +
        square_body<float, Count, Corner>(endian::big));
  }
}

TEST(ReadPly, ReadsListsOfEveryType) {
  expect_lists_of_types<std::uint8_t, std::int32_t>("uchar int");
  expect_lists_of_types<std::int8_t, std::uint8_t>("char uchar");
  expect_lists_of_types<std::uint16_t, std::int8_t>("ushort char");
  expect_lists_of_types<std::int16_t, std::uint16_t>("short ushort");
  expect_lists_of_types<std::uint32_t, std::int16_t>("uint short");
  expect_lists_of_types<std::int32_t, std::uint32_t>("int uint");
  expect_lists_of_types<float, double>("float double");
}

TEST(ReadPly, ReadsSignedBytesAsSigned) {
  const std::string bytes =
      header(k_little,
             "element vertex 3\nproperty char x\nproperty short y\nproperty int z\n"
             "element face 1\n" +
                 k_corner_list) +
      packed(endian::little, std::int8_t{-1}, std::int16_t{-2}, std::int32_t{-3}) +
      packed(endian::little, std::int8_t{4}, std::int16_t{5}, std::int32_t{6}) +
      packed(endian::little, std::int8_t{7}, std::int16_t{8}, std::int32_t{9}) +
      packed(endian::little, std::uint8_t{3}, std::int32_t{0}, std::int32_t{1}, std::int32_t{2});
  EXPECT_EQ(read_ply(bytes).mesh.positions[0], (Vec3{-1, -2, -3}));
}

TEST(ReadPly, SkipsOtherPropertiesAndElements) {
  const std::string skipping =
      "element material 2\nproperty list uchar float weights\nproperty int id\n"
      "element vertex 4\nproperty uchar red\nproperty float y\nproperty float x\n"
      "property list uchar short tags\nproperty float z\nproperty double quality\n"
      "element face 2\nproperty uchar flag\nproperty list uchar int vertex_indices\n"
      "property list uchar float texcoord\nelement edge 1\nproperty int a\n";
  expect_ply_square(header("ascii", skipping) +
                    "0 7\n2 1.5 nan 8\n"
                    "255 0 0 0 0 1\n255 0 1 1 -5 0 inf\n255 1 1 2 1 2 0 1\n255 1 0 0 0 1\n"
                    "1 3 0 1 2 0\n1 3 0 2 3 2 0.5 x\n4\n");
  std::string body = packed(endian::little, std::uint8_t{0}, std::int32_t{7}, std::uint8_t{1}, 1.5F,
                            std::int32_t{8});
  for (const Vec3& p : square().positions) {
    body +=
        packed(endian::little, std::uint8_t{255}, static_cast<float>(p.y), static_cast<float>(p.x),
               std::uint8_t{1}, std::int16_t{-5}, static_cast<float>(p.z), std::nan(""));
  }
  for (const auto& [a, b, c] : square().triangles) {
    body += packed(endian::little, std::uint8_t{9}, std::uint8_t{3}, a, b, c, std::uint8_t{1}, 0.F);
  }
  expect_ply_square(header(k_little, skipping) + body + packed(endian::little, std::int32_t{4}));
}

TEST(ReadPly, ReadsFacesThatComeBeforeTheirVertices) {
  expect_ply_square(
      header("ascii", "element face 2\n" + k_corner_list + "element vertex 4\n" + k_xyz) +
      "3 0 1 2\n3 0 2 3\n" + k_square_positions);
}

TEST(ReadPly, SkipsCommentsAndBlankLinesOfTheHeader) {
  expect_ply_square(
      "ply\ncomment a b c\nformat ascii 1.0\nobj_info x\n\ncomment\nelement vertex 4\n" + k_xyz +
      "comment element vertex 9\nelement face 2\n" + k_corner_list + "end_header\n" +
      k_square_positions + "3 0 1 2\n3 0 2 3");
}

TEST(ReadPly, AcceptsEveryLineEndOfTheHeader) {
  for (const std::string end : {"\r\n", "\r"}) {
    std::string text;
    for (const char c : square_header(k_little))
      text += c == '\n' ? end : std::string(1, c);
    expect_ply_square(text + square_body<float, std::uint8_t, std::int32_t>(endian::little));
  }
}

TEST(ReadPly, TakesALineFeedAfterACarriageReturnHeaderForData) {
  std::string text = header(k_little,
                            "element vertex 3\nproperty uchar x\nproperty uchar y\n"
                            "property uchar z\nelement face 1\nproperty list uchar uchar "
                            "vertex_index\n");
  for (char& c : text)
    c = c == '\n' ? '\r' : c;
  const ReadResult result = read_ply(text + "\n\0\0\1\0\0\0\1\0\3\0\1\2"s);
  EXPECT_EQ(result.mesh.positions[0], (Vec3{10, 0, 0}));
}

TEST(ReadPly, TellsOfBytesAfterTheLastElement) {
  EXPECT_EQ(read_ply(k_binary_square + "more").notes,
            std::vector<std::string>{"ignored 4 bytes after the last item"});
  EXPECT_EQ(read_ply(k_ascii_ply + "more 1 2 3\n").notes.size(), 1U);
}

TEST(ReadPly, RefusesNumbersAfterTheLastElement) {
  expect_ply_refused(k_ascii_ply + "1 2 3 more\n", ErrorCode::malformed_file, 16,
                     "goes on with \"1\" after the 2 faces");
}

TEST(ReadPly, AcceptsItemsOfAsciiFilesThatAreBrokenOverLines) {
  expect_ply_square(square_header("ascii") +
                    "0\n0 0\n1 0 0\r\n1 1\n\n0\n0 1 0\n3\n0 1 2\n3 0\n2 3");
}

TEST(ReadPly, RefusesItemsOfAsciiFilesThatEndWithinALine) {
  constexpr auto k_code = ErrorCode::malformed_file;
  const std::string header = square_header("ascii");
  const std::string faces = "3 0 1 2\n3 0 2 3\n";
  expect_ply_refused(header + "0 0 0 9\n1 0 0\n1 1 0\n0 1 0\n" + faces, k_code, 10, "vertex 0");
  expect_ply_refused(header + "0 0 0\n1 0\n1 1 0\n0 1 0\n" + faces, k_code, 12, "vertex 1");
}

TEST(ReadPly, SplitsPolygonsIntoTrianglesAndSaysSo) {
  const std::string quad =
      header("ascii", "element vertex 4\n" + k_xyz + "element face 1\n" + k_corner_list);
  const ReadResult result = read_ply(quad + k_square_positions + "4 0 1 2 3\n");
  EXPECT_TRUE(same_bits(result.mesh, square()));
  EXPECT_EQ(result.notes, std::vector<std::string>{"split 1 polygon into 2 triangles"});
  expect_ply_refused(quad + k_square_positions + "4 0 1 2 1\n", ErrorCode::malformed_file, 14,
                     "face 0: a face of 4 corners crosses itself");
}

TEST(ReadPly, NamesTheByteOfABinaryFaceThatCrossesItself) {
  const std::string front =
      header(k_little, "element vertex 4\n" + k_xyz + "element face 1\n" + k_corner_list) +
      packed(endian::little, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 1.F, 0.F, 0.F, 1.F, 0.F);
  const std::string face = packed(endian::little, std::uint8_t{4}, 0, 2, 1, 3);
  expect_refused_at_byte(front + face, MeshFormat::ply, ErrorCode::malformed_file, front.size(),
                         "face 0: a face of 4 corners crosses itself");
}

TEST(ReadPly, TakesACarriageReturnOfTheLastHeaderLineAlone) {
  std::string text = square_header(k_little);
  text.insert(text.size() - 1, "\r");
  expect_ply_square(text + square_body<float, std::uint8_t, std::int32_t>(endian::little));
}

TEST(ReadPly, SaysWhatToDoWithPointsAlone) {
  expect_ply_refused(header("ascii", "element vertex 4\n" + k_xyz) + k_square_positions,
                     ErrorCode::no_triangles, 11, "4 points but no faces: make a surface of them");
}

TEST(ReadPly, RefusesHeadersThatAreNone) {
  constexpr auto k_code = ErrorCode::malformed_file;
  expect_ply_refused("plywood\n", k_code, 1, "begins with a line \"ply\"");
  expect_ply_refused("ply 1\n", k_code, 1);
  expect_ply_refused(std::string("\xff\xfep\0l\0y\0", 8), k_code, 1, "UTF-16");
  expect_ply_refused("ply\nelement vertex 4\nend_header\n", k_code, 4, "no format");
  expect_ply_refused("ply\nformat\n", k_code, 2);
  expect_ply_refused("ply\nformat binary_middle_endian 1.0\n", k_code, 2, "middle");
  expect_ply_refused("ply\nformat ascii 1.0\nproperty int x\n", k_code, 3,
                     "before the first element");
  expect_ply_refused("ply\nsomething else\n", k_code, 2, "\"something\"");
  expect_ply_refused(replaced(k_ascii_ply, "float x", "int64 x"), k_code, 4, "not a type of PLY");
  expect_ply_refused(replaced(k_ascii_ply, "float x", "float"), k_code, 4);
  expect_ply_refused(replaced(k_ascii_ply, "list uchar int", "list uchar"), k_code, 8);
  expect_ply_refused(replaced(k_ascii_ply, "end_header", "end_header 1"), k_code, 9);
  expect_ply_refused(replaced(k_ascii_ply, "element face", "element vertex 4\nelement face"),
                     k_code, 7, "twice");
  expect_ply_refused(replaced(k_ascii_ply, "element face", "element x 99999999999\nelement face"),
                     k_code, 11, "no properties");
}

TEST(ReadPly, RefusesAHeaderWithoutEnd) {
  expect_ply_refused("ply\nformat ascii 1.0\nelement vertex 4\n", ErrorCode::truncated_file, 4,
                     "end_header");
  expect_ply_refused("ply", ErrorCode::truncated_file, 1, "end_header");
}

TEST(ReadPly, RefusesCountsThatTheFileCannotHoldBeforeItAllocates) {
  constexpr auto k_code = ErrorCode::truncated_file;
  for (const std::string count : {"4000000000", "18446744073709551615", "99999999999999999999"}) {
    expect_ply_refused_at_byte(replaced(k_binary_square, "vertex 4", "vertex " + count), k_code,
                               k_body + count.size() - 1, "vertex");
    expect_ply_refused(replaced(k_ascii_ply, "vertex 4", "vertex " + count), k_code, 10, "vertex");
    expect_ply_refused_at_byte(replaced(k_binary_square, "face 2", "face " + count), k_code,
                               k_faces + count.size() - 1, "face");
    expect_ply_refused(replaced(k_ascii_ply, "face 2", "face " + count), k_code, 13, "face");
  }
  expect_ply_refused(replaced(k_ascii_ply, "element face",
                              "element x 9999\nproperty int a\n"
                              "element face"),
                     k_code, 15, "\"x\"");
}

TEST(ReadPly, RefusesCountsThatAreNone) {
  for (const std::string count : {"-5", "x", "4.0", "0x4", "4,"}) {
    expect_ply_refused(replaced(k_ascii_ply, "vertex 4", "vertex " + count),
                       ErrorCode::malformed_file, 3, "not a count");
  }
  expect_ply_refused(replaced(k_ascii_ply, "vertex 4", "vertex"), ErrorCode::malformed_file, 3);
}

TEST(ReadPly, RefusesVerticesWithoutCoordinates) {
  constexpr auto k_code = ErrorCode::malformed_file;
  expect_ply_refused(replaced(k_ascii_ply, "float z", "float w"), k_code, 10, "x, y and z");
  expect_ply_refused(replaced(k_ascii_ply, "float z", "list uchar float z"), k_code, 10);
  expect_ply_refused(header("ascii", "element face 1\n" + k_corner_list) + "3 0 1 2\n", k_code, 6,
                     "no element vertex");
}

TEST(ReadPly, RefusesFacesWithoutCornerLists) {
  constexpr auto k_code = ErrorCode::malformed_file;
  expect_ply_refused(replaced(k_ascii_ply, "vertex_indices", "corners"), k_code, 13, "no list");
  expect_ply_refused(replaced(k_ascii_ply, "list uchar int", "int"), k_code, 13, "no list");
}

TEST(ReadPly, RefusesFilesWithoutFaces) {
  const std::string points = "element vertex 4\n" + k_xyz;
  expect_ply_refused(header("ascii", points) + k_square_positions, ErrorCode::no_triangles, 11);
  expect_ply_refused(header("ascii", points + "element face 0\n") + k_square_positions,
                     ErrorCode::no_triangles, 12);
}

TEST(ReadPly, RefusesListsOfOddLengths) {
  constexpr auto k_code = ErrorCode::malformed_file;
  for (const std::string length : {"-1", "2.5", "1e10"}) {
    expect_ply_refused(replaced(k_ascii_ply, "3 0 2 3", length + " 0 2 3"), k_code, 15, "face 1");
  }
  expect_ply_refused(replaced(k_ascii_ply, "3 0 2 3", "2 0 2 3"), k_code, 15, "3 corners");
  expect_ply_refused(replaced(k_ascii_ply, "3 0 2 3", "0 0 2 3"), k_code, 15, "3 corners");
  expect_ply_refused(replaced(k_ascii_ply, "3 0 2 3", "255 0 2 3"), ErrorCode::truncated_file, 16,
                     "face 1");
  std::string bytes = k_binary_square;
  bytes[k_faces + 13] = '\2';
  expect_ply_refused_at_byte(bytes, k_code, k_faces + 13, "face 1");
  bytes[k_faces + 13] = '\xff';
  expect_ply_refused_at_byte(bytes, ErrorCode::truncated_file, k_faces + 13, "face 1");
}

TEST(ReadPly, RefusesNegativeListLengthsOfBinaryFiles) {
  const std::string text = replaced(square_header(k_little), "list uchar", "list char");
  std::string body = square_body<float, std::int8_t, std::int32_t>(endian::little);
  body[48] = '\xff';
  expect_ply_refused_at_byte(text + body, ErrorCode::malformed_file, text.size() + 48, "-1 items");
}

TEST(ReadPly, RefusesIndicesOutOfRangeAndNamesTheFace) {
  constexpr auto k_code = ErrorCode::index_out_of_range;
  for (const std::string index : {"4", "-1", "2147483647", "4294967297", "99999999999999999999"}) {
    expect_ply_refused(replaced(k_ascii_ply, "3 0 2 3", "3 0 2 " + index), k_code, 15, "face 1");
  }
  expect_ply_refused(replaced(k_ascii_ply, "3 0 2 3", "3 0 2 1.5"), ErrorCode::bad_number, 15);
  for (const std::int32_t index : {4, -1, std::numeric_limits<std::int32_t>::max(),
                                   std::numeric_limits<std::int32_t>::min()}) {
    std::string bytes = k_binary_square;
    bytes.replace(k_faces + 22, 4, packed(endian::little, index));
    expect_ply_refused_at_byte(bytes, k_code, k_faces + 13, std::to_string(index));
    EXPECT_EQ(refusal(bytes, MeshFormat::ply, k_code).place().first, 1U);
  }
}

TEST(ReadPly, RefusesAPropertyThatComesTwice) {
  const std::string text =
      replaced(k_ascii_ply, "property float y", "property float x\nproperty float y");
  refusal(text, MeshFormat::ply, ErrorCode::malformed_file, "\"x\" comes twice");
}

TEST(ReadPly, NamesAnItemOfAnyElementInFewWordsThatCanBePrinted) {
  const std::string name = '\1' + std::string(900, 'w');
  const std::string text = replaced(k_ascii_ply, "element face",
                                    "element " + name + " 1\nproperty float size\nelement face");
  const Error error = refusal(replaced(text, "3 0 1 2", "1 2\n3 0 1 2"), MeshFormat::ply,
                              ErrorCode::malformed_file);
  EXPECT_THAT(error.message(), testing::StartsWith("\\x01www"));
  EXPECT_LT(error.message().size(), 200U) << error.message();
}

TEST(ReadPly, RefusesIndicesThatAreNotNumbers) {
  const std::string list = "property list uchar double vertex_index\n";
  std::string bytes = header(k_little, "element vertex 4\n" + k_xyz + "element face 2\n" + list) +
                      square_body<float, std::uint8_t, double>(endian::little);
  for (const double index : {std::nan(""), 1e300, std::numeric_limits<double>::infinity()}) {
    bytes.replace(bytes.size() - 8, 8, packed(endian::little, index));
    refusal(bytes, MeshFormat::ply, ErrorCode::index_out_of_range, "face 1");
  }
  bytes.replace(bytes.size() - 8, 8, packed(endian::little, 0.5));
  refusal(bytes, MeshFormat::ply, ErrorCode::bad_number, "face 1");
}

TEST(ReadPly, RefusesCoordinatesThatAreNotFinite) {
  constexpr auto k_code = ErrorCode::non_finite_coordinate;
  for (const std::string word : {"nan", "-inf", "Infinity"}) {
    const std::string text = replaced(k_ascii_ply, "1 1 0\n", "1 " + word + " 0\n");
    expect_ply_refused(text, k_code, 12, "vertex 2");
    EXPECT_EQ(refusal(text, MeshFormat::ply, k_code).place().first, 2U);
  }
  for (const float value : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
    std::string bytes = k_binary_square;
    bytes.replace(k_body + 28, 4, packed(endian::little, value));
    expect_ply_refused_at_byte(bytes, k_code, k_body + 24, "vertex 2");
  }
}

TEST(ReadPly, RefusesWordsThatAreNotNumbers) {
  expect_ply_refused(replaced(k_ascii_ply, "1 1 0\n", "1 1,5 0\n"), ErrorCode::bad_number, 12,
                     "vertex 2");
}

TEST(ReadPly, RefusesBinaryFilesAtEveryCut) {
  for (std::size_t size = k_body; size < k_binary_square.size(); ++size) {
    refusal(k_binary_square.substr(0, size), MeshFormat::ply, ErrorCode::truncated_file);
  }
}

TEST(WritePly, WritesTheBytesOfTheFormat) {
  const std::string body = square_body<double, std::uint8_t, std::int32_t>(endian::little);
  EXPECT_EQ(format_mesh(square(), MeshFormat::ply),
            "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty double x\n"
            "property double y\nproperty double z\nelement face 2\n"
            "property list uchar int vertex_indices\nend_header\n" +
                body);
}

}  // namespace
}  // namespace planish
