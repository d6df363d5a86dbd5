#include <utility>
#include <vector>

#include <planish/mesh/repair.h>

#include "mesh/edge_sides.h"
#include "mesh/repair/repaired.h"
#include "mesh/turning_sets.h"

namespace planish {

OrientedMesh orient_consistently(const TriMesh& mesh) {
  OrientedMesh result{unchanged(mesh)};
  const std::vector<EdgeSide> sides = sorted_sides(mesh);
  const std::size_t count = mesh.triangles.size();
  TurningSets sets(count);
  std::vector<Index> twists;
  for (const EdgeSides& edge : group_by_edge(sides)) {
    if (edge.size() != 2 || edge.begin->low == edge.begin->high) continue;
    const EdgeSide &a = edge.begin[0], &b = edge.begin[1];
    if (!sets.join(a.triangle, b.triangle, a.forward == b.forward ? 1 : 0))
      twists.push_back(a.triangle);
  }
  std::vector<unsigned char> one_sided(count, 0);
  for (const Index t : twists)
    one_sided[sets.first_of(t).number] = 1;
  std::vector<std::size_t> members(count, 0), turned(count, 0);
  for (std::size_t t = 0; t < count; ++t) {
    const auto first = sets.first_of(static_cast<Index>(t));
    ++members[first.number];
    turned[first.number] += first.turned;
  }
  for (std::size_t t = 0; t < count; ++t) {
    const auto first = sets.first_of(static_cast<Index>(t));
    const bool few_turned = 2 * turned[first.number] <= members[first.number];
    if (one_sided[first.number] != 0 || (first.turned != 0) != few_turned) continue;
    std::swap(result.mesh.triangles[t][1], result.mesh.triangles[t][2]);
    ++result.turned;
  }
  return result;
}

TriMesh turned_over(TriMesh mesh) {
  for (Triangle& t : mesh.triangles)
    std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace planish
