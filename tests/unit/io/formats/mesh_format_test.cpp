#include <planish/io/mesh_format.h>

#include <gtest/gtest.h>

#include "unit/io/io_testing.h"

namespace planish {
namespace {

TEST(MeshFormat, IsNamedByTheExtensionInEitherCase) {
  EXPECT_EQ(mesh_format_of("a.obj"), MeshFormat::obj);
  EXPECT_EQ(mesh_format_of("some.where/B.PLY"), MeshFormat::ply);
  EXPECT_EQ(mesh_format_of("c.tar.Stl"), MeshFormat::stl);
  EXPECT_EQ(mesh_format_of("d.oFF"), MeshFormat::off);
}

TEST(MeshFormat, HasItsExtensionForName) {
  for (const MeshFormat format : k_mesh_formats) {
    EXPECT_EQ(mesh_format_of("a." + std::string(to_string(format))), format);
  }
}

TEST(MeshFormat, RefusesOthersAndNamesThoseThatAreKnown) {
  for (const std::string path : {"a.obj.gz", "a.fbx", "a", ".obj", "", "folder.obj/", "a.obj "}) {
    const Error error = error_of([&] { mesh_format_of(path); });
    EXPECT_EQ(error.code(), ErrorCode::unsupported_format);
    EXPECT_NE(error.message().find("known are .obj, .ply, .stl and .off"), std::string::npos);
    EXPECT_EQ(error.place().path, path);
  }
  EXPECT_EQ(error_of([] { mesh_format_of("a.obj.gz"); }).message(),
            "the extension \".gz\" is not known; known are .obj, .ply, .stl and .off");
}

TEST(MeshFormat, KnowsModelsThatOtherProgramsWrite) {
  for (const char* path : {"a.glb", "a.STEP", "a.3mf", "a.fbx", "a.dae", "a.3dm"})
    EXPECT_TRUE(is_other_model(path)) << path;
  for (const char* path : {"a.obj", "a.txt", "a", ".step", ""})
    EXPECT_FALSE(is_other_model(path)) << path;
}

}  // namespace
}  // namespace planish
