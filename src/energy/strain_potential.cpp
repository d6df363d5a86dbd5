#include "energy/strain_potential.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/neumaier_sum.h"
#include "geometry/cotangents.h"
#include "solve/dissection.h"
#include "solve/sparse_pattern.h"

namespace planish {

namespace {

constexpr std::size_t k_nowhere = std::numeric_limits<std::size_t>::max();
constexpr std::size_t k_grain = 512;
constexpr double k_accuracy = 1e-8;  // of chi, on dense patches

/// K without values.
SparseMatrix pattern_of(const AngleJacobian& jacobian, std::size_t rows) {
  const std::size_t n = jacobian.row_count();
  return sparse_matrix(rows, n, [&](const auto& add) {
    for (Index v = 0; v < n; ++v) {
      add(v, v, 0.0);
      for (const Index w : jacobian.ring(v)) {
        if (w < rows) add(w, v, 0.0);
      }
    }
  });
}

/// Among the values; k_nowhere where the entry is not there.
std::size_t place_in_column(const SparseMatrix& matrix, int row, int column) {
  const int* rows = matrix.innerIndexPtr();
  const int* end = rows + matrix.outerIndexPtr()[column + 1];
  const int* found = std::lower_bound(rows + matrix.outerIndexPtr()[column], end, row);
  return found != end && *found == row ? static_cast<std::size_t>(found - rows) : k_nowhere;
}

double dot_of_columns(const SparseMatrix& matrix, int a, int b) {
  double sum = 0.0;
  SparseMatrix::InnerIterator x(matrix, a), y(matrix, b);
  while (x && y) {
    if (x.row() == y.row()) {
      sum += x.value() * y.value();
      ++x;
      ++y;
    } else if (x.row() < y.row()) {
      ++x;
    } else {
      ++y;
    }
  }
  return sum;
}

}  // namespace

StrainPotential::StrainPotential(const AngleJacobian& jacobian, std::span<const Vec3> x,
                                 ThreadPool& pool, BoundaryCondition border, Precision precision)
    : jacobian_(jacobian),
      border_(border),
      stiffness_(pattern_of(jacobian,
                            border == BoundaryCondition::free ? x.size() : jacobian.row_count())) {
  const std::size_t n = jacobian.row_count();
  if (n == 0) return;
  fill(x, pool);
  const SparseMatrix square = SparseMatrix(stiffness_.transpose()) * stiffness_;
  square_ = square.triangularView<Eigen::Lower>();
  pool.stop_if_cancelled();
  const bool free = border == BoundaryCondition::free;
  solver_.emplace(matrix(), nested_dissection(x.first(n), graph_of(free ? square : stiffness_)),
                  precision, &pool);
  solvable_ = solver_->factor(matrix(), pool);
}

void StrainPotential::fill(std::span<const Vec3> x, ThreadPool& pool) {
  double* values = stiffness_.valuePtr();
  const double at_border = std::sqrt(ease_);
  pool.for_ranges(jacobian_.row_count(), k_grain, [&](std::size_t begin, std::size_t end) {
    std::vector<Vec3> ring;
    for (std::size_t v = begin; v < end; ++v) {
      ring.clear();
      for (const Index w : jacobian_.ring(static_cast<Index>(v)))
        ring.push_back(x[w]);
      const int column = static_cast<int>(v);
      double& own = values[place_in_column(stiffness_, column, column)] = 0.0;
      const std::vector<double> weights = cotangent_weights(x[v], ring);
      const auto neighbours = jacobian_.ring(static_cast<Index>(v));
      for (std::size_t j = 0; j < weights.size(); ++j) {
        own += weights[j];
        const std::size_t place =
            place_in_column(stiffness_, static_cast<int>(neighbours[j]), column);
        if (place == k_nowhere) continue;
        values[place] =
            neighbours[j] < jacobian_.row_count() ? -weights[j] : -at_border * weights[j];
      }
    }
  });
}

void StrainPotential::take_square(ThreadPool& pool) {
  pool.for_ranges(jacobian_.row_count(), k_grain, [this](std::size_t begin, std::size_t end) {
    for (int v = static_cast<int>(begin); v < static_cast<int>(end); ++v) {
      for (SparseMatrix::InnerIterator entry(square_, v); entry; ++entry)
        entry.valueRef() = dot_of_columns(stiffness_, static_cast<int>(entry.row()), v);
    }
  });
}

void StrainPotential::update(std::span<const Vec3> x, ThreadPool& pool) {
  if (!solver_) return;
  fill(x, pool);
  take_square(pool);
  factor(pool);
}

void StrainPotential::release() {
  if (solver_) solver_->release();
}

void StrainPotential::factor(ThreadPool& pool) {
  if (solver_) solvable_ = solver_->factor(matrix(), pool);
}

Eigen::VectorXd StrainPotential::of(const Eigen::VectorXd& defects, ThreadPool& pool) {
  Eigen::VectorXd solution = solver_->solve(matrix(), defects, pool, k_accuracy, k_accuracy);
  if (border_ == BoundaryCondition::dirichlet) return solution;
  return stiffness_ * solution;
}

Eigen::VectorXd area_shares(std::span<const Triangle> triangles, std::span<const Vec3> x) {
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(x.size()));
  for (const Triangle& t : triangles) {
    const double area = norm(cross(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]));
    for (const Index v : t)
      shares[static_cast<Eigen::Index>(v)] += area;
  }
  NeumaierSum total;
  for (const double share : shares)
    total.add(share);
  return shares / total.value();
}

double edge_strain_of(double rms_potential) {
  return std::sqrt(3.0 / 8.0) * rms_potential;
}

}  // namespace planish
