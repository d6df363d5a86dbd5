#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include <planish/io/read_mesh.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/tri_mesh.h>

#include <gtest/gtest.h>

namespace planish {

/// The folder of files for tests; empty where PLANISH_TEST_DATA names none.
inline std::filesystem::path test_folder() {
  const char* named = std::getenv("PLANISH_TEST_DATA");
  return named == nullptr ? std::filesystem::path() : std::filesystem::path(named);
}

/// Tests of files in the folders "odd" and "bad" beside the real patches. They are skipped where
/// the environment variable PLANISH_TEST_DATA names no folder with "odd"; where it does, a file
/// that is missing is a failure.
template <class Base = testing::Test>
class WithOddFiles : public Base {
 protected:
  void SetUp() override {
    Base::SetUp();
    if (!std::filesystem::is_directory(test_folder() / "odd"))
      GTEST_SKIP() << "PLANISH_TEST_DATA names no folder with odd meshes";
  }

  /// @param name as in "odd/flap_of_five.obj"
  static std::filesystem::path file(const std::string& name) { return test_folder() / name; }
  static TriMesh mesh_of(const std::string& name) { return read_mesh(file(name)).mesh; }
};

/// The same of whole products, in the folder "products".
template <class Base = testing::Test>
class WithProducts : public Base {
 protected:
  void SetUp() override {
    Base::SetUp();
    if (!std::filesystem::is_directory(test_folder() / "products"))
      GTEST_SKIP() << "PLANISH_TEST_DATA names no folder with products";
  }

  /// @param name as in "hat"
  static std::filesystem::path file(const std::string& name) {
    return test_folder() / "products" / (name + ".obj");
  }
  static Patch product(const std::string& name) { return Patch(read_mesh(file(name)).mesh); }
};

}  // namespace planish
