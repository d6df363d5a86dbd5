#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// The pattern of a symmetric matrix: for each row the columns before it that hold something.
struct LowerRows {
  std::vector<std::size_t> start = {0};
  std::vector<Index> columns;

  std::size_t count() const { return start.size() - 1; }
  std::span<const Index> of(std::size_t row) const {
    return {columns.data() + start[row], start[row + 1] - start[row]};
  }
};

/// The factor's columns in bundles that share their rows: supernode s has the columns from
/// first[s] to first[s + 1] - 1, and below them the rows rows(s). Children come before parents.
struct Supernodes {
  static constexpr Index k_root = static_cast<Index>(-1);

  std::vector<Index> first;  ///< and at the end the number of columns
  std::vector<Index> parent;
  std::vector<std::size_t> row_start;
  std::vector<Index> row_list;

  std::size_t count() const { return parent.size(); }
  Index width(std::size_t s) const { return first[s + 1] - first[s]; }
  /// Increasing, all behind the supernode's own columns.
  std::span<const Index> rows(std::size_t s) const {
    return {row_list.data() + row_start[s], row_start[s + 1] - row_start[s]};
  }
};

/// parent of each column in the elimination tree, Supernodes::k_root for roots (Liu 1990).
std::vector<Index> elimination_tree(const LowerRows& rows);

/// The columns so that children come before their parent and subtrees are contiguous.
std::vector<Index> postorder(std::span<const Index> parent);

/// Entries of each column of the factor, the diagonal among them, in nearly linear time (Gilbert,
/// Ng and Peyton 1994).
/// @param rows of a matrix whose elimination tree is in postorder
std::vector<Index> column_counts(const LowerRows& rows, std::span<const Index> parent);

/// Bundles of columns; small ones are merged where that adds few zeros.
/// @param rows of a matrix whose elimination tree is in postorder
Supernodes find_supernodes(const LowerRows& rows, std::span<const Index> parent);

}  // namespace planish
