#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/core/vec.h>

#include "solve/sparse_ldlt.h"

namespace planish {

/// A sparse matrix A whose rows have few entries, for A^T A. What is added to one place is summed
/// in the order in which it is added.
class GramMatrix {
 public:
  struct Entry {
    Index row, column;
    double value;
  };

  GramMatrix(std::size_t rows, std::size_t columns, std::span<const Entry> entries);

  /// The lower half of A^T A.
  SparseMatrix lower() const;
  /// A x.
  std::vector<double> times(const Eigen::VectorXd& x) const;

 private:
  struct Term {
    Index other;  // column in a row, row in a column
    double value;
  };
  /// The terms of each row, or of each column, one after the other.
  struct Lists {
    std::vector<std::size_t> start;
    std::vector<Term> terms;
    std::span<const Term> of(std::size_t k) const {
      return {terms.data() + start[k], start[k + 1] - start[k]};
    }
  };

  Lists rows_, columns_;
};

}  // namespace planish
