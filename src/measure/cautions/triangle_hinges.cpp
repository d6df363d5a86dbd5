#include "measure/cautions/triangle_hinges.h"

#include <algorithm>
#include <cstddef>

#include "measure/bends.h"
#include "measure/normals.h"

namespace planish {

namespace {

/// Which of its sides begins there.
std::size_t side_from(const Triangle& t, Index from) {
  return from == t[0] ? 0 : from == t[1] ? 1 : 2;
}

/// Where the triangles of each vertex begin in a list of all, vertex by vertex.
struct TrianglesOfVertices {
  explicit TrianglesOfVertices(const Patch& patch) : start(patch.vertex_count() + 1, 0) {
    for (const Triangle& t : patch.triangles()) {
      for (const Index v : t)
        ++start[v + 1];
    }
    for (std::size_t v = 1; v < start.size(); ++v)
      start[v] += start[v - 1];
    list.resize(start.back());
    std::vector<std::size_t> next(start.begin(), start.end() - 1);
    for (Index t = 0; t < patch.triangles().size(); ++t) {
      for (const Index v : patch.triangles()[t])
        list[next[v]++] = t;
    }
  }

  /// The triangle with the side from `from` to `to`.
  Index with_side(const Patch& patch, Index from, Index to) const {
    for (std::size_t i = start[from]; i < start[from + 1]; ++i) {
      const Triangle& t = patch.triangles()[list[i]];
      if (t[(side_from(t, from) + 1) % 3] == to) return list[i];
    }
    return TriangleHinge::none;
  }

  std::vector<std::size_t> start;
  std::vector<Index> list;
};

}  // namespace

std::vector<TriangleHinges> triangle_hinges(const Patch& patch) {
  const TrianglesOfVertices triangles(patch);
  std::vector<TriangleHinges> sides(patch.triangles().size());
  for_each_bend(patch.positions(), patch.connectivity(), patch.unit_scale(),
                [&](const Hinge& hinge, const Bend& bend) {
                  const Index left = triangles.with_side(patch, hinge.from, hinge.to),
                              right = triangles.with_side(patch, hinge.to, hinge.from);
                  sides[left][side_from(patch.triangles()[left], hinge.from)] = {right, bend.angle,
                                                                                 bend.length};
                  sides[right][side_from(patch.triangles()[right], hinge.to)] = {left, bend.angle,
                                                                                 bend.length};
                });
  return sides;
}

std::vector<double> triangle_areas(const Patch& patch) {
  std::vector<double> areas;
  areas.reserve(patch.triangles().size());
  for (const Triangle& t : patch.triangles())
    areas.push_back(0.5 * norm(triangle_normal(t, patch.positions(), patch.unit_scale())));
  return areas;
}

}  // namespace planish
