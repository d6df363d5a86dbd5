#include "pattern/polygon/border_walk.h"

#include <algorithm>
#include <cmath>

namespace planish {

BorderWalk::BorderWalk(std::span<const Vec2> loop) : loop_(loop) {
  reached_.reserve(loop.size() + 1);
  reached_.push_back(0.0);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    reached_.push_back(reached_.back() + norm(loop[(i + 1) % loop.size()] - loop[i]));
  }
}

Vec2 BorderWalk::at(double way) const {
  way = std::fmod(way, length());
  if (way < 0.0) way += length();
  const auto after = std::upper_bound(reached_.begin() + 1, reached_.end() - 1, way);
  const auto edge = static_cast<std::size_t>(after - reached_.begin()) - 1;
  const double edge_length = reached_[edge + 1] - reached_[edge];
  const Vec2 a = loop_[edge], b = loop_[(edge + 1) % loop_.size()];
  if (!(edge_length > 0.0)) return a;
  return a + std::clamp((way - reached_[edge]) / edge_length, 0.0, 1.0) * (b - a);
}

}  // namespace planish
