#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include <planish/core/vec.h>

namespace planish {

/// Square cells over places of the plane, about as many as places.
class PlaneGrid {
 public:
  explicit PlaneGrid(std::span<const Vec2> places) {
    Vec2 low = places.front(), high = low;
    for (const Vec2 p : places) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    low_ = low;
    const Vec2 extent = high - low;
    const auto count = static_cast<double>(places.size());
    size_ = std::max(std::sqrt(extent.x * extent.y / count),
                     std::max({extent.x, extent.y, 1.0}) / count);
    columns_ = 1 + static_cast<std::size_t>(extent.x / size_);
    rows_ = 1 + static_cast<std::size_t>(extent.y / size_);
  }

  std::size_t cell_count() const { return columns_ * rows_; }

  /// The cell of one of the places.
  std::size_t cell(Vec2 place) const { return row(place.y) * columns_ + column(place.x); }

  /// Calls visit(cell) for all cells that a convex polygon of places meets, and maybe some beside
  /// them, until it returns true; whether it did.
  template <class Visit>
  bool visit(std::span<const Vec2> polygon, const Visit& visit) const {
    double low = polygon.front().y, high = low;
    for (const Vec2 p : polygon) {
      low = std::min(low, p.y);
      high = std::max(high, p.y);
    }
    const std::size_t last_row = row(high);
    for (std::size_t r = row(low); r <= last_row; ++r) {
      const auto [from, to] = extent_in(r, polygon);
      const std::size_t last = column(to);
      for (std::size_t c = column(from); c <= last; ++c) {
        if (visit(r * columns_ + c)) return true;
      }
    }
    return false;
  }

 private:
  struct Extent {
    double from, to;
  };

  /// From where to where a polygon reaches in a row.
  Extent extent_in(std::size_t row, std::span<const Vec2> polygon) const {
    // A little more than the row, since what is computed is rounded.
    const double bottom = low_.y + (static_cast<double>(row) - 0.001) * size_;
    const double top = low_.y + (static_cast<double>(row) + 1.001) * size_;
    Extent extent{std::numeric_limits<double>::infinity(),
                  -std::numeric_limits<double>::infinity()};
    const auto add = [&](double x) { extent = {std::min(extent.from, x), std::max(extent.to, x)}; };
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec2 a = polygon[k], b = polygon[(k + 1) % polygon.size()];
      if (a.y >= bottom && a.y <= top) add(a.x);
      for (const double y : {bottom, top}) {
        if ((a.y < y) != (b.y < y)) add(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
      }
    }
    const double more = 0.001 * size_;
    return {extent.from - more, extent.to + more};
  }

  std::size_t column(double x) const { return step(x - low_.x, columns_); }
  std::size_t row(double y) const { return step(y - low_.y, rows_); }
  std::size_t step(double from_low, std::size_t count) const {
    if (!(from_low > 0.0)) return 0;
    return std::min(count - 1, static_cast<std::size_t>(from_low / size_));
  }

  Vec2 low_;
  double size_ = 1.0;
  std::size_t columns_ = 1, rows_ = 1;
};

}  // namespace planish
