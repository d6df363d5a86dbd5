#include "sheet/piece/outlines.h"

#include <algorithm>
#include <cstddef>

namespace planish {

namespace {

HalfEdge next_in_triangle(HalfEdge h) {
  return h % 3 == 2 ? h - 2 : h + 1;
}

Index start_of(const TriMesh& mesh, HalfEdge h) {
  return mesh.triangles[h / 3][h % 3];
}

Index end_of(const TriMesh& mesh, HalfEdge h) {
  return start_of(mesh, next_in_triangle(h));
}

// Which half-edges leave each vertex, as compressed rows.
struct Leaving {
  std::vector<std::size_t> row_start;
  std::vector<HalfEdge> half_edges;
};

Leaving leaving_half_edges(const TriMesh& mesh) {
  Leaving leaving;
  leaving.row_start.assign(mesh.positions.size() + 1, 0);
  for (const Triangle& triangle : mesh.triangles) {
    for (const Index v : triangle)
      ++leaving.row_start[v + 1];
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    leaving.row_start[v + 1] += leaving.row_start[v];
  }
  std::vector<std::size_t> place(leaving.row_start.begin(), leaving.row_start.end() - 1);
  leaving.half_edges.resize(3 * mesh.triangles.size());
  for (HalfEdge h = 0; h < leaving.half_edges.size(); ++h) {
    leaving.half_edges[place[start_of(mesh, h)]++] = h;
  }
  // By end, so that finding one takes few steps also where thousands of triangles share a vertex.
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    std::sort(leaving.half_edges.begin() + leaving.row_start[v],
              leaving.half_edges.begin() + leaving.row_start[v + 1], [&](HalfEdge a, HalfEdge b) {
                const Index end_a = end_of(mesh, a), end_b = end_of(mesh, b);
                return end_a < end_b || (end_a == end_b && a < b);
              });
  }
  return leaving;
}

}  // namespace

std::vector<HalfEdge> opposite_half_edges(const TriMesh& mesh) {
  const Leaving leaving = leaving_half_edges(mesh);
  std::vector<HalfEdge> opposite(leaving.half_edges.size(), k_no_half_edge);
  for (HalfEdge h = 0; h < opposite.size(); ++h) {
    const Index from = end_of(mesh, h), to = start_of(mesh, h);
    const auto begin = leaving.half_edges.begin() + leaving.row_start[from];
    const auto end = leaving.half_edges.begin() + leaving.row_start[from + 1];
    const auto found = std::lower_bound(
        begin, end, to, [&](HalfEdge other, Index v) { return end_of(mesh, other) < v; });
    if (found != end && end_of(mesh, *found) == to) opposite[h] = *found;
  }
  return opposite;
}

std::vector<std::vector<Index>> outlines(const TriMesh& mesh, std::span<const HalfEdge> opposite,
                                         const std::function<bool(std::size_t)>& in_part) {
  const auto is_inside = [&](HalfEdge h) { return h != k_no_half_edge && in_part(h / 3); };
  std::vector<bool> done(opposite.size(), false);
  std::vector<std::vector<Index>> loops;
  for (HalfEdge first = 0; first < opposite.size(); ++first) {
    if (done[first] || !is_inside(first) || is_inside(opposite[first])) continue;
    std::vector<Index> loop;
    for (HalfEdge h = first; !done[h];) {
      done[h] = true;
      loop.push_back(start_of(mesh, h));
      // Turn about the end of h through the triangles of the part until one ends it.
      h = next_in_triangle(h);
      while (is_inside(opposite[h]))
        h = next_in_triangle(opposite[h]);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace planish
