#pragma once

#include <cstddef>

#include "core/lanes/isa.h"

namespace planish {

constexpr std::size_t k_strip = 8;  // rows that are worked on at once, whatever the processor

/// A block of columns of a dense front that is being factored, and the front's rows from the
/// block's first one on, in strips of eight. All arrays are zero where they are padded.
struct FrontBlock {
  double* front;        ///< the block's first row and column in the front: A, then L
  std::size_t stride;   ///< from column to column of the front, a multiple of k_strip
  std::size_t width;    ///< columns
  std::size_t padded;   ///< the next multiple of k_strip; so many columns are there
  double* scaled;       ///< L D: a strip after the other, in each column after column
  double* packed;       ///< L likewise, in strips as high as a register has lanes
  double* pivots;       ///< D, `width` of them
  double* reciprocals;  ///< 1 / D, `padded` of them
};

/// Where a block's products are subtracted: the lower half of what belongs to the strips from
/// `first` on.
struct FrontTarget {
  double* corner;           ///< of row and column k_strip * first
  std::size_t stride;       ///< from column to column
  std::size_t first, last;  ///< strips of the block's front; as columns those before `last`
  bool fresh;               ///< nothing is there yet: what is written starts from zero
};

/// The parts of a factorization of dense fronts: L D L^T in blocks. Every entry sees its products
/// subtracted one after the other in the order of the columns, so that bits depend neither on the
/// set of instructions nor on blocks.
struct FrontKernel {
  /// The block's own rows. False where a pivot or its reciprocal is zero or not finite.
  bool (*factor_diagonal)(const FrontBlock& block);
  /// Strips below the diagonal part, once that is factored: any, in any order.
  void (*solve_strips)(const FrontBlock& block, std::size_t begin, std::size_t end);
  /// Rows of the target: strips that are solved, as all are that meet them as columns.
  void (*update_strips)(const FrontBlock& block, const FrontTarget& target, std::size_t begin,
                        std::size_t end);
};

FrontKernel front_kernel_for(Isa isa);

}  // namespace planish
