#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <planish/core/vec.h>

#include <Eigen/Core>

#include "core/thread_pool.h"
#include "evolve/state/patch_state.h"

namespace planish {

/// A = d theta / d x: how the angle sums of the inner vertices, one row each, change with the
/// positions of the movable ones, three columns each (methods: least_norm.md): inner vertices, and
/// those of the border where they may move. Numbers are those of the state, but rows of a part have
/// their own. Columns of what may not move hold zeros.
class AngleJacobian {
 public:
  /// Which vertices are in which rows; the gradients are of no use before update().
  /// @param state must outlive it
  /// @param border_movable by vertex of the border whether it may move; empty: none may
  explicit AngleJacobian(const PatchState& state,
                         std::span<const unsigned char> border_movable = {});

  /// Some of the rows, with columns for some of the vertices. Its gradients are of no use before
  /// update().
  /// @param rows vertices whose rows these are, increasing
  /// @param movable by column, true only where it is true here
  AngleJacobian part(std::span<const Index> rows, std::span<const unsigned char> movable) const;

  /// Takes the gradients at the positions where the vertices are now.
  void update(ThreadPool& pool);

  std::size_t row_count() const { return rings_.size(); }
  /// Inner vertices, and those of the border if any of them may move.
  std::size_t column_count() const { return movable_.size(); }
  /// True for vertices that nothing holds. Inner vertices of many hundred neighbours are held too:
  /// each would tie all its neighbours' rows to one another.
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
  AngleJacobian(const PatchState& state, std::vector<Index> vertices,
                std::vector<std::span<const Index>> rings, std::vector<unsigned char> movable);
  void lay_out();
  void find_columns();

  const PatchState& state_;
  std::vector<Index> vertex_of_;  // by row; none: the same numbers
  std::vector<std::span<const Index>> rings_;
  std::vector<unsigned char> movable_;
  std::vector<std::size_t> row_start_;  // first entry of each row: the vertex, then its ring
  std::vector<Vec3> gradients_;
  std::vector<std::size_t> column_start_;
  std::vector<Entry> columns_;
};

}  // namespace planish
