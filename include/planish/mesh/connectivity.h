#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// Who neighbours whom in a manifold, consistently oriented triangle mesh: immutable, built once,
/// as compressed rows. Methods move vertices and never change it.
class Connectivity {
 public:
  /// Takes time and memory linear in the size of the mesh.
  /// @throws Error with the code of the first problem that inspect() finds and that blocks
  ///   measuring: an index out of range, a repeated index, a duplicate triangle, an edge or vertex
  ///   that is not manifold, triangles of clashing orientation.
  explicit Connectivity(const TriMesh& mesh);

  std::size_t vertex_count() const { return ring_start_.size() - 1; }

  /// The one-ring of v, counter-clockwise. Inner vertex: closed, v with ring[j] and ring[j + 1]
  /// (cyclic) is a triangle. Border vertex: open, from the next to the previous border vertex.
  /// Unused vertex: empty.
  std::span<const Index> ring(Index v) const {
    return {rings_.data() + ring_start_[v], ring_start_[v + 1] - ring_start_[v]};
  }

  bool is_border(Index v) const { return border_[v] != 0; }
  /// Used by a triangle and not on the border: only these vertices are measured and moved.
  bool is_inner(Index v) const { return border_[v] == 0 && ring_start_[v + 1] != ring_start_[v]; }

  /// In increasing order.
  std::span<const Index> inner_vertices() const { return inner_; }

  /// Each closed curve of the border, the patch on its left, beginning at its smallest vertex;
  /// loops in the order of these.
  const std::vector<std::vector<Index>>& border_loops() const { return loops_; }

 private:
  std::vector<std::size_t> ring_start_;  // vertex_count + 1
  std::vector<Index> rings_;
  std::vector<unsigned char> border_;
  std::vector<Index> inner_;
  std::vector<std::vector<Index>> loops_;
};

}  // namespace planish
