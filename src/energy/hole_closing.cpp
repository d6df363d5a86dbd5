#include "energy/hole_closing.h"

#include <cmath>
#include <numbers>

#include "core/math.h"

namespace planish {

namespace {

/// A quarter turn to the left.
Vec2 turned(Vec2 a) {
  return {-a.y, a.x};
}

}  // namespace

HoleLayout::HoleLayout(std::span<const double> lengths, std::span<const double> angles)
    : lengths_(lengths.begin(), lengths.end()) {
  const std::size_t count = lengths.size();
  turn_ = 2.0 * std::numbers::pi;
  for (std::size_t b = 0; b < count; ++b) {
    length_ += lengths[b];
    turn_ += std::numbers::pi - angles[b];
  }
  for (std::size_t b = 0; b < count; ++b)
    shares_.push_back((lengths[b > 0 ? b - 1 : count - 1] + lengths[b]) / (2.0 * length_));
  double heading = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    if (k > 0) heading += std::numbers::pi - angles[k] - turn_ * shares_[k];
    edges_.push_back(lengths[k] * Vec2{math::cos(heading), math::sin(heading)});
    gap_ = gap_ + edges_[k];
  }
  // The first edge has its direction; the turn at its start is that at the end of the last.
  to_end_.resize(count);
  Vec2 left;
  for (std::size_t k = count; k-- > 1;)
    to_end_[k] = left = left + edges_[k];
  for (std::size_t b = 0; b < count; ++b)
    mean_to_end_ = mean_to_end_ + shares_[b] * to_end_[b];
}

std::array<double, 3> HoleLayout::defects(double size) const {
  const Vec2 gap = (1.0 / size) * turned(gap_);
  return {turn_, gap.x, gap.y};
}

std::array<double, 3> HoleLayout::by_angle(std::size_t b, double size) const {
  const Vec2 change = (1.0 / size) * (to_end_[b] - mean_to_end_);
  return {-1.0, change.x, change.y};
}

std::array<double, 3> HoleLayout::by_length(std::size_t k, double size) const {
  const Vec2 direction = turned((1.0 / lengths_[k]) * edges_[k]);
  const Vec2 by_shares = (turn_ / length_) * (0.5 * (to_end_[k] + to_end_[next(k)]) - mean_to_end_);
  const Vec2 change = (1.0 / size) * (direction + by_shares);
  return {0.0, change.x, change.y};
}

HoleLayout::Polygon HoleLayout::closed() const {
  const std::size_t count = edges_.size();
  const auto edge = [&](std::size_t k) { return edges_[k] - (lengths_[k] / length_) * gap_; };
  Polygon polygon;
  Vec2 at, middle;
  for (std::size_t b = 0; b < count; ++b) {
    polygon.places.push_back(at);
    middle = middle + shares_[b] * at;
    at = at + edge(b);
  }
  double squares = 0.0;
  for (std::size_t b = 0; b < count; ++b) {
    polygon.places[b] = polygon.places[b] - middle;
    squares += shares_[b] * dot(polygon.places[b], polygon.places[b]);
  }
  polygon.size = std::sqrt(squares);
  for (std::size_t b = 0; b < count; ++b) {
    polygon.places[b] = (1.0 / polygon.size) * polygon.places[b];
    polygon.normals.push_back((-0.5 / polygon.size) *
                              turned(edge(b > 0 ? b - 1 : count - 1) + edge(b)));
  }
  return polygon;
}

}  // namespace planish
