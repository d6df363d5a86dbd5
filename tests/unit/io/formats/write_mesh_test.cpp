#include <cmath>
#include <limits>

#include <planish/io/mesh_format.h>

#include <gtest/gtest.h>

#include "unit/io/io_testing.h"

namespace planish {
namespace {

class WriteMesh : public OwnFolder {};

TEST(FormatMesh, WritesObjCountingFromOne) {
  EXPECT_EQ(format_mesh(square(), MeshFormat::obj),
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
}

TEST(FormatMesh, PutsTextureCoordinatesIntoObjOneAVertex) {
  const std::vector<Vec2> texture = {{0, 0}, {25.5, 0}, {25.5, 1e-3}, {-1, 30}};
  EXPECT_EQ(format_textured_obj(square(), texture),
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
            "vt 0 0\nvt 25.5 0\nvt 25.5 0.001\nvt -1 30\n"
            "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
  const std::vector<Vec2> endless = {{0, 0}, {1, 0}, {1, HUGE_VAL}, {0, 1}};
  EXPECT_THROW(format_textured_obj(square(), endless), Error);
}

TEST(FormatMesh, KeepsEveryBitOfHardPositionsButInStl) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const double huge = std::numeric_limits<double>::max();
  const TriMesh mesh = {.positions = {{-0.0, 0.0, 1e300},
                                      {tiny, -tiny, 2.2250738585072011e-308},
                                      {huge, -huge, 1.0 / 3.0},
                                      {0.1, 1e22, 123456789.123456789},
                                      {1e23, 9007199254740993.0, -1e-7}},
                        .triangles = {{0, 1, 2}, {4, 3, 2}, {1, 1, 1}}};
  for (const MeshFormat format : {MeshFormat::obj, MeshFormat::ply, MeshFormat::off}) {
    EXPECT_TRUE(same_bits(parse_mesh(format_mesh(mesh, format), format).mesh, mesh))
        << to_string(format);
  }
}

TEST(FormatMesh, WritesMeshesWithoutTriangles) {
  for (const MeshFormat format : k_mesh_formats) {
    EXPECT_FALSE(format_mesh({.positions = {{1, 2, 3}}, .triangles = {}}, format).empty());
    EXPECT_NO_THROW(format_mesh({}, format));
  }
}

TEST(FormatMesh, RefusesPositionsThatAreNotFinite) {
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    TriMesh mesh = square();
    mesh.positions[3].z = value;
    for (const MeshFormat format : k_mesh_formats) {
      const Error error = error_of([&] { format_mesh(mesh, format); });
      EXPECT_EQ(error.code(), ErrorCode::non_finite_coordinate);
      EXPECT_EQ(error.place().first, 3U);
    }
  }
}

TEST(FormatMesh, RefusesIndicesOutOfRange) {
  TriMesh mesh = square();
  mesh.triangles[1][2] = 4;
  for (const MeshFormat format : k_mesh_formats) {
    const Error error = error_of([&] { format_mesh(mesh, format); });
    EXPECT_EQ(error.code(), ErrorCode::index_out_of_range);
    EXPECT_EQ(error.place().first, 1U);
  }
}

TEST_F(WriteMesh, WritesTheFormatThatTheExtensionNames) {
  for (const std::string name : {"a.obj", "a.PLY", "a.stl", "a.off"}) {
    write_mesh(folder_ / "new" / name, square());
    EXPECT_EQ(content_of(folder_ / "new" / name), format_mesh(square(), mesh_format_of(name)));
    EXPECT_TRUE(same_bits(read_mesh(folder_ / "new" / name).mesh, square()));
  }
}

TEST_F(WriteMesh, RefusesUnknownExtensionsAndWritesNothing) {
  EXPECT_EQ(error_of([&] { write_mesh(folder_ / "a.fbx", square()); }).code(),
            ErrorCode::unsupported_format);
  EXPECT_TRUE(names().empty());
}

}  // namespace
}  // namespace planish
