#pragma once

#include <cstddef>

#include "core/simd/isa.h"

namespace planish {

/// Rows that are worked on at once, whatever the processor: a line of cache. T is double or float
/// in all of this.
template <class T>
constexpr std::size_t k_strip = 64 / sizeof(T);

/// A block of columns of a dense front that is being factored, and the front's rows from the
/// block's first one on, in strips. All arrays are zero where they are padded.
template <class T>
struct FrontBlock {
  T* front;            ///< the block's first row and column in the front: A, then L
  std::size_t stride;  ///< from column to column of the front, a multiple of k_strip
  std::size_t width;   ///< columns
  std::size_t padded;  ///< the next multiple of k_strip; so many columns are there
  T* scaled;           ///< L D: a strip after the other, in each column after column
  T* packed;           ///< L likewise, in strips as high as a tile is wide
  T* pivots;           ///< D, `width` of them
  T* reciprocals;      ///< 1 / D, `padded` of them
};

/// Where a block's products are subtracted: the lower half of what belongs to the strips from
/// `first` on.
template <class T>
struct FrontTarget {
  T* corner;                ///< of row and column k_strip * first
  std::size_t stride;       ///< from column to column
  std::size_t first, last;  ///< strips of the block's front; as columns those before `last`
  bool fresh;               ///< nothing is there yet: what is written starts from zero
};

/// The parts of a factorization of dense fronts: L D L^T in blocks. Every entry sees its products
/// subtracted one after the other in the order of the columns, so that bits depend neither on the
/// set of instructions nor on blocks.
template <class T>
struct FrontKernel {
  /// The block's own rows. False where a pivot or its reciprocal is zero or not finite.
  bool (*factor_diagonal)(const FrontBlock<T>& block);
  /// Strips below the diagonal part, once that is factored: any, in any order.
  void (*solve_strips)(const FrontBlock<T>& block, std::size_t begin, std::size_t end);
  /// Rows of the target: strips that are solved, as all are that meet them as columns.
  void (*update_strips)(const FrontBlock<T>& block, const FrontTarget<T>& target, std::size_t begin,
                        std::size_t end);
};

template <class T>
FrontKernel<T> front_kernel_for(Isa isa);

/// For one set of instructions.
struct FrontKernels {
  FrontKernel<double> of_double;
  FrontKernel<float> of_float;
};

}  // namespace planish
