#include "draw/whole_steps.h"

#include <cmath>

namespace planish {

std::vector<Vec2> whole_steps(std::span<const Vec2> line, double per_millimetre, bool closed) {
  std::vector<Vec2> places;
  places.reserve(line.size());
  for (const Vec2 point : line) {
    const Vec2 place = {std::round(per_millimetre * point.x), std::round(per_millimetre * point.y)};
    const bool is_somewhere = std::isfinite(place.x) && std::isfinite(place.y);
    if (is_somewhere && (places.empty() || !(place == places.back()))) places.push_back(place);
  }
  while (closed && places.size() > 1 && places.front() == places.back())
    places.pop_back();
  return places;
}

}  // namespace planish
