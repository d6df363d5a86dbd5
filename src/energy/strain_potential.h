#pragma once

#include <optional>
#include <span>

#include <planish/mesh/tri_mesh.h>

#include "core/thread_pool.h"
#include "energy/angle_jacobian.h"
#include "mesh/symmetry/mirror_orbits.h"
#include "solve/mixed_ldlt.h"

namespace planish {

/// What the border may do in the pattern whose strain is measured.
enum class BoundaryCondition {
  dirichlet,  ///< keeps its length, so what strain there is lies inside
  free,       ///< as of what is cut from sheet
};

/// phi with
///
///     K phi = d
///
/// at the inner vertices: K the stiffness matrix of cotangents, d the angle defects
/// (docs/methods/smooth.md, docs/methods/auto.md). To first order e^phi is by how much a conformal
/// pattern stretches (Ben-Chen and others 2008), so unlike the energy it does not depend on the
/// density of the mesh. phi at the border is
///
/// - dirichlet: 0, so there is one such phi. A system of K, the metric that of the patch at first.
/// - free: such that |phi| is smallest, phi = K^T (K K^T)^-1 d. Then it tells the strain of the
///   pattern of least stretch: see edge_strain_of().
///
/// Where the border is free, K and d have three more rows for each hole of the jacobian, so that
/// its border closes in the pattern: d is what HoleLayout::defects() gives, K how phi changes that
/// (docs/methods/smooth.md). The polygons of the holes are taken with K.
///
/// Of a patch that is its own mirror image the rows of each orbit are summed: Q^T K phi = Q^T d,
/// with the phi that is symmetric.
class StrainPotential {
 public:
  /// Takes K from a surface: positive definite, as of finite elements, where each part of it has a
  /// border.
  /// @param jacobian has the rings of the inner vertices, and holes only where the border is free;
  ///   must outlive it
  /// @param x the positions of all vertices, inner ones first
  /// @param precision in which K is factored
  /// @param orbits symmetric only where there are no holes
  StrainPotential(const AngleJacobian& jacobian, std::span<const Vec3> x, ThreadPool& pool,
                  BoundaryCondition border, Precision precision = Precision::full,
                  MirrorOrbits orbits = {});

  /// False where K or its square cannot be factored.
  bool solvable() const { return solvable_; }
  BoundaryCondition border() const { return border_; }
  /// From the next update on, the squares of phi at a free border are divided by `ease`, as if the
  /// border were stiffer; but not at holes, which then could not close. There of() then returns
  /// phi / sqrt(ease): strain is overestimated, if anything.
  /// @param ease above 0, at most 1: as at first
  void set_boundary_compliance(double ease) { ease_ = ease; }
  /// Takes K from a surface with other positions.
  void update(std::span<const Vec3> x, ThreadPool& pool);
  /// Frees the factor, until it is made again, by factor() or update().
  void release();
  /// Factors the K of the last update.
  void factor(ThreadPool& pool);
  /// The right side: angle defects, then those of the holes.
  /// @param of_vertices angle defects by inner vertex, radians
  /// @param at the position of a vertex
  template <class At>
  Eigen::VectorXd defects(Eigen::VectorXd of_vertices, const At& at) const;
  /// @param defects by row of the jacobian, as from defects()
  /// @return by inner vertex; where the border is free by vertex. @pre the factor is there
  Eigen::VectorXd of(const Eigen::VectorXd& defects, ThreadPool& pool);

  /// K^T: a row for each value of phi, a column for each orbit of inner vertices and three for each
  /// hole.
  const SparseMatrix& stiffness() const { return stiffness_; }
  /// K K^T, its lower half: |phi|^2 = d . square^-1 d.
  const SparseMatrix& square() const { return square_; }

 private:
  /// What is solved with.
  const SparseMatrix& matrix() const { return by_square() ? square_ : stiffness_; }
  /// K summed by orbits is not symmetric.
  bool by_square() const { return border_ == BoundaryCondition::free || orbits_.is_symmetric(); }
  /// On the border, but not on that of a hole.
  bool is_eased(Index v) const {
    return v >= jacobian_.angle_count() && (is_at_hole_.empty() || is_at_hole_[v] == 0);
  }
  void fill(std::span<const Vec3> x, ThreadPool& pool);
  void add_row(Index v, int column, std::span<const Vec3> x);
  void fill_hole(std::size_t hole, std::span<const Vec3> x);
  std::vector<Index> elimination_order(std::span<const Vec3> x) const;
  void take_square(ThreadPool& pool);

  const AngleJacobian& jacobian_;
  MirrorOrbits orbits_;
  BoundaryCondition border_;
  double ease_ = 1.0;
  std::vector<unsigned char> is_at_hole_;      // by vertex; none where there are no holes
  std::vector<HoleLayout::Polygon> polygons_;  // by hole
  SparseMatrix stiffness_, square_;            // K^T, K K^T
  std::optional<MixedLdlt> solver_;            // of matrix()
  bool solvable_ = false;
};

template <class At>
Eigen::VectorXd StrainPotential::defects(Eigen::VectorXd of_vertices, const At& at) const {
  const std::vector<HoleBorder>& holes = jacobian_.holes();
  Eigen::Index row = of_vertices.size();
  of_vertices.conservativeResize(row + 3 * static_cast<Eigen::Index>(holes.size()));
  for (std::size_t hole = 0; hole < holes.size(); ++hole) {
    for (const double defect : laid_out(holes[hole], at).defects(polygons_[hole].size))
      of_vertices[row++] = defect;
  }
  return of_vertices;
}

/// The strain of the edges, rms, of the pattern of least stretch whose border is free, from the rms
/// of its phi over all vertices. The strains of a plane piece without load at its border follow
/// from Airy's function chi, phi = laplace chi, chi and its slope 0 at the border; so the integral
/// of e1^2 + e2^2 is that of phi^2, that of (e1 + e2)^2 too, and an edge, which may lie in any
/// direction, has 3/8 of it in the mean (docs/methods/auto.md).
double edge_strain_of(double rms_potential);

/// The share of each vertex in the area of a surface: a third of its triangles.
Eigen::VectorXd area_shares(std::span<const Triangle> triangles, std::span<const Vec3> x);

}  // namespace planish
