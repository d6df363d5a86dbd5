#include "evolve/normal_system.h"

#include <algorithm>

#include "evolve/places.h"
#include "solve/dissection.h"
#include "solve/sparse_pattern.h"

namespace planish {

namespace {

int step_of(int v) {
  return 2 * v;
}
int multiplier_of(int v) {
  return 2 * v + 1;
}

/// Calls visit(row, column, value) for the lower half of a matrix.
template <class Visit>
void for_lower(const SparseMatrix& matrix, const Visit& visit) {
  for (int j = 0; j < matrix.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator entry(matrix, j); entry; ++entry) {
      if (entry.row() >= j) visit(static_cast<int>(entry.row()), j, entry.value());
    }
  }
}

SparseMatrix pattern_of(const AngleJacobian& jacobian, const SparseMatrix& cost,
                        const SparseMatrix& square) {
  std::vector<Eigen::Triplet<double>> entries;
  for_lower(cost, [&](int v, int w, double) { entries.emplace_back(step_of(v), step_of(w), 0.0); });
  for_lower(square, [&](int v, int w, double) {
    entries.emplace_back(multiplier_of(v), multiplier_of(w), 0.0);
  });
  for (Index v = 0; v < jacobian.row_count(); ++v) {
    for (const AngleJacobian::Entry& entry : jacobian.column(v)) {
      const auto [column, row] =
          std::minmax({step_of(static_cast<int>(v)), multiplier_of(static_cast<int>(entry.row))});
      entries.emplace_back(row, column, 0.0);
    }
  }
  const int size = 2 * static_cast<int>(jacobian.row_count());
  SparseMatrix lower(size, size);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

std::vector<Index> elimination_order(const PatchState& state, const SparseMatrix& cost,
                                     const SparseMatrix& square) {
  const SparseMatrix both = cost + square;
  std::vector<Index> order;
  for (const Index v : nested_dissection(inner_places(state), graph_of(both))) {
    order.push_back(static_cast<Index>(step_of(static_cast<int>(v))));
    order.push_back(static_cast<Index>(multiplier_of(static_cast<int>(v))));
  }
  return order;
}

}  // namespace

NormalSystem::NormalSystem(const AngleJacobian& jacobian, const PatchState& state,
                           const SparseMatrix& cost, const SparseMatrix& square)
    : jacobian_(jacobian),
      lower_(pattern_of(jacobian, cost, square)),
      solver_(lower_, elimination_order(state, cost, square)) {
  for_lower(cost, [&](int v, int w, double) {
    cost_places_.push_back(place_of(lower_, step_of(v), step_of(w)));
  });
  for_lower(square, [&](int v, int w, double) {
    square_places_.push_back(place_of(lower_, multiplier_of(v), multiplier_of(w)));
  });
  for (Index v = 0; v < jacobian.row_count(); ++v) {
    for (const AngleJacobian::Entry& entry : jacobian.column(v)) {
      gradient_places_.push_back(place_of(lower_, step_of(static_cast<int>(v)),
                                          multiplier_of(static_cast<int>(entry.row))));
    }
  }
}

bool NormalSystem::factor(std::span<const Vec3> normals, const SparseMatrix& cost,
                          const SparseMatrix& square, double unit, double stiffness, double sigma,
                          ThreadPool& pool) {
  double* values = lower_.valuePtr();
  const std::size_t* place = cost_places_.data();
  for_lower(cost, [&](int v, int w, double value) {
    const double along = v == w ? 1.0 : dot(normals[v], normals[w]);
    values[*place++] = stiffness * along * value;
  });
  place = square_places_.data();
  for_lower(square, [&](int, int, double value) { values[*place++] = -sigma * sigma * value; });
  place = gradient_places_.data();
  for (Index v = 0; v < jacobian_.row_count(); ++v) {
    for (const AngleJacobian::Entry& entry : jacobian_.column(v))
      values[*place++] = -unit * dot(normals[v], jacobian_.gradient(entry.entry));
  }
  return solver_.factor(lower_, pool);
}

Eigen::VectorXd NormalSystem::solve(const Eigen::VectorXd& force,
                                    const Eigen::VectorXd& turn) const {
  Eigen::VectorXd right(lower_.rows());
  for (int v = 0; v < force.size(); ++v) {
    right[step_of(v)] = force[v];
    right[multiplier_of(v)] = turn[v];
  }
  const Eigen::MatrixXd solution = solver_.solve(right);
  Eigen::VectorXd steps(force.size());
  for (int v = 0; v < force.size(); ++v)
    steps[v] = solution(step_of(v), 0);
  return steps;
}

}  // namespace planish
