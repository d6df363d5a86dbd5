#include "draw/dxf/dxf_places.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <planish/pattern/piece_outline.h>

#include "draw/whole_steps.h"

namespace planish {

std::vector<std::vector<Vec2>> dxf_places(std::span<const std::vector<Vec2>> lines, bool closed) {
  constexpr double steps = 1000.0;  // per millimetre
  std::vector<std::vector<Vec2>> result;
  result.reserve(lines.size());
  for (const auto& line : lines) {
    std::vector<Vec2> places = whole_steps(line, steps, closed);
    for (Vec2& place : places)
      place = {place.x / steps, place.y / steps};
    if (places.size() > 1) result.push_back(std::move(places));
  }
  return result;
}

std::size_t largest_of(std::span<const std::vector<Vec2>> loops) {
  const auto largest =
      std::max_element(loops.begin(), loops.end(), [](const auto& a, const auto& b) {
        return std::abs(signed_area(a)) < std::abs(signed_area(b));
      });
  return static_cast<std::size_t>(largest - loops.begin());
}

}  // namespace planish
