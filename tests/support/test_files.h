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

/// Tests of files in a folder of test_folder(). They are skipped if PLANISH_TEST_DATA is not set,
/// or its folder has no such part. A PLANISH_TEST_DATA that names no folder at all is a failure,
/// and so is a file that is missing.
template <class Base>
class WithFolder : public Base {
 protected:
  explicit WithFolder(const char* name) : name_(name) {}
  void SetUp() override {
    Base::SetUp();
    if (test_folder().empty()) GTEST_SKIP() << "PLANISH_TEST_DATA is not set";
    ASSERT_TRUE(std::filesystem::is_directory(test_folder())) << test_folder();
    if (!std::filesystem::is_directory(test_folder() / name_))
      GTEST_SKIP() << test_folder() << " has no folder " << name_;
  }

 private:
  const char* name_;
};

/// Tests of files in the folders "odd" and "bad".
template <class Base = testing::Test>
class WithOddFiles : public WithFolder<Base> {
 protected:
  WithOddFiles() : WithFolder<Base>("odd") {}

  /// @param name as in "odd/flap_of_five.obj"
  static std::filesystem::path file(const std::string& name) { return test_folder() / name; }
  static TriMesh mesh_of(const std::string& name) { return read_mesh(file(name)).mesh; }
};

/// Tests of whole products, in the folder "products".
template <class Base = testing::Test>
class WithProducts : public WithFolder<Base> {
 protected:
  WithProducts() : WithFolder<Base>("products") {}

  /// @param name as in "hat"
  static std::filesystem::path file(const std::string& name) {
    return test_folder() / "products" / (name + ".obj");
  }
  static Patch product(const std::string& name) { return Patch(read_mesh(file(name)).mesh); }
};

}  // namespace planish
