#pragma once

#include <algorithm>
#include <map>
#include <utility>

#include <planish/mesh/tri_mesh.h>

namespace planish::meshes {

/// Each triangle as four, the middles of sides as vertices; the four are where the one was.
inline TriMesh finer(const TriMesh& mesh) {
  TriMesh result{mesh.positions, {}};
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [found, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)},
                                                     static_cast<Index>(result.positions.size()));
    if (is_new) result.positions.push_back(0.5 * (mesh.positions[a] + mesh.positions[b]));
    return found->second;
  };
  for (const Triangle& t : mesh.triangles) {
    const Index a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
    result.triangles.insert(result.triangles.end(),
                            {{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}});
  }
  return result;
}

inline TriMesh finer(TriMesh mesh, int times) {
  for (int i = 0; i < times; ++i)
    mesh = finer(mesh);
  return mesh;
}

}  // namespace planish::meshes
