#pragma once

#include <vector>

#include "solve/graph.h"
#include "solve/sparse_ldlt.h"

namespace planish {

/// The matrix of the entries that for_entries(add) adds with add(row, column, value): those of one
/// place are summed.
template <class ForEntries>
SparseMatrix sparse_matrix(std::size_t rows, std::size_t columns, const ForEntries& for_entries) {
  std::vector<Eigen::Triplet<double>> entries;
  for_entries([&](std::size_t row, std::size_t column, double value) {
    entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  });
  SparseMatrix matrix(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Calls visit(row, column, value) for the entries of a matrix, column after column.
template <class Visit>
void for_entries_of(const SparseMatrix& matrix, const Visit& visit) {
  for (int j = 0; j < matrix.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator entry(matrix, j); entry; ++entry)
      visit(static_cast<Index>(entry.row()), static_cast<Index>(j), entry.value());
  }
}

/// Who shares an entry with whom, of a symmetric matrix of which both halves are there.
Graph graph_of(const SparseMatrix& symmetric);

}  // namespace planish
