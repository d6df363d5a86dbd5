#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// Places on a closed line by the length of the way to them from its first point, which goes round
/// and round: -1 is 1 before the start.
class BorderWalk {
 public:
  /// @param loop at least two points, not all at one place; must outlive the walk
  explicit BorderWalk(std::span<const Vec2> loop);

  double length() const { return reached_.back(); }
  /// The way to a point of the loop; of the point behind the last one: all of it.
  double way_to(std::size_t point) const { return reached_[point]; }
  Vec2 at(double way) const;

 private:
  std::span<const Vec2> loop_;
  std::vector<double> reached_;  // at each point, and at the first again
};

}  // namespace planish
