#pragma once

#include <cstddef>

#include "core/buffer.h"
#include "core/thread_pool.h"
#include "solve/simd/front_strips.h"

namespace planish {

/// A dense symmetric matrix, of double or float, of which the first columns are to be factored, in
/// strips of k_strip rows: those of the columns are filled up with zeros to whole strips, and so is
/// the rest.
template <class T>
struct FrontShape {
  std::size_t columns = 0, rest = 0;

  static constexpr std::size_t padded(std::size_t rows) {
    return (rows + k_strip<T> - 1) / k_strip<T> * k_strip<T>;
  }
  /// Of the rest, from column to column.
  std::size_t rest_stride() const { return padded(rest); }
  /// Of the columns to factor.
  std::size_t stride() const { return padded(columns) + rest_stride(); }
  /// Where a row lies, counted from 0 without the zeros.
  std::size_t place(std::size_t row) const {
    return row < columns ? row : row + padded(columns) - columns;
  }
  /// Numbers in the columns to factor, in the rest, and in each half of what factoring takes
  /// beside.
  std::size_t panel_size() const { return stride() * padded(columns); }
  std::size_t rest_size() const { return rest_stride() * rest_stride(); }
  std::size_t beside_size() const;
};

/// Uninitialised numbers, aligned to cache lines.
template <class T>
class FrontBuffer {
 public:
  FrontBuffer() = default;
  explicit FrontBuffer(std::size_t size) : lines_(FrontShape<T>::padded(size) / k_strip<T>) {}

  T* data() { return lines_.size() == 0 ? nullptr : lines_.data()->at; }

 private:
  struct alignas(64) Line {
    T at[k_strip<T>];
  };
  Buffer<Line> lines_;
};

/// What fronts that are factored one after the other share.
template <class T>
struct FrontSpace {
  FrontBuffer<T> panel, scaled, packed;
};

/// Factors the first columns of a front, of which the lower half is read and written: L appears
/// below their diagonal, unit lower triangular; what is on and above it loses its meaning.
/// @param space whose panel holds the columns to factor, zero where they are padded
/// @param pivots as many as columns to factor; D is written there
/// @param rest becomes minus L D L^T of the rows below, its lower half: the Schur complement where
///   nothing is there before
/// @return false where a pivot or its reciprocal is zero or not finite
template <class T>
bool factor_front(const FrontShape<T>& shape, const FrontKernel<T>& kernel, FrontSpace<T>& space,
                  T* pivots, T* rest, ThreadPool& pool);

}  // namespace planish
