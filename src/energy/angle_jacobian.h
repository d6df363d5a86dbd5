#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <planish/core/vec.h>

#include <Eigen/Core>

#include "core/thread_pool.h"
#include "geometry/angle_between.h"
#include "geometry/angle_gradient.h"

namespace planish {

/// The angle sums theta of the inner vertices, one row each, and A = d theta / d x: how they change
/// with the positions of the movable ones, three columns each (docs/methods/least_norm.md): inner
/// vertices, and those of the border where they may move. Inner vertices have the first numbers;
/// rows of a part have their own. Columns of what may not move hold zeros.
class AngleJacobian {
 public:
  /// Which vertices are in which rows; the gradients are of no use before update().
  /// @param rings the neighbours of each inner vertex, in turn; must outlive it
  /// @param movable by column whether a vertex may move: by inner vertex, and by that of the border
  ///   if any of them may
  AngleJacobian(std::vector<std::span<const Index>> rings, std::vector<unsigned char> movable);

  /// Some of the rows, with columns for some of the vertices. Its gradients are of no use before
  /// update().
  /// @param rows vertices whose rows these are, increasing
  /// @param movable by column, true only where it is true here
  AngleJacobian part(std::span<const Index> rows, std::span<const unsigned char> movable) const;

  /// The angle sum of a row. @param at the position of a vertex, by its number
  template <class At>
  double angle_sum(Index row, const At& at) const;
  /// Takes the gradients there.
  template <class At>
  void update(const At& at, ThreadPool& pool);

  std::size_t row_count() const { return rings_.size(); }
  /// Inner vertices, and those of the border if any of them may move.
  std::size_t column_count() const { return movable_.size(); }
  /// True for vertices that nothing holds.
  bool is_movable(Index v) const { return v < column_count() && movable_[v] != 0; }
  /// The same by column.
  std::span<const unsigned char> movable() const { return movable_; }
  /// The inner vertex whose angle sum a row is: of the same number, unless this is a part.
  Index vertex_of(Index row) const { return vertex_of_.empty() ? row : vertex_of_[row]; }
  /// Of that vertex.
  std::span<const Index> ring(Index row) const { return rings_[row]; }

  /// A part of a row: d theta_row / d x of some vertex is gradient(entry).
  struct Entry {
    Index row;
    std::uint32_t entry;
  };
  /// The rows that a movable vertex is in, increasing.
  std::span<const Entry> column(Index v) const {
    return {columns_.data() + column_start_[v], column_start_[v + 1] - column_start_[v]};
  }
  Vec3 gradient(std::size_t entry) const { return gradients_[entry]; }

  /// A dx, for dx by column.
  Eigen::VectorXd times(std::span<const Vec3> dx) const;
  /// A^T y, by column.
  std::vector<Vec3> transposed_times(const Eigen::VectorXd& y, ThreadPool& pool) const;

 private:
  AngleJacobian(std::vector<std::span<const Index>> rings, std::vector<unsigned char> movable,
                std::vector<Index> vertices);
  void find_columns();

  std::vector<Index> vertex_of_;  // by row; none: the same numbers
  std::vector<std::span<const Index>> rings_;
  std::vector<unsigned char> movable_;
  std::vector<std::size_t> row_start_;  // first entry of each row: the vertex, then its ring
  std::vector<Vec3> gradients_;
  std::vector<std::size_t> column_start_;
  std::vector<Entry> columns_;
};

template <class At>
double AngleJacobian::angle_sum(Index row, const At& at) const {
  const auto ring = rings_[row];
  const Vec3 p = at(vertex_of(row));
  Vec3 last = at(ring.back()) - p;
  double sum = 0.0;
  for (const Index w : ring) {
    const Vec3 next = at(w) - p;
    sum += angle_between(last, next);
    last = next;
  }
  return sum;
}

template <class At>
void AngleJacobian::update(const At& at, ThreadPool& pool) {
  pool.for_ranges(rings_.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const Index v = vertex_of(static_cast<Index>(row));
      const auto ring = rings_[row];
      Vec3* gradient = gradients_.data() + row_start_[row];
      std::fill_n(gradient, 1 + ring.size(), Vec3{});
      const Vec3 p = at(v);
      for (std::size_t j = 0; j < ring.size(); ++j) {
        const std::size_t k = j + 1 < ring.size() ? j + 1 : 0;
        const AngleGradient corner = angle_gradient(p, at(ring[j]), at(ring[k]));
        gradient[0] += corner.at_p;
        gradient[1 + j] += corner.at_q;
        gradient[1 + k] += corner.at_r;
      }
      if (!is_movable(v)) gradient[0] = {};
      for (std::size_t j = 0; j < ring.size(); ++j) {
        if (!is_movable(ring[j])) gradient[1 + j] = {};
      }
    }
  });
}

}  // namespace planish
