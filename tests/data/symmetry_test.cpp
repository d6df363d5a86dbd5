#include <cstdlib>
#include <filesystem>
#include <string>

#include <planish/io/read_mesh.h>
#include <planish/mesh/symmetry.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

/// The folder of whole products; empty where there is none.
std::filesystem::path products() {
  const char* folder = std::getenv("PLANISH_TEST_DATA");
  if (folder == nullptr) return {};
  const std::filesystem::path products = std::filesystem::path(folder) / "products";
  return std::filesystem::exists(products) ? products : std::filesystem::path();
}

Patch product(const std::string& name) {
  return Patch(read_mesh(products() / (name + ".obj")).mesh);
}

TEST(SymmetryOfProducts, IsFoundWhereTheirMakersSayItIs) {
  if (products().empty()) GTEST_SKIP() << "PLANISH_TEST_DATA names no folder with products";
  for (const char* name : {"body", "car"}) {
    const Symmetry symmetry = find_symmetry(product(name));
    EXPECT_EQ(symmetry.plane.normal, (Vec3{1.0, 0.0, 0.0})) << name;
    EXPECT_EQ(symmetry.plane.offset, 0.0) << name;
    EXPECT_EQ(symmetry.largest, 0.0) << name;
    EXPECT_FALSE(symmetry.image.empty()) << name;
  }
  const Patch hull = product("hull");
  const Symmetry nearly = find_symmetry(hull);
  EXPECT_NO_THROW(require_symmetric(hull, nearly));
  EXPECT_GT(nearly.largest, 0.0);
  for (const char* name : {"shoe", "toy"}) {
    const Patch patch = product(name);
    EXPECT_THROW(require_symmetric(patch, find_symmetry(patch)), Error) << name;
  }
}

}  // namespace
}  // namespace planish
