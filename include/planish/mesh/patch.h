#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <planish/mesh/inspect.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// An edge with the triangles on its sides: from, to, left and to, from, right.
struct Edge {
  /// In `left` and `right`: no triangle there.
  static constexpr Index none = static_cast<Index>(-1);

  Index from, to;     ///< from < to
  Index left, right;  ///< the third corners of the triangles; none where there is no triangle

  /// Whether it has one triangle only.
  bool is_border() const { return left == none || right == none; }
};

/// The topology of a patch: the neighbours of every vertex in a manifold, consistently oriented
/// triangle mesh, as compressed rows. Immutable; a Patch builds it once.
class Connectivity {
 public:
  /// Of no vertices.
  Connectivity() = default;

  /// In linear time and memory. Nothing where the triangles are not a manifold of one orientation,
  /// name a vertex twice, or one that does not exist.
  static std::optional<Connectivity> build(const TriMesh& mesh);

  /// Of the mesh, unused vertices too.
  std::size_t vertex_count() const { return ring_start_.size() - 1; }

  /// The one-ring of v, counter-clockwise. Inner vertex: closed, v with ring[j] and ring[j + 1]
  /// (cyclic) is a triangle. Border vertex: open, from the next to the previous border vertex.
  /// Unused vertex: empty.
  std::span<const Index> ring(Index v) const {
    return {rings_.data() + ring_start_[v], ring_start_[v + 1] - ring_start_[v]};
  }

  /// At the end of an edge that only one triangle has.
  bool is_border(Index v) const { return border_[v] != 0; }
  /// Used by a triangle and not on the border: only these vertices are measured and moved.
  bool is_inner(Index v) const { return border_[v] == 0 && ring_start_[v + 1] != ring_start_[v]; }

  /// In increasing order.
  std::span<const Index> inner_vertices() const { return inner_; }

  /// Each closed curve of the border, the patch on its left, beginning at its smallest vertex;
  /// loops in the order of these.
  const std::vector<std::vector<Index>>& border_loops() const { return loops_; }

 private:
  std::vector<std::size_t> ring_start_ = {0};  // vertex_count + 1
  std::vector<Index> rings_;
  std::vector<unsigned char> border_;
  std::vector<Index> inner_;
  std::vector<std::vector<Index>> loops_;
};

/// A triangle mesh that is an oriented manifold, with its topology and what inspect() finds in it.
/// Immutable: copies share all of it and are cheap, patches made by with_positions() share the
/// topology.
class Patch {
 public:
  /// Of no vertices.
  Patch();

  /// Takes time and memory linear in the size of the mesh.
  /// @throws Error with the code of the first problem that inspect() finds and that leaves no
  ///   manifold: an index out of range, a repeated index, a duplicate triangle, an edge or vertex
  ///   that is not manifold, triangles of clashing orientation. Other problems are in inspection().
  explicit Patch(TriMesh mesh);

  /// The same triangles over other positions. Topology is shared; inspection() is of the new ones.
  /// @param positions one per vertex, model units
  Patch with_positions(std::vector<Vec3> positions) const;

  /// Positions and triangles.
  const TriMesh& mesh() const { return *mesh_; }
  /// In model units.
  const std::vector<Vec3>& positions() const { return mesh_->positions; }
  /// In the order of the mesh.
  const std::vector<Triangle>& triangles() const { return mesh_->triangles; }
  /// Shared by all patches that with_positions() makes.
  const Connectivity& connectivity() const { return *connectivity_; }
  /// As inspect() gives it.
  const Inspection& inspection() const { return inspection_; }
  /// As unit_scale() of the mesh gives it.
  double unit_scale() const { return unit_scale_; }

  /// Unused vertices too.
  std::size_t vertex_count() const { return mesh_->positions.size(); }
  /// As Connectivity::ring().
  std::span<const Index> ring(Index v) const { return connectivity_->ring(v); }
  /// As Connectivity::is_border().
  bool is_border(Index v) const { return connectivity_->is_border(v); }
  /// As Connectivity::is_inner().
  bool is_inner(Index v) const { return connectivity_->is_inner(v); }
  /// As Connectivity::inner_vertices().
  std::span<const Index> inner_vertices() const { return connectivity_->inner_vertices(); }
  /// As Connectivity::border_loops().
  const std::vector<std::vector<Index>>& border_loops() const {
    return connectivity_->border_loops();
  }
  /// Every edge once, by `from` and then in the order of its ring. O(n).
  std::vector<Edge> edges() const;

 private:
  Patch(const Patch& other, std::vector<Vec3> positions);

  std::shared_ptr<const TriMesh> mesh_;
  std::shared_ptr<const Connectivity> connectivity_;
  Inspection inspection_;
  double unit_scale_ = 1.0;
};

}  // namespace planish
