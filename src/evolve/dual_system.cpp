#include "evolve/dual_system.h"

#include <algorithm>
#include <utility>

#include "solve/dissection.h"

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
    add_rows_of(row);
    for (const Index v : jacobian.ring(row))
      add_rows_of(v);
    graph.start.push_back(graph.neighbours.size());
  }
  return graph;
}

SparseMatrix lower_pattern(const Graph& graph) {
  const auto n = static_cast<int>(graph.vertex_count());
  std::vector<int> counts(graph.vertex_count(), 1);
  for (int v = 0; v < n; ++v) {
    for (const Index w : graph.of(static_cast<Index>(v)))
      counts[v] += static_cast<int>(w) > v ? 1 : 0;
  }
  SparseMatrix lower(n, n);
  lower.reserve(counts);
  std::vector<int> rows;
  for (int v = 0; v < n; ++v) {
    rows.assign(1, v);
    for (const Index w : graph.of(static_cast<Index>(v))) {
      if (static_cast<int>(w) > v) rows.push_back(static_cast<int>(w));
    }
    std::sort(rows.begin(), rows.end());
    for (const int row : rows)
      lower.insert(row, v) = 0.0;
  }
  lower.makeCompressed();
  return lower;
}

/// Of numbers of which there is at least one. Not their mean: rows grow as one over the square of
/// the length of an edge, and one short edge must not damp the whole patch.
double median(Eigen::VectorXd values) {
  auto* middle = values.data() + values.size() / 2;
  std::nth_element(values.data(), middle, values.data() + values.size());
  return *middle;
}

std::vector<Vec3> inner_positions(const PatchState& state) {
  std::vector<Vec3> positions;
  for (std::size_t v = 0; v < state.inner_count(); ++v)
    positions.push_back(state.position(v));
  return positions;
}

}  // namespace

DualSystem::Layout DualSystem::lay_out(const AngleJacobian& jacobian, const PatchState& state) {
  const Graph graph = rows_that_meet(jacobian);
  return {lower_pattern(graph), nested_dissection(inner_positions(state), graph)};
}

DualSystem::DualSystem(const AngleJacobian& jacobian, const PatchState& state)
    : DualSystem(jacobian, lay_out(jacobian, state)) {}

DualSystem::DualSystem(const AngleJacobian& jacobian, Layout layout)
    : jacobian_(jacobian), lower_(std::move(layout.lower)), solver_(lower_, layout.order) {
  const int* rows = lower_.innerIndexPtr();
  for (Index v = 0; v < jacobian.row_count(); ++v) {
    const auto entries = jacobian.column(v);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const int* begin = rows + lower_.outerIndexPtr()[entries[i].row];
      const int* end = rows + lower_.outerIndexPtr()[entries[i].row + 1];
      for (std::size_t j = i; j < entries.size(); ++j) {
        const int* place = std::lower_bound(begin, end, static_cast<int>(entries[j].row));
        products_.push_back(static_cast<std::uint32_t>(place - rows));
      }
    }
  }
}

bool DualSystem::factor(std::span<const double> squeeze, double mu) {
  double* values = lower_.valuePtr();
  std::fill_n(values, lower_.nonZeros(), 0.0);
  const std::uint32_t* place = products_.data();
  for (Index v = 0; v < jacobian_.row_count(); ++v) {
    const auto entries = jacobian_.column(v);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const Vec3 scaled = squeeze[v] * jacobian_.gradient(entries[i].entry);
      for (std::size_t j = i; j < entries.size(); ++j)
        values[*place++] += dot(scaled, jacobian_.gradient(entries[j].entry));
    }
  }
  const double unit = median(lower_.diagonal());
  if (!(unit > 0.0)) return false;
  for (int v = 0; v < lower_.cols(); ++v) {
    double& diagonal = values[lower_.outerIndexPtr()[v]];
    diagonal += mu * unit;
  }
  return solver_.factor(lower_);
}

}  // namespace planish
