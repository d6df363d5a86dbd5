#include <cmath>

#include <planish/io/mesh_format.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/io/io_testing.h"

namespace planish {
namespace {

using testing::HasSubstr;

MeshFields fields_of_square() {
  return {.vertices = {{"height", {0.0, -1.5, 1.0 / 3.0, 1e-300}}, {"inner", {0, 1, 0, 1}}},
          .triangles = {{"strain", {0.25, -0.125}}}};
}

TEST(Fields, OfPlyLeaveTheMeshAsItIs) {
  const std::string bytes = format_fields(square(), fields_of_square(), FieldFormat::ply);
  EXPECT_TRUE(same_bits(parse_mesh(bytes, MeshFormat::ply).mesh, square()));
  EXPECT_THAT(bytes, HasSubstr("property double z\nproperty double height\n"));
  EXPECT_THAT(bytes, HasSubstr("vertex_indices\nproperty double strain\nend_header\n"));
}

TEST(Fields, OfPlyMayBeAnyNumber) {
  MeshFields fields = fields_of_square();
  fields.vertices[0].values = {HUGE_VAL, -HUGE_VAL, std::nan(""), 0.0};
  const std::string bytes = format_fields(square(), fields, FieldFormat::ply);
  EXPECT_TRUE(same_bits(parse_mesh(bytes, MeshFormat::ply).mesh, square()));
}

TEST(Fields, NoneMakeAPlyOfTheMeshAlone) {
  EXPECT_EQ(format_fields(square(), {}, FieldFormat::ply),
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
            "property double z\nelement face 2\nproperty list uchar int vertex_indices\n"
            "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
}

TEST(Fields, OfVtkStandInTheirArrays) {
  const std::string poly = format_fields(square(), fields_of_square(), FieldFormat::vtp);
  EXPECT_THAT(poly, HasSubstr("<Piece NumberOfPoints=\"4\" NumberOfPolys=\"2\">"));
  EXPECT_THAT(poly, HasSubstr("<DataArray type=\"Float64\" Name=\"height\" format=\"ascii\">\n"
                              "0\n-1.5\n0.3333333333333333\n1e-300\n</DataArray>"));
  EXPECT_THAT(poly, HasSubstr("<CellData>\n<DataArray type=\"Float64\" Name=\"strain\" "
                              "format=\"ascii\">\n0.25\n-0.125\n</DataArray>\n</CellData>"));
  EXPECT_THAT(poly, HasSubstr("0 1 2\n0 2 3\n"));
  EXPECT_THAT(poly, HasSubstr("\n3\n6\n"));
  const std::string grid = format_fields(square(), fields_of_square(), FieldFormat::vtu);
  EXPECT_THAT(grid, HasSubstr("<Piece NumberOfPoints=\"4\" NumberOfCells=\"2\">"));
  EXPECT_THAT(grid, HasSubstr("Name=\"types\" format=\"ascii\">\n5\n5\n"));
}

TEST(Fields, OfCsvHaveALineAnItem) {
  MeshFields fields = fields_of_square();
  fields.vertices[0].values[1] = std::nan("");
  EXPECT_EQ(vertex_fields_csv(square(), fields),
            "vertex,x,y,z,height,inner\n0,0,0,0,0,0\n1,1,0,0,,1\n"
            "2,1,1,0,0.3333333333333333,0\n3,0,1,0,1e-300,1\n");
  EXPECT_EQ(triangle_fields_csv(square(), fields),
            "triangle,a,b,c,strain\n0,0,1,2,0.25\n1,0,2,3,-0.125\n");
}

TEST(Fields, RefuseWrongCountsNamesAndMeshes) {
  const auto refuses = [](const TriMesh& mesh, const MeshFields& fields, ErrorCode code) {
    for (const FieldFormat format : {FieldFormat::ply, FieldFormat::vtp, FieldFormat::vtu})
      EXPECT_EQ(error_of([&] { format_fields(mesh, fields, format); }).code(), code);
    EXPECT_EQ(error_of([&] { vertex_fields_csv(mesh, fields); }).code(), code);
    EXPECT_EQ(error_of([&] { triangle_fields_csv(mesh, fields); }).code(), code);
  };
  MeshFields few = fields_of_square(), many = few;
  few.vertices[1].values.pop_back();
  refuses(square(), few, ErrorCode::option_out_of_range);
  many.triangles[0].values.push_back(1.0);
  refuses(square(), many, ErrorCode::option_out_of_range);
  for (const char* name : {"", "two words", "a\nb", "<a>", "a,b"}) {
    MeshFields named = fields_of_square();
    named.vertices[0].name = name;
    refuses(square(), named, ErrorCode::option_out_of_range);
  }
  TriMesh beyond = square();
  beyond.triangles[1][2] = 9;
  refuses(beyond, fields_of_square(), ErrorCode::index_out_of_range);
}

}  // namespace
}  // namespace planish
