#include "panels/piece/piece_strain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/neumaier_sum.h"
#include "energy/hole_closing.h"
#include "mesh/border_loops.h"
#include "solve/gram_matrix.h"
#include "solve/sparse_ldlt.h"

namespace planish {

namespace {

/// A hole of a piece, whose three equations begin at a row.
struct Hole {
  const std::vector<Index>* loop = nullptr;
  Index row = 0;
  HoleLayout::Polygon polygon;
};

/// Where a vertex is on the border of a hole.
struct PlaceAtHole {
  Index hole = PanelEdge::none, corner = 0;
};

/// What the equations of a piece are made of: those of its inner vertices, then those of its holes.
struct Equations {
  std::vector<Index> row_of;   // by vertex; none at the border
  std::vector<double> masses;  // by vertex
  std::vector<Hole> holes;
  std::vector<PlaceAtHole> at_hole;  // by vertex
  Eigen::VectorXd defects;           // by row
  std::size_t vertex_rows = 0;
};

/// Rows in the order of elimination.
void number_rows(const PanelMesh& mesh, const PieceCorners& corners, Equations& made) {
  made.row_of.assign(corners.vertex_count(), PanelEdge::none);
  std::vector<std::pair<Index, Index>> inner;
  for (Index v = 0; v < corners.vertex_count(); ++v) {
    if (!corners.is_border(v)) inner.emplace_back(mesh.rank(corners.vertex_of(v)), v);
  }
  std::sort(inner.begin(), inner.end());
  for (Index row = 0; row < inner.size(); ++row)
    made.row_of[inner[row].second] = row;
  made.vertex_rows = inner.size();
}

/// Those of the border's loops that are holes, with their defects; false where the piece is a tube,
/// and where a slit does not reach its outline, as unfold() takes neither.
/// @param angles of all triangles, by vertex
bool take_holes(const PanelMesh& mesh, const PieceCorners& corners, std::span<const double> angles,
                Equations& made) {
  const auto& loops = corners.border_loops();
  const std::vector<Vec3>& places = mesh.patch().positions();
  std::vector<double> turnings;
  std::vector<CurveSize> sizes;
  for (const std::vector<Index>& loop : loops) {
    std::vector<Index> on_mesh;
    double turning = 0.0;
    for (const Index v : loop) {
      on_mesh.push_back(corners.vertex_of(v));
      turning += std::numbers::pi - angles[v];
    }
    turnings.push_back(turning);
    sizes.push_back(size_of_loop(places, on_mesh, mesh.scale()));
  }
  const BorderKinds kinds = border_kinds(turnings, sizes);
  if (!kinds.tube_ends.empty()) return false;
  made.at_hole.resize(corners.vertex_count());
  made.defects.conservativeResize(
      static_cast<Eigen::Index>(made.vertex_rows + 3 * (loops.size() - 1)));
  for (std::size_t l = 0; l < loops.size(); ++l) {
    if (l == kinds.outline) continue;
    if (corners.is_slit(l)) return false;
    std::vector<double> lengths, angles_there;
    for (std::size_t b = 0; b < loops[l].size(); ++b) {
      const Index v = loops[l][b], w = loops[l][b + 1 < loops[l].size() ? b + 1 : 0];
      made.at_hole[v] = {static_cast<Index>(made.holes.size()), static_cast<Index>(b)};
      lengths.push_back(mesh.scale() *
                        norm(places[corners.vertex_of(w)] - places[corners.vertex_of(v)]));
      angles_there.push_back(angles[v]);
    }
    const HoleLayout layout(lengths, angles_there);
    const auto row = static_cast<Index>(made.vertex_rows + 3 * made.holes.size());
    made.holes.push_back({&loops[l], row, layout.closed()});
    const std::array<double, 3> defects = layout.defects(made.holes.back().polygon.size);
    for (Index c = 0; c < 3; ++c)
      made.defects[row + c] = defects[c];
  }
  return true;
}

/// Nothing where the piece has no pattern.
std::optional<Equations> equations_of(const PanelMesh& mesh, const PieceCorners& corners,
                                      std::span<const Index> triangles) {
  Equations made;
  number_rows(mesh, corners, made);
  made.masses.assign(corners.vertex_count(), 0.0);
  std::vector<double> angles(corners.vertex_count(), 0.0);
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index v = corners.corners(k)[i];
      made.masses[v] += mesh.area(triangles[k]) / 3.0;
      angles[v] += mesh.angles(triangles[k])[i];
    }
  }
  made.defects.resize(static_cast<Eigen::Index>(made.vertex_rows));
  for (std::size_t v = 0; v < angles.size(); ++v) {
    if (made.row_of[v] != PanelEdge::none)
      made.defects[made.row_of[v]] = 2.0 * std::numbers::pi - angles[v];
  }
  if (corners.border_loops().size() > 1 && !take_holes(mesh, corners, angles, made))
    return std::nullopt;
  return made;
}

/// M^-1/2 K^T.
GramMatrix weighed_stiffness(const PanelMesh& mesh, const PieceCorners& corners,
                             std::span<const Index> triangles, const Equations& equations) {
  std::vector<double> roots;
  for (const double mass : equations.masses)
    roots.push_back(mass > 0.0 ? 1.0 / std::sqrt(mass) : 0.0);
  std::vector<GramMatrix::Entry> entries;
  entries.reserve(12 * triangles.size());
  // The weight of an edge in the row of v, and in those of the hole at v.
  const auto add_edge = [&](Index v, Index w, double weight) {
    const auto add_row = [&](Index row, double factor) {
      entries.push_back({v, row, factor * weight * roots[v]});
      entries.push_back({w, row, -factor * weight * roots[w]});
    };
    if (equations.row_of[v] != PanelEdge::none) return add_row(equations.row_of[v], 1.0);
    if (equations.at_hole.empty() || equations.at_hole[v].hole == PanelEdge::none) return;
    const Hole& hole = equations.holes[equations.at_hole[v].hole];
    const Vec2 place = hole.polygon.places[equations.at_hole[v].corner];
    add_row(hole.row, 1.0);
    add_row(hole.row + 1, place.x);
    add_row(hole.row + 2, place.y);
  };
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double weight = 0.5 * mesh.cotangents(triangles[k])[i];
      const Index a = corners.corners(k)[(i + 1) % 3], b = corners.corners(k)[(i + 2) % 3];
      add_edge(a, b, weight);
      add_edge(b, a, weight);
    }
  }
  for (const Hole& hole : equations.holes) {
    for (std::size_t b = 0; b < hole.loop->size(); ++b) {
      const Index v = (*hole.loop)[b];
      entries.push_back({v, hole.row + 1, -hole.polygon.normals[b].x * roots[v]});
      entries.push_back({v, hole.row + 2, -hole.polygon.normals[b].y * roots[v]});
    }
  }
  return {corners.vertex_count(), static_cast<std::size_t>(equations.defects.size()), entries};
}

}  // namespace

double PanelPiece::strain() const {
  return area > 0.0 ? std::sqrt(energy / area) : 0.0;
}

std::optional<PiecePotential> piece_potential(const PanelMesh& mesh, const PieceCorners& corners,
                                              std::span<const Index> triangles) {
  const std::optional<Equations> equations = equations_of(mesh, corners, triangles);
  if (!equations) return std::nullopt;
  PiecePotential found;
  found.phi.assign(corners.vertex_count(), 0.0);
  if (equations->defects.size() == 0) return found;
  const GramMatrix stiffness = weighed_stiffness(mesh, corners, triangles, *equations);
  const SparseMatrix lower = stiffness.lower();
  ThreadPool alone(1);
  SparseLdlt factor(lower);
  if (!factor.factor(lower, alone)) return std::nullopt;
  const Eigen::VectorXd x = factor.solve(equations->defects);
  NeumaierSum sum;
  for (Eigen::Index row = 0; row < x.size(); ++row)
    sum.add(equations->defects[row] * x[row]);
  found.energy = 3.0 / 8.0 * sum.value();
  const std::vector<double> phi = stiffness.times(x);
  for (std::size_t v = 0; v < found.phi.size(); ++v) {
    if (equations->masses[v] > 0.0) found.phi[v] = phi[v] / std::sqrt(equations->masses[v]);
  }
  return found;
}

PanelPiece measured_piece(const PanelMesh& mesh, const OpenEdges& open,
                          std::vector<Index> triangles, std::size_t most_cut_loops) {
  const PieceCorners corners(mesh, open, triangles);
  PanelPiece piece;
  NeumaierSum area;
  for (const Index t : triangles)
    area.add(mesh.area(t));
  piece.area = area.value();
  piece.cut_loops = corners.cut_loops();
  piece.is_planar = corners.is_planar();
  piece.energy = std::numeric_limits<double>::infinity();
  if (piece.is_planar && piece.cut_loops <= most_cut_loops) {
    if (const auto potential = piece_potential(mesh, corners, triangles))
      piece.energy = potential->energy;
  }
  piece.triangles = std::move(triangles);
  return piece;
}

}  // namespace planish
