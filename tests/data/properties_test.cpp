// What holds of any patch holds of real ones: the folder is that of patches_test.cpp.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <planish/evolve/evolve.h>
#include <planish/io/mesh_format.h>
#include <planish/io/read_mesh.h>
#include <planish/mesh/inspect.h>

#include <gtest/gtest.h>

#include "support/farthest.h"
#include "support/test_patches.h"

namespace planish {
namespace {

const std::array<Method, 4> k_methods = {ControllableLaplacian{}, ClassicalLaplacian{}, LeastNorm{},
                                         Auto{}};

std::vector<std::pair<std::string, TriMesh>> quick_patches() {
  std::vector<std::pair<std::string, TriMesh>> quick;
  for (const PatchFacts& facts : patches()) {
    if (facts.vertices < 6'000) quick.emplace_back(facts.name, read_mesh(facts.path).mesh);
  }
  return quick;
}

std::vector<Vec3> evolved(const TriMesh& mesh, const Method& method) {
  return evolve(Patch(mesh), method, {.max_sweeps = 2}).positions;
}

TEST(Patches, AreReadAsTheyWereWritten) {
  for (const PatchFacts& facts : patches()) {
    const TriMesh mesh = read_mesh(facts.path).mesh;
    for (const MeshFormat format : {MeshFormat::obj, MeshFormat::ply, MeshFormat::off}) {
      const TriMesh again = parse_mesh(format_mesh(mesh, format), format).mesh;
      EXPECT_EQ(again.positions == mesh.positions && again.triangles == mesh.triangles, true)
          << facts.name << " as " << to_string(format);
    }
  }
}

TEST(Patches, EndAlikeAtEverySizeOfAPowerOfTwo) {
  for (const auto& [name, mesh] : quick_patches()) {
    for (const Method& method : k_methods) {
      const std::vector<Vec3> expected = evolved(mesh, method);
      for (const double size : {std::ldexp(1.0, -100), std::ldexp(1.0, 100)}) {
        TriMesh scaled = mesh;
        for (Vec3& p : scaled.positions)
          p = size * p;
        const std::vector<Vec3> positions = evolved(scaled, method);
        std::size_t same = 0;
        for (std::size_t v = 0; v < positions.size(); ++v)
          same += positions[v] == size * expected[v] ? 1 : 0;
        EXPECT_EQ(same, positions.size()) << name << " by " << name_of(method) << " times " << size;
      }
    }
  }
}

/// The same patch with its vertices and triangles told from the last to the first.
TriMesh reversed(TriMesh mesh) {
  const auto last = static_cast<Index>(mesh.positions.size() - 1);
  std::reverse(mesh.positions.begin(), mesh.positions.end());
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  for (Triangle& t : mesh.triangles)
    t = {last - t[1], last - t[2], last - t[0]};
  return mesh;
}

TEST(Patches, EndAlikeHoweverTheyAreNumbered) {
  for (const auto& [name, mesh] : quick_patches()) {
    for (const Method& method : k_methods) {
      const std::vector<Vec3> one = evolved(mesh, method);
      std::vector<Vec3> other = evolved(reversed(mesh), method);
      std::reverse(other.begin(), other.end());
      EXPECT_LE(farthest(one, other), 1e-6 * bounding_box_diagonal(mesh))
          << name << " by " << name_of(method);
    }
  }
}

/// A mirror, and a turn whose sine and cosine are 3/5 and 4/5.
Vec3 turned(Vec3 p) {
  return {0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y, -p.z};
}

/// Sweeps, and auto's levels, take vertices in an order that follows their places.
TEST(Patches, EndAlikeHoweverTheyLie) {
  for (const auto& [name, mesh] : quick_patches()) {
    TriMesh moved = mesh;
    for (Vec3& p : moved.positions)
      p = turned(p);
    for (Triangle& t : moved.triangles)
      std::swap(t[1], t[2]);
    std::vector<Vec3> expected = evolved(mesh, LeastNorm{});
    for (Vec3& p : expected)
      p = turned(p);
    EXPECT_LE(farthest(expected, evolved(moved, LeastNorm{})), 1e-6 * bounding_box_diagonal(mesh))
        << name;
  }
}

}  // namespace
}  // namespace planish
