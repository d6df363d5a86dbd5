#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include <planish/io/mesh_format.h>

#include <gtest/gtest.h>

#include "io/formats/welder.h"
#include "unit/io/io_testing.h"

namespace planish {
namespace {

using std::endian;

const std::string k_facet_1 =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\n"
    "endfacet\n";
const std::string k_facet_2 =
    "  facet normal nan -nan(ind) 1.#QNAN\n    outer loop\n      vertex 0.0 0e0 -0\n"
    "      vertex 1 1 0\n      vertex 0 +1 0\n    endloop\n  endfacet\n";
const std::string k_ascii_stl = "solid a name\n" + k_facet_1 + k_facet_2 + "endsolid a name\n";

std::string with_two_words() {
  std::string text = "solid a\n" + k_facet_1 + "end solid a\n";
  const std::size_t loop = text.find("endloop"), facet = text.find("endfacet");
  text.insert(facet + 3, " ");
  text.insert(loop + 3, "\n ");
  return text;
}

std::string binary(const std::string& title, std::uint32_t count, const TriMesh& mesh) {
  std::string bytes = title;
  bytes.resize(80, '\0');
  bytes += packed(endian::little, count);
  for (const Triangle& triangle : mesh.triangles) {
    bytes += packed(endian::little, 0.F, 0.F, 1.F);
    for (const Index v : triangle) {
      const Vec3 p = mesh.positions[v];
      bytes += packed(endian::little, static_cast<float>(p.x), static_cast<float>(p.y),
                      static_cast<float>(p.z));
    }
    bytes += packed(endian::little, std::uint16_t{0x1234});
  }
  return bytes;
}

const std::string k_note =
    "welded 6 corners to 4 vertices: STL has no vertex numbers, so an open seam would be closed "
    "too";

ReadResult read_stl(std::string_view bytes) {
  return parse_mesh(bytes, MeshFormat::stl, "mesh");
}

void expect_stl_square(std::string_view bytes) {
  const ReadResult result = read_stl(bytes);
  EXPECT_TRUE(same_bits(result.mesh, square()));
  EXPECT_EQ(result.format, MeshFormat::stl);
  EXPECT_EQ(result.notes, std::vector<std::string>{k_note});
}

TEST(ReadStl, TakesEndWordsInTwo) {
  const ReadResult result = read_stl(with_two_words());
  EXPECT_EQ(result.mesh.triangles, std::vector<Triangle>({{0, 1, 2}}));
  EXPECT_EQ(result.notes.back(), "took \"end\" and the word behind it for one word, 3 times");
  EXPECT_EQ(
      error_of([] { parse_mesh(with_two_words(), MeshFormat::stl, "mesh", {.strict = true}); })
          .place()
          .line,
      7U);
}

void expect_stl_refused(std::string_view text, ErrorCode code, std::size_t line,
                        std::string_view part = {}) {
  expect_refused(text, MeshFormat::stl, code, line, part);
}

void expect_stl_refused_at_byte(std::string_view bytes, ErrorCode code, std::size_t byte,
                                std::string_view part = {}) {
  expect_refused_at_byte(bytes, MeshFormat::stl, code, byte, part);
}

TEST(ReadStl, ReadsBinaryFilesAndWeldsEqualCorners) {
  expect_stl_square(binary("a header", 2, square()));
}

TEST(ReadStl, ReadsAsciiFilesAndWeldsEqualCorners) {
  expect_stl_square(k_ascii_stl);
}

TEST(ReadStl, ReadsKeywordsInEitherCaseAndAnyLayout) {
  std::string shouted;
  for (const char c : k_ascii_stl) {
    shouted += c >= 'a' && c <= 'z' && c != 'e' ? static_cast<char>(c - 32) : c;
  }
  expect_stl_square(shouted);
  std::string one_line = k_facet_1 + k_facet_2;
  for (char& c : one_line)
    c = c == '\n' ? ' ' : c;
  expect_stl_square("\xef\xbb\xbf\r\n solid\r\n" + one_line + "endsolid");
}

TEST(ReadStl, ReadsSeveralSolidsAsOneMesh) {
  expect_stl_square("solid a\n" + k_facet_1 + "endsolid a\nsolid \xe4\xff\n" + k_facet_2 +
                    "endsolid\n");
}

TEST(ReadStl, TellsABinaryFileThatBeginsWithSolidByItsSize) {
  expect_stl_square(binary("solid but binary", 2, square()));
  std::string blank = binary("", 2, square());
  blank.replace(0, 80, "solid" + std::string(75, ' '));
  expect_stl_square(blank);
}

TEST(ReadStl, TellsATruncatedBinaryFileThatBeginsWithSolid) {
  std::string bytes = binary("solid but binary", 2, square());
  bytes.pop_back();
  expect_stl_refused_at_byte(bytes, ErrorCode::truncated_file, 84, "2 facets but has room for 1");
}

TEST(ReadStl, NotesBytesAfterTheLastFacet) {
  const ReadResult result = read_stl(binary("", 2, square()) + "12345");
  EXPECT_TRUE(same_bits(result.mesh, square()));
  EXPECT_EQ(result.notes.back(), "ignored 5 bytes after the last facet");
}

TEST(ReadStl, WeldsMinusZeroToZeroAndKeepsTheFirst) {
  TriMesh soup = {.positions = {{-0.0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.0, 0, -0.0}, {0, 1, 0}},
                  .triangles = {{0, 1, 2}, {3, 2, 4}}};
  TriMesh expected = square();
  expected.positions[0].x = -0.0;
  EXPECT_TRUE(same_bits(read_stl(binary("", 2, soup)).mesh, expected));
}

TEST(ReadStl, DoesNotWeldCornersThatDifferInTheLastBit) {
  TriMesh soup = square();
  soup.positions.push_back({static_cast<double>(std::nextafter(1.0F, 2.0F)), 0, 0});
  soup.triangles = {{0, 1, 2}, {0, 4, 3}};
  EXPECT_EQ(read_stl(binary("", 2, soup)).mesh.positions.size(), 5U);
}

TEST(ReadStl, KeepsFacetsThatWeldingMakesDegenerate) {
  TriMesh mesh = square();
  mesh.triangles.push_back({1, 1, 2});
  EXPECT_EQ(read_stl(binary("", 3, mesh)).mesh.triangles, mesh.triangles);
}

TEST(ReadStl, RefusesCountsThatTheFileCannotHoldBeforeItAllocates) {
  constexpr auto k_code = ErrorCode::truncated_file;
  expect_stl_refused_at_byte(binary("", 3, square()), k_code, 84, "3 facets but has room for 2");
  expect_stl_refused_at_byte(binary("", 0xffffffff, square()), k_code, 84, "4294967295");
  expect_stl_refused_at_byte(std::string(83, '\0'), k_code, 0, "at least 84 bytes");
  expect_stl_refused_at_byte("\x89PNG\r\n\x1a\n" + std::string(200, 'x'), ErrorCode::malformed_file,
                             0, "a PNG image");
}

TEST(ReadStl, RefusesCountsThatLeaveFacetsBehind) {
  refusal(binary("", 1, square()), MeshFormat::stl, ErrorCode::malformed_file,
          "announces 1 facets but has 2");
}

TEST(ReadStl, RefusesFilesWithoutFacets) {
  expect_stl_refused_at_byte(binary("", 0, {}), ErrorCode::no_triangles, 84);
  expect_stl_refused("solid a\nendsolid a\n", ErrorCode::no_triangles, 3);
  EXPECT_EQ(error_of([] { read_stl(""); }).code(), ErrorCode::no_triangles);
}

TEST(ReadStl, RefusesCoordinatesThatAreNotFinite) {
  constexpr auto k_code = ErrorCode::non_finite_coordinate;
  for (const float value : {std::nanf(""), -std::numeric_limits<float>::infinity()}) {
    std::string bytes = binary("", 2, square());
    bytes.replace(84 + 50 + 12, 4, packed(endian::little, value));
    expect_stl_refused_at_byte(bytes, k_code, 84 + 50, "facet 1");
    EXPECT_EQ(refusal(bytes, MeshFormat::stl, k_code).place().first, 1U);
  }
  expect_stl_refused("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 nan 0\n", k_code, 4,
                     "facet 0");
}

TEST(ReadStl, RefusesAsciiFilesThatEndEarly) {
  constexpr auto k_code = ErrorCode::truncated_file;
  expect_stl_refused("solid a\n" + k_facet_1, k_code, 9, "without endsolid");
  expect_stl_refused("solid a\n" + k_facet_1 + "facet normal", k_code, 9, "facet 1");
  expect_stl_refused("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0", k_code, 4);
}

TEST(ReadStl, RefusesFacetsThatAreNoTriangles) {
  constexpr auto k_code = ErrorCode::malformed_file;
  const std::string start = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
  expect_stl_refused(start + "endloop\n", k_code, 6, "expected \"vertex\", found \"endloop\"");
  expect_stl_refused(start + "vertex 1 1 0\nvertex 0 1 0\n", k_code, 7, "expected \"endloop\"");
  expect_stl_refused("solid a\nvertex 0 0 0\n", k_code, 2, "expected \"facet\"");
  expect_stl_refused("solid a\nfacet 0 0 1\n", k_code, 2, "expected \"normal\"");
}

TEST(ReadStl, RefusesWordsThatAreNotNumbers) {
  expect_stl_refused("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0,5 0 0\n",
                     ErrorCode::bad_number, 4, "not a comma");
}

TEST(Welder, NumbersManyPositionsInOrderOfFirstUse) {
  Welder welder;
  for (int pass = 0; pass < 2; ++pass) {
    for (Index i = 0; i < 50000; ++i) {
      ASSERT_EQ(welder.vertex({static_cast<double>(i % 200), static_cast<double>(i / 200), 0}), i);
    }
  }
  EXPECT_EQ(welder.size(), 50000U);
  EXPECT_EQ(welder.take()[201], (Vec3{1, 1, 0}));
}

TEST(WriteStl, WritesUnitNormalsAndAHeaderThatDoesNotBeginWithSolid) {
  TriMesh mesh = square();
  for (Vec3& p : mesh.positions)
    p = 1e-30 * p;
  mesh.triangles.push_back({1, 1, 2});
  const std::string bytes = format_mesh(mesh, MeshFormat::stl);
  ASSERT_EQ(bytes.size(), 84U + 3 * 50U);
  EXPECT_FALSE(bytes.starts_with("solid"));
  EXPECT_EQ(bytes.substr(80, 4), packed(endian::little, std::uint32_t{3}));
  EXPECT_EQ(bytes.substr(84, 12), packed(endian::little, 0.F, 0.F, 1.F));
  EXPECT_EQ(bytes.substr(184, 12), packed(endian::little, 0.F, 0.F, 0.F));
  EXPECT_EQ(bytes.substr(96 + 12, 12), packed(endian::little, 1e-30F, 0.F, 0.F));
  EXPECT_EQ(bytes.substr(132, 2), std::string(2, '\0'));
}

TEST(WriteStl, SurvivesReadingUpToTheRoundingToFloats) {
  const TriMesh mesh = {.positions = {{0.1, 0, 0}, {1, 0.2, 0}, {0, 1, 1e38}, {-1, 0, 1e-40}},
                        .triangles = {{0, 1, 2}, {0, 2, 3}}};
  const TriMesh again = read_stl(format_mesh(mesh, MeshFormat::stl)).mesh;
  EXPECT_EQ(again.triangles, mesh.triangles);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(again.positions[i].x, static_cast<double>(static_cast<float>(mesh.positions[i].x)));
    EXPECT_EQ(again.positions[i].z, static_cast<double>(static_cast<float>(mesh.positions[i].z)));
  }
}

TEST(WriteStl, RefusesWhatFloatsCannotHold) {
  TriMesh mesh = square();
  mesh.positions[2].y = -1e39;
  const Error error = error_of([&] { format_mesh(mesh, MeshFormat::stl); });
  EXPECT_EQ(error.code(), ErrorCode::non_finite_coordinate);
  EXPECT_EQ(error.place().first, 2U);
  EXPECT_NO_THROW(format_mesh(mesh, MeshFormat::obj));
}

}  // namespace
}  // namespace planish
