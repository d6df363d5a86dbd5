#include "mesh/split.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>

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

/// Triangles that share an edge are in one set.
TriangleSets joined_by_edges(const TriMesh& mesh) {
  struct Side {
    std::array<Index, 2> ends;
    Index triangle;
  };
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
      sides.push_back({{low, high}, static_cast<Index>(t)});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.ends < b.ends; });
  TriangleSets sets(mesh.triangles.size());
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i].ends == sides[i - 1].ends) sets.join(sides[i - 1].triangle, sides[i].triangle);
  }
  return sets;
}

/// Of each triangle the number of its connected part, in the order of their first triangles.
std::vector<Index> connected_parts(const TriMesh& mesh) {
  TriangleSets sets = joined_by_edges(mesh);
  std::vector<Index> part_of(mesh.triangles.size(), 0);
  Index count = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto t = static_cast<Index>(i);
    const Index first = sets.first_of(t);
    part_of[t] = first == t ? count++ : part_of[first];
  }
  return part_of;
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
  std::vector<std::vector<Index>> triangles(names.size());  // of each patch
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    triangles[of_triangle[t]].push_back(static_cast<Index>(t));
  std::vector<NamedPatch> patches;
  patches.reserve(names.size());
  std::vector<Index> number(mesh.positions.size(), 0);
  for (std::size_t p = 0; p < names.size(); ++p)
    patches.push_back(patch_of(mesh, triangles[p], names[p], number));
  return patches;
}

std::vector<std::string> numbered_names(const std::string& name, std::size_t count) {
  if (count == 1) return {name};
  std::vector<std::string> names;
  names.reserve(count);
  for (std::size_t k = 1; k <= count; ++k)
    names.push_back(name + "-" + std::to_string(k));
  return names;
}

namespace {

std::string in_small_letters(std::string name) {
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return name;
}

}  // namespace

std::vector<std::string> distinct_names(std::span<const std::string> names) {
  std::set<std::string> taken;
  std::map<std::string, int> next;  // number to try, where names are alike: many may be
  std::vector<std::string> result;
  result.reserve(names.size());
  for (const std::string& name : names) {
    std::string given = name;
    int& k = next.try_emplace(in_small_letters(name), 2).first->second;
    while (!taken.insert(in_small_letters(given)).second)
      given = name + "-" + std::to_string(k++);
    result.push_back(std::move(given));
  }
  return result;
}

std::vector<NamedPatch> split(const TriMesh& mesh, const std::string& name) {
  check_indices(mesh);
  const std::vector<Index> part_of = connected_parts(mesh);
  const std::size_t count =
      part_of.empty() ? 0 : std::size_t{*std::max_element(part_of.begin(), part_of.end())} + 1;
  return split(mesh, part_of, numbered_names(name, count));
}

}  // namespace planish
