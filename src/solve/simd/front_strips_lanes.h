// Included by one source file for each set of instructions.
#pragma once

#include "core/simd/simd.h"
#include "solve/simd/front_strips.h"

namespace planish::PLANISH_ISA {

template <class T>
struct RegisterOf;
template <>
struct RegisterOf<double> {
  using Type = Real;
};
template <>
struct RegisterOf<float> {
  using Type = float __attribute__((vector_size(8 * PLANISH_LANES)));
};
template <class T>
using Register = typename RegisterOf<T>::Type;

// A tile is a strip high and as wide as eight registers hold.
template <class T>
constexpr std::size_t k_width = PLANISH_LANES*(sizeof(double) / sizeof(T));  // of a register
template <class T>
constexpr std::size_t k_parts = k_strip<T> / k_width<T>;  // registers in a column of a strip
template <class T>
constexpr std::size_t k_columns = 8 / k_parts<T>;  // of a tile
template <class T>
constexpr std::size_t k_groups = k_strip<T> / k_columns<T>;  // tiles that a strip's rows are wide

template <class T>
inline Register<T> load(const T* from) {
  Register<T> x;
  __builtin_memcpy(&x, from, sizeof x);
  return x;
}

template <class T>
inline void store(const Register<T>& x, T* to) {
  __builtin_memcpy(to, &x, sizeof x);
}

/// As all(), but a plain copy: all() adds to zero, which makes +0 of -0 and takes an instruction.
template <class T>
inline Register<T> spread(T x) {
  return x - Register<T>{};
}

template <class T>
struct Tile {
  Register<T> at[k_columns<T>][k_parts<T>];
};

template <class T>
inline void load_tile(const T* from, std::size_t stride, Tile<T>& tile) {
  for (std::size_t c = 0; c < k_columns<T>; ++c) {
    for (std::size_t p = 0; p < k_parts<T>; ++p)
      tile.at[c][p] = load(from + c * stride + p * k_width<T>);
  }
}

template <class T>
inline void store_tile(const Tile<T>& tile, T* to, std::size_t stride) {
  for (std::size_t c = 0; c < k_columns<T>; ++c) {
    for (std::size_t p = 0; p < k_parts<T>; ++p)
      store(tile.at[c][p], to + c * stride + p * k_width<T>);
  }
}

/// tile -= scaled packed^T over `count` columns of the block.
template <class T>
inline void subtract_products(const T* scaled, const T* packed, std::size_t count, Tile<T>& tile) {
  Tile<T> sum = tile;
  for (std::size_t k = 0; k < count; ++k, scaled += k_strip<T>, packed += k_columns<T>) {
    Register<T> rows[k_parts<T>];
    for (std::size_t p = 0; p < k_parts<T>; ++p)
      rows[p] = load(scaled + p * k_width<T>);
    for (std::size_t c = 0; c < k_columns<T>; ++c) {
      const Register<T> factor = spread(packed[c]);
      for (std::size_t p = 0; p < k_parts<T>; ++p)
        sum.at[c][p] -= rows[p] * factor;
    }
  }
  tile = sum;
}

template <class T>
inline T* scaled_of(const FrontBlock<T>& block, std::size_t strip) {
  return block.scaled + strip * k_strip<T> * block.padded;
}

/// Of the rows from k_columns * group on.
template <class T>
inline T* packed_of(const FrontBlock<T>& block, std::size_t group) {
  return block.packed + group * k_columns<T> * block.padded;
}

/// Rows of one column of L, those of a register, to where tiles find them.
template <class T>
inline void pack(const FrontBlock<T>& block, std::size_t row, std::size_t column,
                 const Register<T>& l) {
  for (std::size_t i = 0; i < k_width<T>; i += k_columns<T>) {
    T* to = packed_of(block, (row + i) / k_columns<T>) + column * k_columns<T>;
    __builtin_memcpy(to, reinterpret_cast<const T*>(&l) + i, k_columns<T> * sizeof(T));
  }
}

/// One column of L D in one strip: into all arrays.
template <class T>
inline void keep_column(const FrontBlock<T>& block, std::size_t strip, std::size_t column,
                        const Register<T>* scaled) {
  T* to_scaled = scaled_of(block, strip) + column * k_strip<T>;
  T* to_front = block.front + column * block.stride + strip * k_strip<T>;
  for (std::size_t p = 0; p < k_parts<T>; ++p) {
    const Register<T> l = scaled[p] * block.reciprocals[column];
    store(scaled[p], to_scaled + p * k_width<T>);
    store(l, to_front + p * k_width<T>);
    pack(block, strip * k_strip<T> + p * k_width<T>, column, l);
  }
}

/// The first columns of a strip, a multiple of k_strip of them, against their diagonal part.
template <class T>
[[gnu::flatten]] inline void solve_columns(const FrontBlock<T>& block, std::size_t strip,
                                           std::size_t columns) {
  for (std::size_t j = 0; j < columns; j += k_columns<T>) {
    const T* diagonal = packed_of(block, j / k_columns<T>);
    Tile<T> tile;
    load_tile(block.front + j * block.stride + strip * k_strip<T>, block.stride, tile);
    subtract_products(scaled_of(block, strip), diagonal, j, tile);
    diagonal += j * k_columns<T>;
    for (std::size_t c = 0; c < k_columns<T>; ++c) {
      for (std::size_t before = 0; before < c; ++before) {
        const Register<T> factor = spread(diagonal[before * k_columns<T> + c]);
        for (std::size_t p = 0; p < k_parts<T>; ++p)
          tile.at[c][p] -= tile.at[before][p] * factor;
      }
      keep_column(block, strip, j + c, tile.at[c]);
    }
  }
}

/// Factors the tile of a strip that is on the diagonal: its first `columns`.
template <class T>
inline bool factor_corner(const FrontBlock<T>& block, std::size_t strip, std::size_t columns,
                          Register<T> (&corner)[k_strip<T>][k_parts<T>]) {
  for (std::size_t k = 0; k < k_strip<T>; ++k) {
    const std::size_t column = strip * k_strip<T> + k;
    if (k >= columns) {
      block.reciprocals[column] = T{};
      keep_column(block, strip, column, corner[k]);
      continue;
    }
    const T pivot = corner[k][k / k_width<T>][k % k_width<T>], reciprocal = T{1} / pivot;
    if (!(pivot != T{}) || !__builtin_isfinite(pivot) || !__builtin_isfinite(reciprocal))
      return false;
    block.pivots[column] = pivot;
    block.reciprocals[column] = reciprocal;
    keep_column(block, strip, column, corner[k]);
    for (std::size_t j = k + 1; j < columns; ++j) {
      const T* packed = packed_of(block, strip * k_groups<T> + j / k_columns<T>);
      const Register<T> factor = Register<T>{} + packed[column * k_columns<T> + j % k_columns<T>];
      for (std::size_t p = 0; p < k_parts<T>; ++p)
        corner[j][p] -= corner[k][p] * factor;
    }
  }
  return true;
}

template <class T>
[[gnu::flatten]] inline bool factor_diagonal(const FrontBlock<T>& block) {
  for (std::size_t strip = 0; strip * k_strip<T> < block.width; ++strip) {
    const std::size_t start = strip * k_strip<T>, left = block.width - start;
    solve_columns(block, strip, start);
    Register<T> corner[k_strip<T>][k_parts<T>];
    for (std::size_t c = 0; c < k_strip<T>; c += k_columns<T>) {
      Tile<T> tile;
      load_tile(block.front + (start + c) * block.stride + start, block.stride, tile);
      subtract_products(scaled_of(block, strip), packed_of(block, (start + c) / k_columns<T>),
                        start, tile);
      for (std::size_t i = 0; i < k_columns<T>; ++i) {
        for (std::size_t p = 0; p < k_parts<T>; ++p)
          corner[c + i][p] = tile.at[i][p];
      }
    }
    if (!factor_corner(block, strip, left < k_strip<T> ? left : k_strip<T>, corner)) return false;
  }
  return true;
}

template <class T>
inline void solve_strips(const FrontBlock<T>& block, std::size_t begin, std::size_t end) {
  for (std::size_t strip = begin; strip < end; ++strip)
    solve_columns(block, strip, block.padded);
}

template <class T>
[[gnu::flatten]] inline void update_strips(const FrontBlock<T>& block, const FrontTarget<T>& target,
                                           std::size_t begin, std::size_t end) {
  for (std::size_t strip = begin; strip < end; ++strip) {
    const std::size_t last = strip < target.last ? strip + 1 : target.last;
    T* row = target.corner + (strip - target.first) * k_strip<T>;
    for (std::size_t group = target.first * k_groups<T>; group < last * k_groups<T>; ++group) {
      T* to = row + (group - target.first * k_groups<T>)*k_columns<T> * target.stride;
      Tile<T> tile{};
      if (!target.fresh) load_tile(to, target.stride, tile);
      subtract_products(scaled_of(block, strip), packed_of(block, group), block.width, tile);
      store_tile(tile, to, target.stride);
    }
  }
}

template <class T>
FrontKernel<T> front_kernel() {
  return {factor_diagonal<T>, solve_strips<T>, update_strips<T>};
}

inline FrontKernels front_kernels() {
  return {front_kernel<double>(), front_kernel<float>()};
}

}  // namespace planish::PLANISH_ISA
