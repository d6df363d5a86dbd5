#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// Lines as DXF files have them: places in whole thousandths of a millimetre, without repeats;
/// lines of fewer than two points are left out.
std::vector<std::vector<Vec2>> dxf_places(std::span<const std::vector<Vec2>> lines, bool closed);

/// The box around places; nothing without any.
class DxfBox {
 public:
  void add(Vec2 place) {
    if (!corners_) corners_ = std::pair(place, place);
    auto& [low, high] = *corners_;
    low = {std::min(low.x, place.x), std::min(low.y, place.y)};
    high = {std::max(high.x, place.x), std::max(high.y, place.y)};
  }

  /// Two corners, the lower left one first.
  const std::optional<std::pair<Vec2, Vec2>>& corners() const { return corners_; }

 private:
  std::optional<std::pair<Vec2, Vec2>> corners_;
};

/// The number of the loop that encloses most; 0 where there are none.
std::size_t largest_of(std::span<const std::vector<Vec2>> loops);

}  // namespace planish
