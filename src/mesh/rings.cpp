#include "mesh/rings.h"

#include <algorithm>
#include <cstdint>

namespace planish {

namespace {

/// The two other vertices of a triangle at one of its corners, counter-clockwise.
struct Wedge {
  Index from, to;
};

/// The wedges around every vertex, in the order of the triangles.
struct Wedges {
  std::vector<std::size_t> start;
  std::vector<Wedge> all;
};

bool valid(const Triangle& t, std::size_t vertex_count) {
  return t[0] < vertex_count && t[1] < vertex_count && t[2] < vertex_count && t[0] != t[1] &&
         t[1] != t[2] && t[2] != t[0];
}

std::optional<Wedges> gather_wedges(const TriMesh& mesh) {
  const std::size_t n = mesh.positions.size();
  Wedges wedges;
  wedges.start.assign(n + 2, 0);
  // Counted one place late and filled through the next start, so that no second array is needed.
  for (const Triangle& t : mesh.triangles) {
    if (!valid(t, n)) return std::nullopt;
    for (const Index v : t)
      ++wedges.start[v + 2];
  }
  for (std::size_t v = 2; v < wedges.start.size(); ++v)
    wedges.start[v] += wedges.start[v - 1];
  wedges.all.resize(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      wedges.all[wedges.start[t[k] + 1]++] = {t[(k + 1) % 3], t[(k + 2) % 3]};
    }
  }
  wedges.start.pop_back();
  return wedges;
}

/// Chains the wedges of one vertex after another.
class RingWalker {
 public:
  explicit RingWalker(std::size_t vertex_count) : marks_(vertex_count) {}

  /// Appends the ring of v to rings; false where its wedges are not one fan.
  bool append(Index v, const Wedge* begin, const Wedge* end, Rings& rings) {
    const Index stamp = v + 1;
    for (const Wedge* w = begin; w != end; ++w) {
      Mark& from = marks_[w->from];
      if (from.leaves == stamp) return false;  // two triangles on one side of an edge
      from.leaves = stamp;
      from.next = w->to;
      Mark& to = marks_[w->to];
      if (to.arrives == stamp) return false;
      to.arrives = stamp;
    }
    Index first = begin->from;
    std::size_t open_ends = 0;
    for (const Wedge* w = begin; w != end; ++w) {
      if (marks_[w->from].arrives == stamp) continue;
      first = w->from;
      ++open_ends;
    }
    if (open_ends > 1) return false;
    const auto count = static_cast<std::size_t>(end - begin);
    const bool closed = open_ends == 0;
    if (closed && count < 3) return false;
    Index at = first;
    std::size_t steps = 0;
    do {
      rings.vertices.push_back(at);
      at = marks_[at].next;
      ++steps;
    } while (at != first && marks_[at].leaves == stamp && steps <= count);
    if (!closed) rings.vertices.push_back(at);
    rings.border[v] = closed ? 0 : 1;
    return steps == count;
  }

 private:
  struct Mark {
    Index leaves = 0, arrives = 0;  // the last vertex, plus 1, that had a wedge from or to here
    Index next = 0;
  };
  std::vector<Mark> marks_;
};

}  // namespace

std::optional<Rings> build_rings(const TriMesh& mesh) {
  const std::size_t n = mesh.positions.size();
  const auto wedges = gather_wedges(mesh);
  if (!wedges) return std::nullopt;
  Rings rings;
  rings.start.reserve(n + 1);
  rings.border.resize(n, 0);
  rings.vertices.reserve(wedges->all.size() + n / 8);
  RingWalker walker(n);
  for (std::size_t v = 0; v < n; ++v) {
    rings.start.push_back(rings.vertices.size());
    const Wedge* begin = wedges->all.data() + wedges->start[v];
    const Wedge* end = wedges->all.data() + wedges->start[v + 1];
    if (begin != end && !walker.append(static_cast<Index>(v), begin, end, rings)) {
      return std::nullopt;
    }
  }
  rings.start.push_back(rings.vertices.size());
  return rings;
}

}  // namespace planish
