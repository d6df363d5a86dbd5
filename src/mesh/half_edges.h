#pragma once

#include <cstddef>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// Triangles that can be changed: an oriented manifold as flat arrays of half-edges, three to a
/// triangle in its order, each with the triangle on its left. Changes keep it a manifold of the
/// same topology where the question before them (may_collapse, may_flip) was answered by yes.
class HalfEdges {
 public:
  static constexpr Index none = static_cast<Index>(-1);

  /// Linear time.
  /// @pre an oriented manifold; to change it, every part has a border
  explicit HalfEdges(const TriMesh& mesh);

  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  std::size_t size() const { return from_.size(); }
  Index from(Index h) const { return from_[h]; }
  Index to(Index h) const { return from_[next(h)]; }
  /// The vertex of its triangle that is not on it.
  Index apex(Index h) const { return from_[previous(h)]; }
  /// The other half of its edge; none at the border.
  Index twin(Index h) const { return twin_[h]; }
  /// False for those of triangles that are gone.
  bool is_alive(Index h) const { return from_[h] != none; }

  /// A half-edge from v, at the border the one along it; none for a vertex without triangles.
  Index first(Index v) const { return first_[v]; }
  bool is_used(Index v) const { return first_[v] != none; }
  bool is_border(Index v) const { return is_used(v) && twin_[first_[v]] == none; }
  Index next_on_border(Index v) const { return to(first_[v]); }
  /// The half-edge along the border that ends at the border vertex v.
  Index border_edge_to(Index v) const;

  /// Calls f with each half-edge from v, counter-clockwise.
  template <class F>
  void for_each_corner(Index v, F f) const {
    Index h = first_[v];
    do {
      f(h);
      h = twin_[previous(h)];
    } while (h != none && h != first_[v]);
  }

  /// Calls f with each neighbour of v, counter-clockwise.
  template <class F>
  void for_each_neighbor(Index v, F f) const {
    Index h = first_[v];
    do {
      f(to(h));
      const Index back = previous(h);
      h = twin_[back];
      if (h == none) f(from_[back]);
    } while (h != none && h != first_[v]);
  }

  /// Whether an end of h can be drawn into the other one: the ends of the edge have no neighbours
  /// in common but those of its triangles (link condition), and a border vertex stays on the
  /// border.
  /// @param gone the end that vanishes
  bool may_collapse(Index h, Index gone);
  void collapse(Index h, Index gone);

  /// Whether the edge has two triangles and the other diagonal of them is no edge yet.
  bool may_flip(Index h) const;
  /// Replaces the edge by the other diagonal of its two triangles, which becomes previous(h); h and
  /// its twin become sides of the two.
  void flip(Index h);

 private:
  void pair_twins();
  void glue(Index h, Index g);
  void remove_triangle(Index h);
  void set_first(Index v, Index h);

  std::vector<Index> from_, twin_, first_;
  std::vector<Index> marks_;  // of the last question that a vertex was a neighbour in
  Index question_ = 0;
};

}  // namespace planish
