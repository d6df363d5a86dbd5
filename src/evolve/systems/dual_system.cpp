#include "evolve/systems/dual_system.h"

#include <algorithm>
#include <cmath>

#include "evolve/systems/positions.h"
#include "solve/dissection.h"
#include "solve/sparse_pattern.h"

namespace planish {

namespace {

/// Rows that share a movable vertex.
Graph rows_that_meet(const AngleJacobian& jacobian) {
  std::vector<Index> seen(jacobian.row_count(), static_cast<Index>(-1));
  Graph graph;
  for (Index row = 0; row < jacobian.row_count(); ++row) {
    seen[row] = row;
    const auto add_rows_of = [&](Index v) {
      if (!jacobian.is_movable(v)) return;
      for (const AngleJacobian::Entry& entry : jacobian.column(v)) {
        if (seen[entry.row] == row) continue;
        seen[entry.row] = row;
        graph.neighbours.push_back(entry.row);
      }
    };
    add_rows_of(jacobian.vertex_of(row));
    for (const Index v : jacobian.ring(row))
      add_rows_of(v);
    graph.start.push_back(graph.neighbours.size());
  }
  return graph;
}

SparseMatrix lower_pattern(const Graph& graph) {
  const std::size_t n = graph.vertex_count();
  if (n == 0) return {};
  return sparse_matrix(n, n, [&](const auto& add) {
    for (Index v = 0; v < n; ++v) {
      add(v, v, 0.0);
      for (const Index w : graph.of(v)) {
        if (w > v) add(w, v, 0.0);
      }
    }
  });
}

Positions positions_of_rows(const AngleJacobian& jacobian, const PatchState& state) {
  Positions positions;
  for (Index row = 0; row < jacobian.row_count(); ++row)
    positions.push_back(state.position(jacobian.vertex_of(row)));
  return positions;
}

/// Of numbers of which there is at least one. Not their mean: rows grow as one over the square of
/// the length of an edge, and one short edge must not damp the whole patch.
double median(Eigen::VectorXd values) {
  auto* middle = values.data() + values.size() / 2;
  std::nth_element(values.data(), middle, values.data() + values.size());
  return *middle;
}

}  // namespace

DualSystem::DualSystem(const AngleJacobian& jacobian, const PatchState& state, Precision precision)
    : DualSystem(jacobian, state, rows_that_meet(jacobian), precision) {}

DualSystem::DualSystem(const AngleJacobian& jacobian, const PatchState& state, const Graph& rows,
                       Precision precision)
    : jacobian_(jacobian),
      lower_(lower_pattern(rows)),
      solver_(lower_, nested_dissection(positions_of_rows(jacobian, state), rows), precision) {
  const int* row_list = lower_.innerIndexPtr();
  for (Index v = 0; v < jacobian.column_count(); ++v) {
    const auto entries = jacobian.column(v);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const int* begin = row_list + lower_.outerIndexPtr()[entries[i].row];
      const int* end = row_list + lower_.outerIndexPtr()[entries[i].row + 1];
      for (std::size_t j = i; j < entries.size(); ++j) {
        const int* place = std::lower_bound(begin, end, static_cast<int>(entries[j].row));
        products_.push_back(static_cast<std::uint32_t>(place - row_list));
      }
    }
  }
}

void DualSystem::damp_by(const SparseMatrix& symmetric, double share_of_identity) {
  if (lower_.cols() == 0) return;
  const double scale = 1.0 / median(symmetric.diagonal());
  damping_.assign(static_cast<std::size_t>(lower_.nonZeros()), 0.0);
  const int *start = lower_.outerIndexPtr(), *rows = lower_.innerIndexPtr();
  const auto diagonal = [&](Eigen::Index v) -> double& { return damping_[start[v]]; };
  for (int column = 0; column < symmetric.cols(); ++column) {
    diagonal(column) += share_of_identity;
    for (SparseMatrix::InnerIterator entry(symmetric, column); entry; ++entry) {
      if (entry.row() < column) continue;
      const double value = scale * entry.value();
      const int *end = rows + start[column + 1],
                *place = std::lower_bound(rows + start[column], end, entry.row());
      if (place != end && *place == entry.row()) {
        damping_[place - rows] += value;
      } else {  // definite stays definite
        diagonal(column) += std::abs(value);
        diagonal(entry.row()) += std::abs(value);
      }
    }
  }
}

void DualSystem::assemble(std::span<const double> inverse_weights) {
  double* values = lower_.valuePtr();
  std::fill_n(values, lower_.nonZeros(), 0.0);
  const std::uint32_t* place = products_.data();
  for (Index v = 0; v < jacobian_.column_count(); ++v) {
    const auto entries = jacobian_.column(v);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const Vec3 scaled = inverse_weights[v] * jacobian_.gradient(entries[i].entry);
      for (std::size_t j = i; j < entries.size(); ++j)
        values[*place++] += dot(scaled, jacobian_.gradient(entries[j].entry));
    }
  }
}

bool DualSystem::factor(std::span<const double> inverse_weights, double mu, ThreadPool& pool) {
  if (lower_.cols() == 0) return false;
  assemble(inverse_weights);
  double* values = lower_.valuePtr();
  const double unit = median(lower_.diagonal());
  if (!(unit > 0.0)) return false;
  if (damping_.empty()) {
    for (int v = 0; v < lower_.cols(); ++v)
      values[lower_.outerIndexPtr()[v]] += mu * unit;
  }
  for (std::size_t i = 0; i < damping_.size(); ++i)
    values[i] += mu * unit * damping_[i];
  return solver_.factor(lower_, pool);
}

bool DualSystem::factor_with(std::span<const double> inverse_weights,
                             std::span<const double> damping, ThreadPool& pool) {
  if (lower_.cols() == 0) return false;
  assemble(inverse_weights);
  for (int row = 0; row < lower_.cols(); ++row)
    lower_.valuePtr()[lower_.outerIndexPtr()[row]] += damping[static_cast<std::size_t>(row)];
  return solver_.factor(lower_, pool);
}

}  // namespace planish
