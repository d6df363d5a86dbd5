#include "panels/piece/piece_strain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/neumaier_sum.h"
#include "solve/sparse_ldlt.h"
#include "solve/sparse_pattern.h"

namespace planish {

namespace {

/// What the equations of a piece are made of.
struct Equations {
  std::vector<Index> row_of;   // by vertex; none at the border
  std::vector<double> masses;  // by vertex
  Eigen::VectorXd defects;     // by row
};

Equations equations_of(const PanelMesh& mesh, const PieceCorners& corners,
                       std::span<const Index> triangles) {
  Equations made;
  made.row_of.assign(corners.vertex_count(), PanelEdge::none);
  std::vector<std::pair<Index, Index>> inner;  // in order of elimination
  for (Index v = 0; v < corners.vertex_count(); ++v) {
    if (!corners.is_border(v)) inner.emplace_back(mesh.rank(corners.vertex_of(v)), v);
  }
  std::sort(inner.begin(), inner.end());
  for (Index row = 0; row < inner.size(); ++row)
    made.row_of[inner[row].second] = row;
  made.masses.assign(corners.vertex_count(), 0.0);
  made.defects =
      Eigen::VectorXd::Constant(static_cast<Eigen::Index>(inner.size()), 2.0 * std::numbers::pi);
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index v = corners.corners(k)[i];
      made.masses[v] += mesh.area(triangles[k]) / 3.0;
      if (made.row_of[v] != PanelEdge::none)
        made.defects[made.row_of[v]] -= mesh.angles(triangles[k])[i];
    }
  }
  return made;
}

/// M^-1/2 K^T.
SparseMatrix weighed_stiffness(const PanelMesh& mesh, const PieceCorners& corners,
                               std::span<const Index> triangles, const Equations& equations) {
  std::vector<double> roots;
  for (const double mass : equations.masses)
    roots.push_back(mass > 0.0 ? 1.0 / std::sqrt(mass) : 0.0);
  return sparse_matrix(corners.vertex_count(), static_cast<std::size_t>(equations.defects.size()),
                       [&](const auto& add) {
                         for (std::size_t k = 0; k < triangles.size(); ++k) {
                           for (std::size_t i = 0; i < 3; ++i) {
                             const double weight = 0.5 * mesh.cotangents(triangles[k])[i];
                             const Index a = corners.corners(k)[(i + 1) % 3],
                                         b = corners.corners(k)[(i + 2) % 3];
                             for (const auto& [v, w] : {std::pair{a, b}, std::pair{b, a}}) {
                               const Index row = equations.row_of[v];
                               if (row == PanelEdge::none) continue;
                               add(v, row, weight * roots[v]);
                               add(w, row, -weight * roots[w]);
                             }
                           }
                         }
                       });
}

}  // namespace

double PanelPiece::strain() const {
  return area > 0.0 ? std::sqrt(energy / area) : 0.0;
}

std::optional<PiecePotential> piece_potential(const PanelMesh& mesh, const PieceCorners& corners,
                                              std::span<const Index> triangles) {
  const Equations equations = equations_of(mesh, corners, triangles);
  PiecePotential found;
  found.phi.assign(corners.vertex_count(), 0.0);
  if (equations.defects.size() == 0) return found;
  const SparseMatrix stiffness = weighed_stiffness(mesh, corners, triangles, equations);
  const SparseMatrix square = SparseMatrix(stiffness.transpose()) * stiffness;
  const SparseMatrix lower = square.triangularView<Eigen::Lower>();
  ThreadPool alone(1);
  SparseLdlt factor(lower);
  if (!factor.factor(lower, alone)) return std::nullopt;
  const Eigen::VectorXd x = factor.solve(equations.defects);
  NeumaierSum sum;
  for (Eigen::Index row = 0; row < x.size(); ++row)
    sum.add(equations.defects[row] * x[row]);
  found.energy = 3.0 / 8.0 * sum.value();
  const Eigen::VectorXd phi = stiffness * x;
  for (std::size_t v = 0; v < found.phi.size(); ++v) {
    if (equations.masses[v] > 0.0)
      found.phi[v] = phi[static_cast<Eigen::Index>(v)] / std::sqrt(equations.masses[v]);
  }
  return found;
}

PanelPiece measured_piece(const PanelMesh& mesh, const OpenEdges& open,
                          std::vector<Index> triangles, std::size_t most_loops) {
  const PieceCorners corners(mesh, open, triangles);
  PanelPiece piece;
  NeumaierSum area;
  for (const Index t : triangles)
    area.add(mesh.area(t));
  piece.area = area.value();
  piece.loops = corners.loops();
  piece.cut_loops = corners.cut_loops();
  piece.is_planar = corners.is_planar();
  piece.energy = std::numeric_limits<double>::infinity();
  if (piece.is_planar && piece.loops <= most_loops) {
    if (const auto potential = piece_potential(mesh, corners, triangles))
      piece.energy = potential->energy;
  }
  piece.triangles = std::move(triangles);
  return piece;
}

}  // namespace planish
