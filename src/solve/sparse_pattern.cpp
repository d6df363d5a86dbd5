#include "solve/sparse_pattern.h"

namespace planish {

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
