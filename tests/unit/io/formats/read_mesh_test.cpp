#include <planish/io/mesh_format.h>
#include <planish/io/read_mesh.h>

#include <gtest/gtest.h>

#include "platform/path.h"
#include "unit/io/io_testing.h"

namespace planish {
namespace {

class ReadMesh : public OwnFolder {};

TEST_F(ReadMesh, ReadsAFileOfEveryFormat) {
  for (const MeshFormat format : k_mesh_formats) {
    const auto path = folder_ / ("a." + std::string(to_string(format)));
    put_file(path, format_mesh(square(), format));
    const ReadResult result = read_mesh(path);
    EXPECT_TRUE(same_bits(result.mesh, square()));
    EXPECT_EQ(result.format, format);
  }
}

TEST_F(ReadMesh, NamesThePathAndTheLine) {
  const auto path = folder_ / "a.obj";
  put_file(path, "v 0 0 0\nv 0 0 x\n");
  const Error error = error_of([&] { read_mesh(path); });
  EXPECT_EQ(error.what(), utf8_of(path) + ":2: \"x\" is not a number");
}

TEST_F(ReadMesh, RefusesMissingFiles) {
  put_file(folder_ / "file", "");
  for (const auto& path :
       {folder_ / "none.obj", folder_ / "none" / "a.obj", folder_ / "file" / "a.obj"}) {
    const Error error = error_of([&] { read_mesh(path); });
    EXPECT_EQ(error.code(), ErrorCode::file_not_found) << path;
    EXPECT_EQ(error.place().path, utf8_of(path));
  }
}

TEST_F(ReadMesh, RefusesFolders) {
  std::filesystem::create_directory(folder_ / "folder.obj");
  EXPECT_EQ(error_of([&] { read_mesh(folder_ / "folder.obj"); }).code(),
            ErrorCode::file_unreadable);
}

TEST_F(ReadMesh, RefusesEmptyFiles) {
  for (const MeshFormat format : k_mesh_formats) {
    const auto path = folder_ / ("empty." + std::string(to_string(format)));
    put_file(path, "");
    const Error error = error_of([&] { read_mesh(path); });
    EXPECT_EQ(error.code(), ErrorCode::no_triangles);
    EXPECT_EQ(error.message(), "the file is empty");
  }
}

TEST_F(ReadMesh, RefusesUnknownExtensionsBeforeItLooksForTheFile) {
  EXPECT_EQ(error_of([] { read_mesh("none.xyz"); }).code(), ErrorCode::unsupported_format);
  const Error other = error_of([] { read_mesh("none.STEP"); });
  EXPECT_EQ(other.code(), ErrorCode::unsupported_format);
  EXPECT_EQ(other.message(),
            "files of the kind \".STEP\" cannot be read; export a mesh as OBJ or STL from the "
            "program that made it");
}

/// Files of every format: as written, and with what readers pass over or split.
const std::vector<std::pair<MeshFormat, std::string>>& samples() {
  using enum MeshFormat;
  static const std::vector<std::pair<MeshFormat, std::string>> samples = {
      {obj,
       "# x\nv 0 0 0 # y\nv 1 0 \\\n0\r\nv 1 1 0 1 0 0\nvt 0\ng a\nv 0 1 0\nl 1 2\n"
       "f 1/1 2//3 3/4/5\nf -4 -2 -1\nf 1 2 3 4\n"},
      {off, "COFF # x\n4 2 0\n0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n\n3 0 1 2 9\n4 0 1 2 3\n"},
      {ply,
       "ply\ncomment x\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty int y\n"
       "property double z\nproperty list char int q\nelement face 1\n"
       "property list uchar int vertex_index\nend_header\n0 0 0 1 2\n1 0 0 0\n1 1 0 0\n3 0 1 2"},
      {stl,
       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
       "endloop\nendfacet\nendsolid a\n"},
      {obj, format_mesh(square(), obj)},
      {off, format_mesh(square(), off)},
      {ply, format_mesh(square(), ply)},
      {stl, format_mesh(square(), stl)}};
  return samples;
}

/// Reading must give a mesh that keeps what the header promises, or an Error: nothing else.
bool is_read(std::string_view bytes, MeshFormat format) {
  // A copy of exactly this size, so that a sanitizer sees a step outside.
  const std::vector<char> copy(bytes.begin(), bytes.end());
  try {
    const TriMesh mesh = parse_mesh({copy.data(), copy.size()}, format).mesh;
    for (const Triangle& triangle : mesh.triangles) {
      for (const Index v : triangle)
        EXPECT_LT(v, mesh.positions.size());
    }
    return true;
  } catch (const Error&) {
    return false;
  }
}

TEST(ReadDamaged, ParsesOrRefusesEveryFileCutAtAnyByte) {
  for (const auto& [format, bytes] : samples()) {
    EXPECT_TRUE(is_read(bytes, format)) << bytes;
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      is_read(std::string_view(bytes).substr(0, size), format);
    }
  }
}

TEST(ReadDamaged, ParsesOrRefusesEveryFileWithAnyByteChanged) {
  for (const auto& [format, bytes] : samples()) {
    std::string damaged = bytes;
    for (char& c : damaged) {
      const char before = c;
      for (const char other : {'\0', '\xff', '\n', '\r', '\\', ' ', '9', '-', '/', '#'}) {
        c = other;
        is_read(damaged, format);
      }
      c = before;
    }
  }
}

TEST(ReadDamaged, ParsesOrRefusesEveryFormatReadAsAnyOther) {
  for (const auto& sample : samples()) {
    for (const MeshFormat format : k_mesh_formats) {
      if (format == sample.first) continue;
      EXPECT_FALSE(is_read(sample.second, format)) << sample.second;
    }
  }
}

}  // namespace
}  // namespace planish
