#include "mesh/split.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <planish/core/error.h>

#include "mesh/disjoint_sets.h"

namespace planish {

namespace {

void check_indices(const TriMesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const Index v : mesh.triangles[t]) {
      if (v < mesh.positions.size()) continue;
      throw Error(ErrorCode::index_out_of_range,
                  "triangle " + std::to_string(t) + " names vertex " + std::to_string(v) +
                      " but there are " + std::to_string(mesh.positions.size()),
                  {.path = {}, .first = t, .count = 1});
    }
  }
}

using TriangleSets = DisjointSets<Index>;

/// Triangles of one group that share an edge are in one set.
TriangleSets joined_by_edges(const TriMesh& mesh, std::span<const Index> of_triangle) {
  struct GroupSide {
    std::array<Index, 3> key;  // group, ends
    Index triangle;
  };
  std::vector<GroupSide> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
      sides.push_back({{of_triangle[t], low, high}, static_cast<Index>(t)});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const GroupSide& a, const GroupSide& b) { return a.key < b.key; });
  TriangleSets sets(mesh.triangles.size());
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i].key == sides[i - 1].key) sets.join(sides[i - 1].triangle, sides[i].triangle);
  }
  return sets;
}

NamedPatch patch_of(const TriMesh& mesh, const std::vector<Index>& triangles, std::string name,
                    std::vector<Index>& number) {
  NamedPatch patch;
  patch.name = std::move(name);
  patch.vertices.reserve(3 * triangles.size());
  for (const Index t : triangles)
    patch.vertices.insert(patch.vertices.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
  std::sort(patch.vertices.begin(), patch.vertices.end());
  patch.vertices.erase(std::unique(patch.vertices.begin(), patch.vertices.end()),
                       patch.vertices.end());
  patch.vertices.shrink_to_fit();
  patch.mesh.positions.reserve(patch.vertices.size());
  for (std::size_t v = 0; v < patch.vertices.size(); ++v) {
    number[patch.vertices[v]] = static_cast<Index>(v);
    patch.mesh.positions.push_back(mesh.positions[patch.vertices[v]]);
  }
  patch.mesh.triangles.reserve(triangles.size());
  for (const Index t : triangles) {
    const Triangle& tri = mesh.triangles[t];
    patch.mesh.triangles.push_back({number[tri[0]], number[tri[1]], number[tri[2]]});
  }
  return patch;
}

}  // namespace

std::vector<NamedPatch> split(const TriMesh& mesh, std::span<const Index> of_triangle,
                              std::span<const std::string> names) {
  check_indices(mesh);
  TriangleSets sets = joined_by_edges(mesh, of_triangle);
  std::vector<std::vector<std::vector<Index>>> pieces(names.size());  // of each group: triangles
  std::vector<Index> piece_of(mesh.triangles.size(), 0);              // of the first of each set
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto t = static_cast<Index>(i);
    auto& group = pieces[of_triangle[t]];
    const Index first = sets.first_of(t);
    if (first == t) {
      piece_of[t] = static_cast<Index>(group.size());
      group.emplace_back();
    }
    group[piece_of[first]].push_back(t);
  }
  std::vector<NamedPatch> patches;
  std::vector<Index> number(mesh.positions.size(), 0);
  for (std::size_t g = 0; g < names.size(); ++g) {
    for (std::size_t k = 0; k < pieces[g].size(); ++k) {
      std::string name = names[g];
      if (pieces[g].size() > 1) name += "-" + std::to_string(k + 1);
      patches.push_back(patch_of(mesh, pieces[g][k], std::move(name), number));
    }
  }
  return patches;
}

std::vector<NamedPatch> split(const TriMesh& mesh, const std::string& name) {
  const std::vector<Index> same(mesh.triangles.size(), 0);
  return split(mesh, same, std::span(&name, 1));
}

}  // namespace planish
