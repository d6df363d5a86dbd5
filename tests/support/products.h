#pragma once

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "mesh/split.h"

namespace planish {

/// An OBJ file of patches, each an object, that share no vertices.
inline void write_product(const std::string& path, const std::vector<NamedPatch>& patches) {
  std::ofstream file(path);
  file.precision(17);
  std::size_t first = 1;
  for (const NamedPatch& patch : patches) {
    file << "o " << patch.name << "\n";
    for (const Vec3& p : patch.mesh.positions)
      file << "v " << p.x << " " << p.y << " " << p.z << "\n";
    for (const Triangle& t : patch.mesh.triangles)
      file << "f " << t[0] + first << " " << t[1] + first << " " << t[2] + first << "\n";
    first += patch.mesh.positions.size();
  }
}

/// A mesh cut across its longest side into parts of about as many triangles, along edges: the cuts
/// are jagged.
inline std::vector<NamedPatch> in_strips(const TriMesh& mesh, std::size_t count) {
  const auto coordinate = [&](std::size_t axis, Vec3 p) {
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
  };
  std::size_t longest = 0;
  double most = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto less = [&](Vec3 a, Vec3 b) { return coordinate(axis, a) < coordinate(axis, b); };
    const auto [low, high] =
        std::minmax_element(mesh.positions.begin(), mesh.positions.end(), less);
    const double side = coordinate(axis, *high) - coordinate(axis, *low);
    if (side > most) longest = axis;
    most = std::max(most, side);
  }
  std::vector<double> middles;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 sum = mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]];
    middles.push_back(coordinate(longest, sum));
  }
  std::vector<double> sorted = middles;
  std::sort(sorted.begin(), sorted.end());
  std::vector<Index> group;
  for (const double middle : middles) {
    const auto below = std::lower_bound(sorted.begin(), sorted.end(), middle) - sorted.begin();
    group.push_back(static_cast<Index>(static_cast<std::size_t>(below) * count / sorted.size()));
  }
  std::vector<std::string> names;
  for (std::size_t k = 0; k < count; ++k)
    names.push_back("strip-" + std::to_string(k + 1));
  return split(mesh, group, names);
}

}  // namespace planish
