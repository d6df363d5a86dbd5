#pragma once

#include <optional>
#include <span>
#include <vector>

#include "panels/piece/panel_mesh.h"
#include "panels/piece/piece_corners.h"

namespace planish {

/// A piece of a mesh, perhaps with slits, and how much its pattern strains.
struct PanelPiece {
  std::vector<Index> triangles;  ///< increasing
  double area = 0.0;             ///< of that of the mesh
  /// The rms strain of the edges, squared, times the area; infinite where it has no pattern.
  double energy = 0.0;
  std::size_t cut_loops = 0;  ///< those that are not all of them border of the mesh
  bool is_planar = false;     ///< a disk, perhaps with holes

  /// Of its edges, rms by area.
  double strain() const;
};

/// The strain potential of a piece in the pattern of least stretch with a free border
/// (docs/panels.md): phi = M^-1 K^T x with K M^-1 K^T x = d, K the cotangent rows of its inner
/// vertices and three rows of each hole, so that it closes in the pattern, M the areas of all
/// vertices, d the angle defects and what HoleLayout::defects() gives.
struct PiecePotential {
  double energy = 0.0;      ///< 3/8 d . x
  std::vector<double> phi;  ///< by vertex of the piece
};

/// Nothing where the system cannot be solved, where the piece is a tube, and where a slit does not
/// reach its outline.
std::optional<PiecePotential> piece_potential(const PanelMesh& mesh, const PieceCorners& corners,
                                              std::span<const Index> triangles);

/// Measures a piece.
/// @param triangles increasing
/// @param most_cut_loops a piece with more of them counts as one without a pattern
PanelPiece measured_piece(const PanelMesh& mesh, const OpenEdges& open,
                          std::vector<Index> triangles,
                          std::size_t most_cut_loops = static_cast<std::size_t>(-1));

}  // namespace planish
