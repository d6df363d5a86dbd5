#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <planish/core/vec.h>

#include <Eigen/Core>

#include "core/simd/stars.h"

namespace planish {

/// The vertices around one: those that move, and the inner ones whose angles change with them.
/// Ascending.
struct LocalRegion {
  std::vector<Index> active;       ///< V_act: up to `radius` rings away, and may move
  std::vector<Index> constrained;  ///< V_dev: up to one ring more

  /// The place of a vertex among the active ones, or their number if it is not one.
  std::size_t slot_of(Index v) const;
};

/// @param rings of the inner vertices, which are numbered first
LocalRegion region_around(Index center, int radius, std::span<const std::span<const Index>> rings,
                          const std::function<bool(Index)>& may_move);

/// d theta_q / d x for every constrained vertex q, a row each, by the coordinates of the active
/// vertices, three columns each.
Eigen::MatrixXd angle_rows(const LocalRegion& region, std::span<const std::span<const Index>> rings,
                           std::span<const Site> sites);

}  // namespace planish
