#include <thread>

#include <planish/io/mesh_format.h>
#include <planish/io/read_mesh.h>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "platform/path.h"
#include "unit/io/io_testing.h"

namespace planish {
namespace {

class ReadMeshOnPosix : public OwnFolder {};

TEST_F(ReadMeshOnPosix, ReadsFromAPipe) {
  const auto path = folder_ / "pipe.obj";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  TriMesh mesh = square();
  mesh.positions.resize(20'000);  // more than a pipe holds at once
  std::thread writer([&] { put_file(path, format_mesh(mesh, MeshFormat::obj)); });
  EXPECT_TRUE(same_bits(read_mesh(path).mesh, mesh));
  writer.join();
}

TEST_F(ReadMeshOnPosix, ReadsThroughASymbolicLink) {
  put_file(folder_ / "a.obj", format_mesh(square(), MeshFormat::obj));
  std::filesystem::create_symlink("a.obj", folder_ / "link.obj");
  EXPECT_TRUE(same_bits(read_mesh(folder_ / "link.obj").mesh, square()));
}

TEST_F(ReadMeshOnPosix, RefusesDevicesAndLoops) {
  std::filesystem::create_symlink("/dev/zero", folder_ / "zero.obj");
  std::filesystem::create_symlink("loop.obj", folder_ / "loop.obj");
  for (const std::string name : {"zero.obj", "loop.obj"}) {
    EXPECT_EQ(error_of([&] { read_mesh(folder_ / name); }).code(), ErrorCode::file_unreadable);
  }
}

TEST_F(ReadMeshOnPosix, RefusesLinksThatLeadNowhere) {
  std::filesystem::create_symlink("nowhere", folder_ / "dangling.obj");
  const Error error = error_of([&] { read_mesh(folder_ / "dangling.obj"); });
  EXPECT_EQ(error.code(), ErrorCode::file_not_found);
  EXPECT_EQ(error.place().path, utf8_of(folder_ / "dangling.obj"));
}

}  // namespace
}  // namespace planish
