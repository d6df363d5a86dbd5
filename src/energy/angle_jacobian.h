#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <planish/core/vec.h>

#include <Eigen/Core>

#include "core/thread_pool.h"
#include "energy/hole_closing.h"
#include "geometry/angle_between.h"
#include "geometry/angle_gradient.h"

namespace planish {

/// The angle sums theta of the inner vertices, one row each, and A = d theta / d x: how they change
/// with the positions of the movable ones, three columns each (docs/methods/least_norm.md): inner
/// vertices, and those of the border where they may move. Inner vertices have the first numbers;
/// rows of a part have their own. Columns of what may not move hold zeros. Behind the angle sums
/// are three rows for each hole that is to close: minus the derivative of HoleLayout::defects(),
/// as the angle sums' is that of the angle defects.
class AngleJacobian {
 public:
  /// Which vertices are in which rows; the gradients are of no use before update().
  /// @param rings the neighbours of each inner vertex, in turn; must outlive it
  /// @param movable by column whether a vertex may move: by inner vertex, and by that of the border
  ///   if any of them may
  /// @param holes that are to close
  AngleJacobian(std::vector<std::span<const Index>> rings, std::vector<unsigned char> movable,
                std::vector<HoleBorder> holes = {});

  /// Some of the angle sums, with columns for some of the vertices. Its gradients are of no use
  /// before update().
  /// @param rows vertices whose rows these are, increasing
  /// @param movable by column, true only where it is true here
  AngleJacobian part(std::span<const Index> rows, std::span<const unsigned char> movable) const;

  /// @param row of an angle sum
  /// @param at the position of a vertex, by its number
  template <class At>
  double angle_sum(Index row, const At& at) const;
  /// Takes the gradients there.
  template <class At>
  void update(const At& at, ThreadPool& pool);

  std::size_t row_count() const { return angle_count() + 3 * holes_.size(); }
  /// Rows that are of angle sums: the first ones.
  std::size_t angle_count() const { return rings_.size(); }
  const std::vector<HoleBorder>& holes() const { return holes_; }
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
                std::vector<HoleBorder> holes, std::vector<Index> vertices);
  void find_columns();
  void add_to_hole_rows(std::size_t hole, Index v, const std::array<double, 3>& factors,
                        Vec3 gradient);
  template <class At>
  void update_hole(std::size_t hole, const At& at);

  std::vector<Index> vertex_of_;  // by row; none: the same numbers
  std::vector<std::span<const Index>> rings_;
  std::vector<unsigned char> movable_;
  std::vector<HoleBorder> holes_;
  // First entry of each row: the vertex, then its ring; of a hole the vertices around it.
  std::vector<std::size_t> row_start_;
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
  for (std::size_t hole = 0; hole < holes_.size(); ++hole)
    update_hole(hole, at);
}

/// Of the angles at its border and the lengths of its edges.
template <class At>
void AngleJacobian::update_hole(std::size_t hole, const At& at) {
  const HoleBorder& border = holes_[hole];
  const HoleLayout layout = laid_out(border, at);
  const double size = layout.closed().size;
  const std::size_t first_row = angle_count() + 3 * hole;
  std::fill(gradients_.begin() + static_cast<std::ptrdiff_t>(row_start_[first_row]),
            gradients_.begin() + static_cast<std::ptrdiff_t>(row_start_[first_row + 3]), Vec3{});
  for (std::size_t b = 0; b < border.loop.size(); ++b) {
    const Index v = border.loop[b], next = border.loop[b + 1 < border.loop.size() ? b + 1 : 0];
    const std::vector<Index>& ring = border.rings[b];
    const std::array<double, 3> by_angle = layout.by_angle(b, size);
    for (std::size_t j = 0; j + 1 < ring.size(); ++j) {
      const AngleGradient corner = angle_gradient(at(v), at(ring[j]), at(ring[j + 1]));
      add_to_hole_rows(hole, v, by_angle, corner.at_p);
      add_to_hole_rows(hole, ring[j], by_angle, corner.at_q);
      add_to_hole_rows(hole, ring[j + 1], by_angle, corner.at_r);
    }
    const Vec3 along = at(next) - at(v), direction = (1.0 / norm(along)) * along;
    const std::array<double, 3> by_length = layout.by_length(b, size);
    add_to_hole_rows(hole, next, by_length, direction);
    add_to_hole_rows(hole, v, by_length, -direction);
  }
}

}  // namespace planish
