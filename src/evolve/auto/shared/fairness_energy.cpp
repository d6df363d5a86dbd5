#include "evolve/auto/shared/fairness_energy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "evolve/auto/shared/tuning.h"
#include "evolve/systems/dense.h"
#include "evolve/systems/fairing_system.h"
#include "solve/dissection.h"
#include "solve/mixed_ldlt.h"
#include "solve/sparse_pattern.h"

namespace planish {

namespace {

constexpr double k_spread_accuracy = 1e-6;  // on dense patches

/// The border's weigh more: it is the design's line, and where it may move, bending alone would
/// straighten it early and for good. Sums along it go with the edges, those over the surface with
/// their square.
std::vector<double> pulls(const PatchState& state, std::size_t count, double closeness) {
  const double density = relative_density(state);
  const double inner = closeness / (density * density);
  const double border = tuning::k_border_to_inner * std::sqrt(density) * inner;
  std::vector<double> pulls;
  for (Index v = 0; v < count; ++v)
    pulls.push_back((state.is_inner(v) ? inner : border) * state.weight(v) * state.weight(v));
  return pulls;
}

/// L over the vertices that may move; the rows of the others are empty.
SparseMatrix moving_part(const std::vector<std::vector<double>>& rows,
                         const AngleJacobian& jacobian) {
  return sparse_matrix(rows.size(), jacobian.column_count(), [&](const auto& add) {
    for (Index v = 0; v < rows.size(); ++v) {
      const auto ring = jacobian.ring(v);
      if (jacobian.is_movable(v)) add(v, v, std::accumulate(rows[v].begin(), rows[v].end(), 0.0));
      for (std::size_t j = 0; j < ring.size(); ++j) {
        if (jacobian.is_movable(ring[j])) add(v, ring[j], -rows[v][j]);
      }
    }
  });
}

/// B over the vertices that may move.
SparseMatrix moving_part(const std::vector<SecondDifference>& bends,
                         const AngleJacobian& jacobian) {
  return sparse_matrix(bends.size(), jacobian.column_count(), [&](const auto& add) {
    for (std::size_t row = 0; row < bends.size(); ++row) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Index v = bends[row].vertices[k];
        if (jacobian.is_movable(v)) add(row, v, bends[row].weights[k]);
      }
    }
  });
}

/// Sums of squares along a curve go with the cube of the edges, over a surface with their square.
std::vector<SecondDifference> weighed(std::vector<SecondDifference> bends,
                                      const PatchState& state) {
  const double weight = std::sqrt(std::sqrt(relative_density(state)));
  for (SecondDifference& bend : bends) {
    for (double& w : bend.weights)
      w *= weight;
  }
  return bends;
}

SparseMatrix diagonal_matrix(const std::vector<double>& values) {
  const auto n = static_cast<int>(values.size());
  SparseMatrix matrix(n, n);
  matrix.setIdentity();
  matrix.diagonal() = Eigen::Map<const Eigen::VectorXd>(values.data(), n);
  return matrix;
}

}  // namespace

double relative_density(const PatchState& state) {
  return static_cast<double>(state.inner_count()) / tuning::k_usual_count;
}

FairnessEnergy::FairnessEnergy(const AngleJacobian& jacobian, const PatchState& state,
                               double closeness, std::vector<SecondDifference> bends)
    : jacobian_(jacobian),
      state_(state),
      unit_(mean_edge(jacobian, state)),
      origin_(first_origins(state, jacobian.column_count())),
      pull_(pulls(state, jacobian.column_count(), closeness)),
      rows_(rows_of_laplacian(state, LaplacianWeights::cotangent)),
      bends_(weighed(std::move(bends), state)) {
  const SparseMatrix l = moving_part(rows_, jacobian);
  SparseMatrix both_halves = SparseMatrix(l.transpose() * l) + diagonal_matrix(pull_);
  if (!bends_.empty()) {
    const SparseMatrix b = moving_part(bends_, jacobian);
    both_halves += SparseMatrix(b.transpose() * b);
  }
  hessian_ = both_halves.triangularView<Eigen::Lower>();
}

Positions FairnessEnergy::laplacian(const Positions& x) const {
  Positions values(rows_.size());
  for (Index v = 0; v < values.size(); ++v) {
    const auto ring = jacobian_.ring(v);
    Vec3 sum;
    for (std::size_t j = 0; j < ring.size(); ++j)
      sum += rows_[v][j] * (x[v] - (ring[j] < x.size() ? x[ring[j]] : state_.position(ring[j])));
    values[v] = (1.0 / unit_) * sum;
  }
  return values;
}

Positions FairnessEnergy::bends_of(const Positions& x) const {
  Positions values;
  for (const auto& [vertices, weights] : bends_) {
    Vec3 sum;
    for (std::size_t k = 0; k < 3; ++k)
      sum += weights[k] * (x[vertices[k]] - origin_[vertices[k]]);
    values.push_back((1.0 / unit_) * sum);
  }
  return values;
}

double FairnessEnergy::value(const Positions& x) const {
  const Positions bends = laplacian(x);
  double cost = 0.0;
  for (std::size_t v = 0; v < x.size(); ++v) {
    const Vec3 away = (1.0 / unit_) * (x[v] - origin_[v]);
    const double bend = v < bends.size() ? dot(bends[v], bends[v]) : 0.0;
    cost += 0.5 * (pull_[v] * dot(away, away) + bend);
  }
  for (const Vec3 bend : bends_of(x))
    cost += 0.5 * dot(bend, bend);
  return cost;
}

Positions FairnessEnergy::gradient(const Positions& x) const {
  const Positions bends = laplacian(x);
  Positions gradient(x.size());
  for (Index v = 0; v < x.size(); ++v) {
    for (std::size_t j = 0; v < bends.size() && j < rows_[v].size(); ++j) {
      const Vec3 part = rows_[v][j] * bends[v];
      gradient[v] += part;
      const Index w = jacobian_.ring(v)[j];
      if (w < x.size()) gradient[w] += -part;
    }
    gradient[v] += (pull_[v] / unit_) * (x[v] - origin_[v]);
  }
  const Positions border_bends = bends_of(x);
  for (std::size_t row = 0; row < bends_.size(); ++row) {
    for (std::size_t k = 0; k < 3; ++k)
      gradient[bends_[row].vertices[k]] += bends_[row].weights[k] * border_bends[row];
  }
  for (Index v = 0; v < x.size(); ++v) {
    if (!jacobian_.is_movable(v)) gradient[v] = {};
  }
  return gradient;
}

void FairnessEnergy::scale_proximity(std::span<const Index> vertices, double factor) {
  for (const Index v : vertices) {
    if (pull_[v] > tuning::k_heaviest) continue;
    hessian_.coeffRef(static_cast<int>(v), static_cast<int>(v)) += (factor - 1.0) * pull_[v];
    pull_[v] *= factor;
  }
}

void FairnessEnergy::scale_closeness(double factor) {
  for (std::size_t v = 0; v < pull_.size(); ++v) {
    hessian_.coeffRef(static_cast<int>(v), static_cast<int>(v)) += (factor - 1.0) * pull_[v];
    pull_[v] *= factor;
  }
}

Positions FairnessEnergy::spread(std::span<const unsigned char> given, const Positions& moves,
                                 ThreadPool& pool) const {
  const auto n = static_cast<int>(moves.size());
  SparseMatrix matrix = hessian_;
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, 3);
  for (int v = 0; v < n; ++v) {
    const bool pinned = given[v] != 0 || !jacobian_.is_movable(static_cast<Index>(v));
    matrix.coeffRef(v, v) += (pinned ? 1.0 : tuning::k_anchor) - pull_[v];
    if (given[v] != 0) right.row(v) << moves[v].x, moves[v].y, moves[v].z;
  }
  pool.stop_if_cancelled();
  const SparseMatrix both_halves = matrix.selfadjointView<Eigen::Lower>();
  MixedLdlt solver(matrix, nested_dissection(origin_, graph_of(both_halves)),
                   step_precision(state_.inner_count()), &pool);
  if (!solver.factor(matrix, pool)) return Positions(moves.size());
  const auto along = [&](int axis) {
    return solver.solve(matrix, right.col(axis), pool, k_spread_accuracy, k_spread_accuracy);
  };
  const Eigen::VectorXd x = along(0), y = along(1), z = along(2);
  Positions result(moves.size());
  for (int v = 0; v < n; ++v)
    result[v] = {x[v], y[v], z[v]};
  return result;
}

}  // namespace planish
