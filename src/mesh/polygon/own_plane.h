#pragma once

#include <span>

#include <planish/core/vec.h>

namespace planish {

/// The plane of a polygon's area vector, seen so that it turns counter-clockwise.
class OwnPlane {
 public:
  enum class Shape {
    polygon,  ///< place() can be asked
    line,     ///< all corners are on one line
    none,     ///< there is no such plane: the polygon crosses itself, and its parts cancel out
  };

  /// @param corners at least 3 places, which are finite
  explicit OwnPlane(std::span<const Vec3> corners);

  Shape shape() const { return shape_; }

  /// Where one of the corners is in the plane: whole numbers up to 2^51, as side_of() needs them,
  /// for a polygon of any size. Equal corners stay equal.
  Vec2 place(Vec3 corner) const;

 private:
  /// Seen from the first corner, the farthest at a distance of 1 to 4.
  Vec3 unit_sized(Vec3 corner) const;
  bool are_on_a_line(std::span<const Vec3> corners, double no_area) const;

  Vec3 half_first_;
  double extent_ = 0.0;  // a power of two
  Vec3 right_, up_;
  Shape shape_ = Shape::polygon;
};

}  // namespace planish
