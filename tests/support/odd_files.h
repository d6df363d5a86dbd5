#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include <planish/io/read_mesh.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// A mesh of the folder that the environment variable PLANISH_TEST_DATA tells, as in
/// "odd/flap_of_five.obj"; none where it is not set.
inline std::optional<TriMesh> test_mesh(const std::string& name) {
  const char* folder = std::getenv("PLANISH_TEST_DATA");
  if (folder == nullptr) return std::nullopt;
  return read_mesh(std::filesystem::path(folder) / name).mesh;
}

}  // namespace planish
