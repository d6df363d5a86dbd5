#include "mesh/half_edges.h"

#include <algorithm>

namespace planish {

HalfEdges::HalfEdges(const TriMesh& mesh) {
  const std::size_t n = mesh.positions.size();
  from_.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
    from_.insert(from_.end(), t.begin(), t.end());
  first_.assign(n, none);
  marks_.assign(n, 0);
  pair_twins();
  for (std::size_t h = 0; h < from_.size(); ++h) {
    const auto half = static_cast<Index>(h);
    if (first_[from_[h]] == none || twin_[h] == none) first_[from_[h]] = half;
  }
}

/// Sorts all half-edges by their smaller end and those at each by the other one, so that thousands
/// may share a vertex.
void HalfEdges::pair_twins() {
  const auto lower = [&](Index h) { return from(h) < to(h) ? from(h) : to(h); };
  twin_.assign(from_.size(), none);
  std::vector<std::size_t> start(first_.size() + 1, 0);
  for (Index h = 0; h < from_.size(); ++h)
    ++start[lower(h) + 1];
  for (std::size_t v = 1; v < start.size(); ++v)
    start[v] += start[v - 1];
  std::vector<Index> sorted(from_.size());
  std::vector<std::size_t> end(start.begin(), start.end() - 1);
  for (Index h = 0; h < from_.size(); ++h)
    sorted[end[lower(h)]++] = h;
  const auto sum = [&](Index h) { return std::size_t{from(h)} + to(h); };
  for (std::size_t v = 0; v < end.size(); ++v) {
    const auto at = [&](std::size_t i) { return sorted.begin() + static_cast<std::ptrdiff_t>(i); };
    std::sort(at(start[v]), at(end[v]), [&](Index a, Index b) { return sum(a) < sum(b); });
    for (std::size_t i = start[v] + 1; i < end[v]; ++i) {
      if (sum(sorted[i - 1]) == sum(sorted[i])) glue(sorted[i - 1], sorted[i]);
    }
  }
}

void HalfEdges::glue(Index h, Index g) {
  if (h != none) twin_[h] = g;
  if (g != none) twin_[g] = h;
}

Index HalfEdges::border_edge_to(Index v) const {
  Index h = previous(first_[v]);
  while (twin_[h] != none)
    h = previous(twin_[h]);
  return h;
}

bool HalfEdges::may_collapse(Index h, Index gone) {
  const Index stays = from(h) == gone ? to(h) : from(h);
  const bool along_border = twin_[h] == none;
  if (is_border(gone) && !along_border) return false;
  // What is left of a loop of three would have two edges.
  if (along_border && twin_[next(h)] == none && twin_[previous(h)] == none) return false;
  ++question_;
  for_each_neighbor(gone, [&](Index v) { marks_[v] = question_; });
  int shared = 0;
  for_each_neighbor(stays, [&](Index v) { shared += marks_[v] == question_ ? 1 : 0; });
  return shared == (along_border ? 1 : 2);
}

/// Takes the triangle of h out and closes the gap between its other two sides.
void HalfEdges::remove_triangle(Index h) {
  glue(twin_[next(h)], twin_[previous(h)]);
  from_[h] = from_[next(h)] = from_[previous(h)] = none;
}

void HalfEdges::collapse(Index h, Index gone) {
  const Index stays = from(h) == gone ? to(h) : from(h);
  Index corner = first_[gone];
  do {
    from_[corner] = stays;
    corner = twin_[previous(corner)];
  } while (corner != none && corner != first_[gone]);
  first_[gone] = none;
  for (const Index side : {h, twin_[h]}) {
    if (side == none) continue;
    const Index after = twin_[next(side)], before = twin_[previous(side)];
    remove_triangle(side);
    const Index left = after != none ? after : before;
    set_first(from(left), left);
    set_first(to(left), next(left));
  }
}

/// Keeps h, or what is on the border before it.
void HalfEdges::set_first(Index v, Index h) {
  const Index start = h;
  while (twin_[h] != none) {
    h = next(twin_[h]);
    if (h == start) break;
  }
  first_[v] = h;
}

bool HalfEdges::may_flip(Index h) const {
  if (twin_[h] == none) return false;
  const Index c = apex(h), d = apex(twin_[h]);
  bool joined = false;
  for_each_neighbor(c, [&](Index v) { joined = joined || v == d; });
  return !joined;
}

void HalfEdges::flip(Index h) {
  // a -> b with c on its left and d on its right becomes d -> c.
  const Index g = twin_[h];
  const Index h_next = next(h), h_previous = previous(h);
  const Index g_next = next(g), g_previous = previous(g);
  const Index a = from_[h], b = from_[g], c = from_[h_previous], d = from_[g_previous];
  const Index outside_db = twin_[g_previous], outside_ca = twin_[h_previous];
  from_[h] = d;  // triangles d, b, c and c, a, d
  from_[g] = c;
  glue(h, outside_db);
  glue(g, outside_ca);
  glue(h_previous, g_previous);
  if (first_[a] == h) first_[a] = g_next;
  if (first_[b] == g) first_[b] = h_next;
  if (first_[c] == h_previous) first_[c] = g;
  if (first_[d] == g_previous) first_[d] = h;
}

}  // namespace planish
