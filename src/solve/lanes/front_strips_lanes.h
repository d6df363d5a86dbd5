// Included by one source file for each set of instructions.
#pragma once

#include "core/lanes/lanes.h"
#include "solve/lanes/front_strips.h"

namespace planish::PLANISH_ISA {

// A tile is a strip high and as many columns wide as a register has lanes: eight registers.
constexpr std::size_t k_width = PLANISH_LANES;
constexpr std::size_t k_parts = k_strip / k_width;  // registers in a column of a strip

inline Real load(const double* from) {
  Real x;
  __builtin_memcpy(&x, from, sizeof x);
  return x;
}

inline void store(Real x, double* to) {
  __builtin_memcpy(to, &x, sizeof x);
}

/// As all(), but a plain copy: all() adds to zero, which makes +0 of -0 and takes an instruction.
inline Real spread(double x) {
  return x - Real{};
}

struct Tile {
  Real at[k_width][k_parts];
};

inline void load_tile(const double* from, std::size_t stride, Tile& tile) {
  for (std::size_t c = 0; c < k_width; ++c) {
    for (std::size_t p = 0; p < k_parts; ++p)
      tile.at[c][p] = load(from + c * stride + p * k_width);
  }
}

inline void store_tile(const Tile& tile, double* to, std::size_t stride) {
  for (std::size_t c = 0; c < k_width; ++c) {
    for (std::size_t p = 0; p < k_parts; ++p)
      store(tile.at[c][p], to + c * stride + p * k_width);
  }
}

/// tile -= scaled packed^T over `count` columns of the block.
inline void subtract_products(const double* scaled, const double* packed, std::size_t count,
                              Tile& tile) {
  Tile sum = tile;
  for (std::size_t k = 0; k < count; ++k, scaled += k_strip, packed += k_width) {
    Real rows[k_parts];
    for (std::size_t p = 0; p < k_parts; ++p)
      rows[p] = load(scaled + p * k_width);
    for (std::size_t c = 0; c < k_width; ++c) {
      const Real factor = spread(packed[c]);
      for (std::size_t p = 0; p < k_parts; ++p)
        sum.at[c][p] -= rows[p] * factor;
    }
  }
  tile = sum;
}

inline double* scaled_of(const FrontBlock& block, std::size_t strip) {
  return block.scaled + strip * k_strip * block.padded;
}

/// Of the rows from k_width * group on.
inline double* packed_of(const FrontBlock& block, std::size_t group) {
  return block.packed + group * k_width * block.padded;
}

/// One column of L D in one strip: into all arrays.
inline void keep_column(const FrontBlock& block, std::size_t strip, std::size_t column,
                        const Real* scaled) {
  double* to_scaled = scaled_of(block, strip) + column * k_strip;
  double* to_front = block.front + column * block.stride + strip * k_strip;
  for (std::size_t p = 0; p < k_parts; ++p) {
    const Real l = scaled[p] * block.reciprocals[column];
    store(scaled[p], to_scaled + p * k_width);
    store(l, to_front + p * k_width);
    store(l, packed_of(block, strip * k_parts + p) + column * k_width);
  }
}

/// The first columns of a strip, a multiple of k_strip of them, against their diagonal part.
[[gnu::flatten]] inline void solve_columns(const FrontBlock& block, std::size_t strip,
                                           std::size_t columns) {
  for (std::size_t j = 0; j < columns; j += k_width) {
    const double* diagonal = packed_of(block, j / k_width);
    Tile tile;
    load_tile(block.front + j * block.stride + strip * k_strip, block.stride, tile);
    subtract_products(scaled_of(block, strip), diagonal, j, tile);
    diagonal += j * k_width;
    for (std::size_t c = 0; c < k_width; ++c) {
      for (std::size_t before = 0; before < c; ++before) {
        const Real factor = spread(diagonal[before * k_width + c]);
        for (std::size_t p = 0; p < k_parts; ++p)
          tile.at[c][p] -= tile.at[before][p] * factor;
      }
      keep_column(block, strip, j + c, tile.at[c]);
    }
  }
}

/// Factors the tile of a strip that is on the diagonal: its first `columns`.
inline bool factor_corner(const FrontBlock& block, std::size_t strip, std::size_t columns,
                          Real (&corner)[k_strip][k_parts]) {
  for (std::size_t k = 0; k < k_strip; ++k) {
    const std::size_t column = strip * k_strip + k;
    if (k >= columns) {
      block.reciprocals[column] = 0.0;
      keep_column(block, strip, column, corner[k]);
      continue;
    }
    const double pivot = corner[k][k / k_width][k % k_width], reciprocal = 1.0 / pivot;
    if (!(pivot != 0.0) || !__builtin_isfinite(pivot) || !__builtin_isfinite(reciprocal))
      return false;
    block.pivots[column] = pivot;
    block.reciprocals[column] = reciprocal;
    keep_column(block, strip, column, corner[k]);
    for (std::size_t j = k + 1; j < columns; ++j) {
      const Real factor =
          all(packed_of(block, strip * k_parts + j / k_width)[column * k_width + j % k_width]);
      for (std::size_t p = 0; p < k_parts; ++p)
        corner[j][p] -= corner[k][p] * factor;
    }
  }
  return true;
}

[[gnu::flatten]] inline bool factor_diagonal(const FrontBlock& block) {
  for (std::size_t strip = 0; strip * k_strip < block.width; ++strip) {
    const std::size_t start = strip * k_strip, left = block.width - start;
    solve_columns(block, strip, start);
    Real corner[k_strip][k_parts];
    for (std::size_t c = 0; c < k_strip; c += k_width) {
      Tile tile;
      load_tile(block.front + (start + c) * block.stride + start, block.stride, tile);
      subtract_products(scaled_of(block, strip), packed_of(block, (start + c) / k_width), start,
                        tile);
      for (std::size_t i = 0; i < k_width; ++i) {
        for (std::size_t p = 0; p < k_parts; ++p)
          corner[c + i][p] = tile.at[i][p];
      }
    }
    if (!factor_corner(block, strip, left < k_strip ? left : k_strip, corner)) return false;
  }
  return true;
}

inline void solve_strips(const FrontBlock& block, std::size_t begin, std::size_t end) {
  for (std::size_t strip = begin; strip < end; ++strip)
    solve_columns(block, strip, block.padded);
}

[[gnu::flatten]] inline void update_strips(const FrontBlock& block, const FrontTarget& target,
                                           std::size_t begin, std::size_t end) {
  for (std::size_t strip = begin; strip < end; ++strip) {
    const std::size_t last = strip < target.last ? strip + 1 : target.last;
    double* row = target.corner + (strip - target.first) * k_strip;
    for (std::size_t group = target.first * k_parts; group < last * k_parts; ++group) {
      double* to = row + (group - target.first * k_parts) * k_width * target.stride;
      Tile tile{};
      if (!target.fresh) load_tile(to, target.stride, tile);
      subtract_products(scaled_of(block, strip), packed_of(block, group), block.width, tile);
      store_tile(tile, to, target.stride);
    }
  }
}

}  // namespace planish::PLANISH_ISA
