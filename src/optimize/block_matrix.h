#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "solve/graph.h"
#include "solve/sparse_ldlt.h"

namespace planish {

/// The lower half of a symmetric matrix whose unknowns come in blocks: the coordinates of a vertex,
/// or a multiplier. Which blocks meet is found once; terms are then added block by block.
class BlockMatrix {
 public:
  using VisitPair = std::function<void(Index, Index)>;
  /// Calls visit(a, b) for blocks that share entries, as often as it likes.
  using ForPairs = std::function<void(const VisitPair& visit)>;

  BlockMatrix() = default;
  /// Zero everywhere.
  /// @param sizes unknowns of each block, at most 3; 0 of what is held. Unknowns are numbered block
  ///   by block
  BlockMatrix(std::span<const unsigned char> sizes, const ForPairs& for_pairs);

  Index block_count() const { return static_cast<Index>(first_.size()) - 1; }
  int size(Index block) const { return first_[block + 1] - first_[block]; }
  /// The number of an unknown.
  int unknown(Index block, int part) const { return first_[block] + part; }
  const SparseMatrix& lower() const { return lower_; }
  void clear();

  /// Two blocks that meet.
  using Pair = std::uint32_t;
  static constexpr Pair k_none = ~Pair{0};
  /// @return k_none where a block is not there or they do not meet
  Pair pair_of(Index a, Index b) const;
  /// Those of blocks i < j of a term, in lexical order.
  template <std::size_t n>
  void append_pairs(const std::array<Index, n>& blocks, std::vector<Pair>& pairs) const {
    for_each_pair(
        n, [&](std::size_t i, std::size_t j) { pairs.push_back(pair_of(blocks[i], blocks[j])); });
  }
  /// Calls visit(i, j) for all i < j below a count, in lexical order.
  template <class Visit>
  static void for_each_pair(std::size_t count, Visit visit) {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i + 1; j < count; ++j)
        visit(i, j);
    }
  }

  /// The entries that a block has with itself in the column of one of its unknowns, from the
  /// diagonal down.
  double* own(Index block, int column) {
    return lower_.valuePtr() + lower_.outerIndexPtr()[first_[block] + column];
  }
  /// The entries of a pair in the column of an unknown of its first block, the one of the lower
  /// number: a row for each unknown of the second.
  double* entries(Index first, Pair pair, int column) {
    const int* starts = lower_.outerIndexPtr() + first_[first];
    return lower_.valuePtr() + pairs_[pair].start + (starts[column] - starts[0]) - column;
  }
  /// Adds a symmetric matrix over some blocks, of which entry(i, a, j, b) is that of unknown a of
  /// the i-th and b of the j-th.
  /// @param pairs as of append_pairs()
  template <std::size_t n, class Entry>
  void add(const std::array<Index, n>& blocks, const Pair* pairs, const Entry& entry) {
    for (std::size_t i = 0; i < n; ++i) {
      for (int column = 0; column < size(blocks[i]); ++column) {
        double* values = own(blocks[i], column) - column;
        for (int row = column; row < size(blocks[i]); ++row)
          values[row] += entry(i, row, i, column);
      }
    }
    for_each_pair(n, [&](std::size_t i, std::size_t j) {
      const Pair pair = *pairs++;
      const auto [first, second] = blocks[i] < blocks[j] ? std::pair{i, j} : std::pair{j, i};
      for (int column = 0; column < size(blocks[first]); ++column) {
        double* values = entries(blocks[first], pair, column);
        for (int row = 0; row < size(blocks[second]); ++row)
          values[row] += entry(second, row, first, column);
      }
    });
  }

  /// Calls visit(second, pair) for the pairs whose first block it is, by second block.
  template <class Visit>
  void for_pairs_of(Index first, Visit visit) const {
    for (std::size_t p = pair_start_[first]; p < pair_start_[first + 1]; ++p)
      visit(pairs_[p].second, static_cast<Pair>(p));
  }

 private:
  struct Entries {
    Index second;
    std::uint32_t start;  // in the first column of the first block
  };
  void find_pairs(const ForPairs& for_pairs);
  void lay_out();

  std::vector<int> first_ = {0};         // unknown of each block, and their count
  std::vector<std::size_t> pair_start_;  // by first block
  std::vector<Entries> pairs_;           // by first block, then by second
  SparseMatrix lower_;
};

}  // namespace planish
