#include "solve/sparse_pattern.h"

#include <algorithm>

namespace planish {

std::size_t entry_of(const SparseMatrix& lower, int i, int j) {
  const auto [column, row] = std::minmax({i, j});
  const int* rows = lower.innerIndexPtr();
  const int* begin = rows + lower.outerIndexPtr()[column];
  const int* end = rows + lower.outerIndexPtr()[column + 1];
  return static_cast<std::size_t>(std::lower_bound(begin, end, row) - rows);
}

Graph graph_of(const SparseMatrix& symmetric) {
  Graph graph;
  for (int v = 0; v < symmetric.outerSize(); ++v) {
    for (SparseMatrix::InnerIterator entry(symmetric, v); entry; ++entry) {
      if (entry.row() != v) graph.neighbours.push_back(static_cast<Index>(entry.row()));
    }
    graph.start.push_back(graph.neighbours.size());
  }
  return graph;
}

}  // namespace planish
