#include "evolve/auto/normal_direction_system.h"

#include <algorithm>

#include "evolve/systems/positions.h"
#include "solve/dissection.h"
#include "solve/sparse_pattern.h"

namespace planish {

namespace {

using Steps = NormalDirectionSystem::Steps;

/// Calls visit(row, column, value) for the lower half of a matrix.
template <class Visit>
void for_lower(const SparseMatrix& matrix, const Visit& visit) {
  for (int j = 0; j < matrix.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator entry(matrix, j); entry; ++entry) {
      if (entry.row() >= j) visit(static_cast<int>(entry.row()), j, entry.value());
    }
  }
}

/// Calls visit(step, other step, value) for the lower half of the cost's part of the matrix.
template <class Visit>
void for_cost(const SparseMatrix& cost, const Steps& steps, const Visit& visit) {
  for_lower(cost, [&](int v, int w, double value) {
    const int first = steps.first_of(v), other = steps.first_of(w);
    for (int i = 0; i < steps.count_of(v); ++i) {
      const int most = v == w ? i + 1 : steps.count_of(w);
      for (int j = 0; j < most; ++j)
        visit(first + i, other + j, value);
    }
  });
}

/// Calls visit(step, entry) for each step that the entries of the Jacobian are of.
template <class Visit>
void for_gradients(const AngleJacobian& jacobian, const Steps& steps, const Visit& visit) {
  for (Index v = 0; v < jacobian.column_count(); ++v) {
    const int first = steps.first_of(static_cast<int>(v));
    for (const AngleJacobian::Entry& entry : jacobian.column(v)) {
      for (int i = 0; i < steps.count_of(static_cast<int>(v)); ++i)
        visit(first + i, entry);
    }
  }
}

SparseMatrix pattern_of(const AngleJacobian& jacobian, const SparseMatrix& cost,
                        const SparseMatrix& square, const Steps& steps) {
  std::vector<Eigen::Triplet<double>> entries;
  for_cost(cost, steps, [&](int a, int b, double) {
    entries.emplace_back(steps.unknown(a), steps.unknown(b), 0.0);
  });
  for_lower(square, [&](int v, int w, double) {
    entries.emplace_back(Steps::multiplier_of(v), Steps::multiplier_of(w), 0.0);
  });
  for_gradients(jacobian, steps, [&](int step, const AngleJacobian::Entry& entry) {
    const auto [column, row] =
        std::minmax({steps.unknown(step), Steps::multiplier_of(static_cast<int>(entry.row))});
    entries.emplace_back(row, column, 0.0);
  });
  const int size = steps.inner + steps.first_of(static_cast<int>(jacobian.column_count()));
  SparseMatrix lower(size, size);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

/// All unknowns of a vertex after one another.
std::vector<Index> elimination_order(const PatchState& state, const SparseMatrix& cost,
                                     SparseMatrix square, const Steps& steps) {
  square.conservativeResize(cost.rows(), cost.cols());
  const SparseMatrix lower = cost + square, both_halves = lower.selfadjointView<Eigen::Lower>();
  std::vector<Index> order;
  const auto count = static_cast<std::size_t>(cost.rows());
  for (const Index v : nested_dissection(first_positions(state, count), graph_of(both_halves))) {
    const int vertex = static_cast<int>(v), first = steps.first_of(vertex);
    for (int i = 0; i < steps.count_of(vertex); ++i)
      order.push_back(static_cast<Index>(steps.unknown(first + i)));
    if (vertex < steps.inner) order.push_back(static_cast<Index>(Steps::multiplier_of(vertex)));
  }
  return order;
}

}  // namespace

NormalDirectionSystem::NormalDirectionSystem(const AngleJacobian& jacobian, const PatchState& state,
                                             const SparseMatrix& cost, const SparseMatrix& square,
                                             int border_directions)
    : jacobian_(jacobian),
      steps_{static_cast<int>(jacobian.row_count()), border_directions},
      lower_(pattern_of(jacobian, cost, square, steps_)),
      solver_(lower_, elimination_order(state, cost, square, steps_),
              step_precision(state.inner_count())) {
  const auto place = [this](int row, int column) {
    return static_cast<std::uint32_t>(entry_of(lower_, row, column));
  };
  for_cost(cost, steps_, [&](int a, int b, double) {
    cost_entries_.push_back(place(steps_.unknown(a), steps_.unknown(b)));
  });
  for_lower(square, [&](int v, int w, double) {
    square_entries_.push_back(place(Steps::multiplier_of(v), Steps::multiplier_of(w)));
  });
  for_gradients(jacobian, steps_, [&](int step, const AngleJacobian::Entry& entry) {
    gradient_entries_.push_back(
        place(steps_.unknown(step), Steps::multiplier_of(static_cast<int>(entry.row))));
  });
  for (auto* positions : {&cost_entries_, &square_entries_, &gradient_entries_})
    positions->shrink_to_fit();
}

bool NormalDirectionSystem::factor(std::span<const Vec3> directions, const SparseMatrix& cost,
                                   const SparseMatrix& square, double unit, double stiffness,
                                   double sigma, ThreadPool& pool) {
  double* values = lower_.valuePtr();
  const std::uint32_t* place = cost_entries_.data();
  for_cost(cost, steps_, [&](int a, int b, double value) {
    const double along = a == b ? 1.0 : dot(directions[a], directions[b]);
    values[*place++] = stiffness * along * value;
  });
  place = square_entries_.data();
  for_lower(square, [&](int, int, double value) { values[*place++] = -sigma * sigma * value; });
  place = gradient_entries_.data();
  for_gradients(jacobian_, steps_, [&](int step, const AngleJacobian::Entry& entry) {
    values[*place++] = -unit * dot(directions[step], jacobian_.gradient(entry.entry));
  });
  return solver_.factor(lower_, pool);
}

Eigen::VectorXd NormalDirectionSystem::solve(const Eigen::VectorXd& force,
                                             const Eigen::VectorXd& angle_change, ThreadPool& pool,
                                             double accuracy) {
  Eigen::VectorXd right(lower_.rows());
  for (int s = 0; s < force.size(); ++s)
    right[steps_.unknown(s)] = force[s];
  for (int v = 0; v < angle_change.size(); ++v)
    right[Steps::multiplier_of(v)] = angle_change[v];
  const Eigen::VectorXd solution = solver_.solve(lower_, right, pool, accuracy);
  Eigen::VectorXd steps(force.size());
  for (int s = 0; s < force.size(); ++s)
    steps[s] = solution[steps_.unknown(s)];
  return steps;
}

}  // namespace planish
