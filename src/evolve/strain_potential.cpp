#include "evolve/strain_potential.h"

#include "evolve/fairing.h"
#include "evolve/places.h"
#include "solve/dissection.h"
#include "solve/sparse_pattern.h"

namespace planish {

namespace {

SparseMatrix stiffness_of(const AngleJacobian& jacobian, const PatchState& state) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto n = static_cast<int>(jacobian.row_count());
  for (int v = 0; v < n; ++v) {
    const auto ring = jacobian.ring(static_cast<Index>(v));
    std::vector<Vec3> places;
    for (const Index w : ring)
      places.push_back(state.position(w));
    const std::vector<double> weights =
        cotangent_weights(state.position(static_cast<std::size_t>(v)), places);
    for (std::size_t j = 0; j < ring.size(); ++j) {
      entries.emplace_back(v, v, weights[j]);
      // Both ends of an edge see the same triangles, but for rounding.
      if (state.is_inner(ring[j])) {
        entries.emplace_back(v, static_cast<int>(ring[j]), -0.5 * weights[j]);
        entries.emplace_back(static_cast<int>(ring[j]), v, -0.5 * weights[j]);
      }
    }
  }
  SparseMatrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

StrainPotential::StrainPotential(const AngleJacobian& jacobian, const PatchState& state,
                                 ThreadPool& pool)
    : stiffness_(stiffness_of(jacobian, state)) {
  if (stiffness_.cols() == 0) return;
  const SparseMatrix lower = stiffness_.triangularView<Eigen::Lower>();
  solver_.emplace(lower, nested_dissection(inner_places(state), graph_of(stiffness_)));
  solvable_ = solver_->factor(lower, pool);
}

}  // namespace planish
