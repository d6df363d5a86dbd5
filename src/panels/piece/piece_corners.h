#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "panels/piece/panel_mesh.h"

namespace planish {

/// The topology of a piece of a mesh, perhaps with slits: corners of its triangles that belong
/// together, united across sides which are not open. They are the vertices of the piece once it is
/// cut out.
class PieceCorners {
 public:
  /// @param triangles of the piece, increasing
  PieceCorners(const PanelMesh& mesh, const OpenEdges& open, std::span<const Index> triangles);

  /// The vertices at the corners of the piece's k-th triangle.
  const Triangle& corners(std::size_t k) const { return corners_[k]; }
  const std::vector<Triangle>& all_corners() const { return corners_; }
  /// Vertices of the piece.
  std::size_t vertex_count() const { return vertex_of_.size(); }
  /// Which vertex of the mesh it is.
  Index vertex_of(std::size_t vertex) const { return vertex_of_[vertex]; }
  /// Whether an open side, or one at the end of the piece, begins or ends there.
  bool is_border(std::size_t vertex) const { return is_border_[vertex] != 0; }
  /// The vertices along the border curves of the piece, the surface on their left: its own, and
  /// those around its slits.
  const std::vector<std::vector<Index>>& border_loops() const { return loops_; }
  /// Whether a loop goes around a slit: the piece is on both sides of each of its edges.
  bool is_slit(std::size_t loop) const { return is_slit_[loop] != 0; }
  /// How many loops are not all of them border of the mesh.
  std::size_t cut_loops() const { return cut_loops_; }
  /// Whether the piece is in one part a disk, perhaps with holes.
  bool is_planar() const { return !loops_.empty() && is_planar_; }

 private:
  void unite(const PanelMesh& mesh);
  void trace_border(const PanelMesh& mesh, std::span<const Index> place);
  bool is_end(std::size_t k, std::size_t side) const { return across_[k][side] == PanelEdge::none; }

  std::span<const Index> triangles_;
  std::vector<std::array<Index, 3>> across_;  // by triangle and side, numbers of the piece
  std::vector<Triangle> corners_;
  std::vector<Index> vertex_of_;
  std::vector<unsigned char> is_border_;
  std::vector<std::vector<Index>> loops_;
  std::vector<unsigned char> is_slit_;  // by loop
  std::size_t cut_loops_ = 0;
  bool is_planar_ = false;
};

}  // namespace planish
