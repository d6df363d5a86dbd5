#pragma once

#include <cstddef>

#include "solve/graph.h"
#include "solve/sparse_ldlt.h"

namespace planish {

/// Where the entry (i, j) of a symmetric matrix lies among the values of its lower half.
/// @pre the lower half has it, rows in order
std::size_t entry_of(const SparseMatrix& lower, int i, int j);

/// Who shares an entry with whom, of a symmetric matrix of which both halves are there.
Graph graph_of(const SparseMatrix& symmetric);

}  // namespace planish
