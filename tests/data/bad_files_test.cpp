// What is promised of files that are wrong or odd, on a collection of them beside the patches.

#include <planish/core/error.h>
#include <planish/io/read_mesh.h>

#include <gtest/gtest.h>

#include "support/test_patches.h"

namespace planish {
namespace {

TEST(BadFiles, AreParsedOrRefusedWithTheirPath) {
  for (const std::filesystem::path& path : bad_files()) {
    try {
      EXPECT_FALSE(read_mesh(path).mesh.triangles.empty()) << path;
    } catch (const Error& error) {
      EXPECT_EQ(error.place().path, path.string());
      EXPECT_LT(error.message().size(), 300U) << error.what();
    }
  }
}

}  // namespace
}  // namespace planish
