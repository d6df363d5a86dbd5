#include "mesh/repair/repaired.h"

#include <numeric>

#include <planish/core/error.h>

#include "mesh/inspect_manifold.h"

namespace planish {

void require_entries(const TriMesh& mesh) {
  if (mesh.triangles.empty()) return;
  const Inspection entries = inspect_entries(mesh);
  if (entries.problems.empty()) return;
  const Problem& problem = entries.problems.front();
  throw Error(problem.code, problem.message,
              {.path = {}, .first = problem.first, .count = problem.count});
}

RepairedMesh unchanged(const TriMesh& mesh) {
  require_entries(mesh);
  RepairedMesh same{mesh, std::vector<Index>(mesh.triangles.size()),
                    std::vector<Index>(mesh.positions.size())};
  std::iota(same.source.begin(), same.source.end(), Index{0});
  std::iota(same.vertex_source.begin(), same.vertex_source.end(), Index{0});
  return same;
}

RepairedMesh without_triangles(const TriMesh& mesh, std::span<const Index> triangles) {
  RepairedMesh result = unchanged(mesh);
  result.mesh.triangles.clear();
  result.source.clear();
  auto next = triangles.begin();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (next != triangles.end() && *next == t) {
      ++next;
      continue;
    }
    result.mesh.triangles.push_back(mesh.triangles[t]);
    result.source.push_back(static_cast<Index>(t));
  }
  return result;
}

}  // namespace planish
