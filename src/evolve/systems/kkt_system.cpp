#include "evolve/systems/kkt_system.h"

#include <algorithm>

#include "solve/dissection.h"
#include "solve/sparse_pattern.h"

namespace planish {

namespace {

constexpr int k_unknowns = 4;  // of a vertex: x, y, z, multiplier
constexpr int k_multiplier = 3;

int unknown(Index v, int part) {
  return k_unknowns * static_cast<int>(v) + part;
}

/// The inner neighbours of each inner vertex.
Graph inner_graph(const AngleJacobian& jacobian) {
  Graph graph;
  for (Index v = 0; v < jacobian.row_count(); ++v) {
    for (const Index w : jacobian.ring(v)) {
      if (w < jacobian.row_count()) graph.neighbours.push_back(w);
    }
    graph.start.push_back(graph.neighbours.size());
  }
  return graph;
}

/// The lower half, with what never changes in it.
SparseMatrix constant_part(const AngleJacobian& jacobian, const SparseMatrix& hessian) {
  const auto n = static_cast<Index>(jacobian.row_count());
  std::vector<Eigen::Triplet<double>> entries;
  for (Index v = 0; v < n; ++v) {
    for (int part = 0; part < k_unknowns; ++part) {
      // What is held: its own equation says that it does not move.
      const bool held = !jacobian.is_movable(v) || part == k_multiplier;
      entries.emplace_back(unknown(v, part), unknown(v, part), held ? 1.0 : 0.0);
    }
    for (const AngleJacobian::Entry& entry : jacobian.column(v)) {
      for (int part = 0; part < k_multiplier; ++part) {
        const auto [column, row] =
            std::minmax({unknown(v, part), unknown(entry.row, k_multiplier)});
        entries.emplace_back(row, column, 0.0);
      }
    }
  }
  for (int j = 0; j < hessian.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator entry(hessian, j); entry; ++entry) {
      const auto v = static_cast<Index>(j), w = static_cast<Index>(entry.row());
      if (w < v || !jacobian.is_movable(v) || !jacobian.is_movable(w)) continue;
      for (int part = 0; part < k_multiplier; ++part)
        entries.emplace_back(unknown(w, part), unknown(v, part), entry.value());
    }
  }
  const int size = k_unknowns * static_cast<int>(n);
  SparseMatrix lower(size, size);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

std::vector<Index> elimination_order(const AngleJacobian& jacobian, const PatchState& state) {
  std::vector<Index> order;
  for (const Index v : nested_dissection(inner_positions(state), inner_graph(jacobian))) {
    for (int part = 0; part < k_unknowns; ++part)
      order.push_back(static_cast<Index>(unknown(v, part)));
  }
  return order;
}

}  // namespace

KktSystem::KktSystem(const AngleJacobian& jacobian, const PatchState& state,
                     const SparseMatrix& hessian)
    : jacobian_(jacobian),
      lower_(constant_part(jacobian, hessian)),
      solver_(lower_, elimination_order(jacobian, state)) {
  for (Index v = 0; v < jacobian.row_count(); ++v) {
    for (const AngleJacobian::Entry& entry : jacobian.column(v)) {
      for (int part = 0; part < k_multiplier; ++part) {
        gradient_entries_.push_back(
            entry_of(lower_, unknown(entry.row, k_multiplier), unknown(v, part)));
      }
    }
  }
}

bool KktSystem::factor(double mu, ThreadPool& pool) {
  double* values = lower_.valuePtr();
  const std::size_t* place = gradient_entries_.data();
  double squares = 0.0;
  for (Index v = 0; v < jacobian_.row_count(); ++v) {
    for (const AngleJacobian::Entry& entry : jacobian_.column(v)) {
      const Vec3 gradient = jacobian_.gradient(entry.entry);
      squares += dot(gradient, gradient);
      for (const double part : {gradient.x, gradient.y, gradient.z})
        values[*place++] = part;
    }
  }
  const double mean = squares / static_cast<double>(jacobian_.row_count());
  if (!(mean > 0.0)) return false;
  for (Index v = 0; v < jacobian_.row_count(); ++v)
    values[lower_.outerIndexPtr()[unknown(v, k_multiplier)]] = -mu * mean;
  return solver_.factor(lower_, pool);
}

Positions KktSystem::solve(const Positions& force, const Eigen::VectorXd& angle_change,
                           ThreadPool& pool) const {
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(lower_.rows(), 1);
  for (Index v = 0; v < jacobian_.row_count(); ++v) {
    const bool movable = jacobian_.is_movable(v);
    right(unknown(v, 0), 0) = movable ? force[v].x : 0.0;
    right(unknown(v, 1), 0) = movable ? force[v].y : 0.0;
    right(unknown(v, 2), 0) = movable ? force[v].z : 0.0;
    right(unknown(v, k_multiplier), 0) = angle_change[v];
  }
  const Eigen::MatrixXd solution = solver_.solve(right, pool);
  Positions move(jacobian_.row_count());
  for (Index v = 0; v < move.size(); ++v) {
    move[v] = {solution(unknown(v, 0), 0), solution(unknown(v, 1), 0), solution(unknown(v, 2), 0)};
  }
  return move;
}

}  // namespace planish
