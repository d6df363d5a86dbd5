#include "panels/cells/tie_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "solve/dissection.h"
#include "solve/sparse_ldlt.h"
#include "solve/sparse_pattern.h"

namespace planish {

namespace {

constexpr double k_snap = 0.1;     // of an edge
constexpr double k_inside = 0.15;  // least share of a corner in a place where three cells meet

/// A third of the triangles around each vertex.
std::vector<double> vertex_areas(const PanelMesh& mesh) {
  std::vector<double> areas(mesh.patch().vertex_count(), 0.0);
  for (Index t = 0; t < mesh.triangles().size(); ++t) {
    for (const Index v : mesh.triangles()[t])
      areas[v] += mesh.area(t) / 3.0;
  }
  return areas;
}

/// M + t L, the whole of it; rows of vertices that no triangle uses are those of 1.
SparseMatrix spreading(const PanelMesh& mesh, std::span<const double> areas, double t) {
  return sparse_matrix(areas.size(), areas.size(), [&](const auto& add) {
    for (Index v = 0; v < areas.size(); ++v)
      add(v, v, areas[v] > 0.0 ? areas[v] : 1.0);
    for (Index k = 0; k < mesh.triangles().size(); ++k) {
      for (std::size_t i = 0; i < 3; ++i) {
        // An obtuse corner would make a cell felt by less than nothing.
        const double weight = std::max(0.0, 0.5 * t * mesh.cotangents(k)[i]);
        const Index a = mesh.triangles()[k][(i + 1) % 3], b = mesh.triangles()[k][(i + 2) % 3];
        add(a, a, weight);
        add(b, b, weight);
        add(a, b, -weight);
        add(b, a, -weight);
      }
    }
  });
}

class TieLines {
 public:
  TieLines(const PanelMesh& mesh, const Eigen::MatrixXd& fields) : mesh_(mesh), fields_(fields) {
    for (Eigen::Index v = 0; v < fields.rows(); ++v) {
      Eigen::Index best = 0;
      fields.row(v).maxCoeff(&best);
      cells_.push_back(static_cast<Index>(best));
    }
  }

  void add_lines_of(Index triangle, std::vector<SurfaceLine>& lines) const {
    const Triangle& t = mesh_.triangles()[triangle];
    std::vector<SurfacePoint> places;
    for (std::size_t i = 0; i < 3; ++i) {
      if (cells_[t[i]] != cells_[t[(i + 1) % 3]]) places.push_back(tie_on(t, i));
    }
    if (places.size() == 2) {
      add(places[0], places[1], lines);
    } else if (places.size() == 3) {
      const SurfacePoint middle{t, tie_of_three(t)};
      for (const SurfacePoint& place : places)
        add(middle, place, lines);
    }
  }

 private:
  static void add(const SurfacePoint& a, const SurfacePoint& b, std::vector<SurfaceLine>& lines) {
    if (a.shares != b.shares) lines.push_back({a, b});
  }

  double field(Index v, Index cell) const {
    return fields_(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(cell));
  }

  /// On side i, the same for both triangles.
  SurfacePoint tie_on(const Triangle& t, std::size_t i) const {
    const std::size_t j = (i + 1) % 3;
    const auto [low, high] = t[i] < t[j] ? std::pair{i, j} : std::pair{j, i};
    const Index a = cells_[t[low]], b = cells_[t[high]];
    const double at_low = field(t[low], a) - field(t[low], b);
    const double at_high = field(t[high], b) - field(t[high], a);
    const double sum = at_low + at_high;
    double share = sum > 0.0 ? at_low / sum : 0.5;
    if (share < k_snap) share = 0.0;
    if (share > 1.0 - k_snap) share = 1.0;
    SurfacePoint place{t, {0.0, 0.0, 0.0}};
    place.shares[low] = 1.0 - share;
    place.shares[high] = share;
    return place;
  }

  /// Where the three cells of the corners tie, kept inside the triangle.
  std::array<double, 3> tie_of_three(const Triangle& t) const {
    // With f(i, j) the field of corner j's cell at corner i: sum b_i (f(i, 0) - f(i, 1)) = 0 and
    // the same for 1 and 2; b is across both rows.
    Vec3 rows[2];
    for (std::size_t r = 0; r < 2; ++r) {
      const Index a = cells_[t[r]], b = cells_[t[r + 1]];
      rows[r] = {field(t[0], a) - field(t[0], b), field(t[1], a) - field(t[1], b),
                 field(t[2], a) - field(t[2], b)};
    }
    const Vec3 across = cross(rows[0], rows[1]);
    const double sum = across.x + across.y + across.z;
    std::array<double, 3> shares = {1.0 / 3, 1.0 / 3, 1.0 / 3};
    if (sum != 0.0) shares = {across.x / sum, across.y / sum, across.z / sum};
    double total = 0.0;
    for (double& share : shares)
      total += share = std::isfinite(share) ? std::clamp(share, k_inside, 1.0) : 1.0 / 3;
    for (double& share : shares)
      share /= total;
    return shares;
  }

  const PanelMesh& mesh_;
  const Eigen::MatrixXd& fields_;
  std::vector<Index> cells_;  // by vertex
};

}  // namespace

Eigen::MatrixXd cell_fields(const PanelMesh& mesh, std::span<const Index> cells, double spread,
                            ThreadPool& pool) {
  const std::vector<double> areas = vertex_areas(mesh);
  const auto count = static_cast<Eigen::Index>(1 + *std::max_element(cells.begin(), cells.end()));
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(areas.size()), count);
  for (Index t = 0; t < cells.size(); ++t) {
    for (const Index v : mesh.triangles()[t])
      right(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(cells[t])) +=
          mesh.area(t) / 3.0;
  }
  const double length = spread * mesh.mean_edge();
  const SparseMatrix matrix = spreading(mesh, areas, length * length);
  SparseLdlt factor(SparseMatrix(matrix.triangularView<Eigen::Lower>()),
                    nested_dissection(mesh.patch().positions(), graph_of(matrix)), &pool);
  if (!factor.factor(SparseMatrix(matrix.triangularView<Eigen::Lower>()), pool)) return right;
  return factor.solve(right, pool);
}

std::vector<SurfaceLine> tie_lines(const PanelMesh& mesh, const Eigen::MatrixXd& fields) {
  const TieLines ties(mesh, fields);
  std::vector<SurfaceLine> lines;
  for (Index t = 0; t < mesh.triangles().size(); ++t)
    ties.add_lines_of(t, lines);
  return lines;
}

}  // namespace planish
