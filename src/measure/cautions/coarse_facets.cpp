#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <planish/measure/cautions.h>

#include "core/math.h"
#include "core/neumaier_sum.h"
#include "measure/cautions/triangle_hinges.h"

namespace planish {

namespace {

constexpr double k_radian = std::numbers::pi / 180.0;
constexpr double k_coarse_turn = 10.0 * k_radian, k_crease_turn = 50.0 * k_radian;
constexpr double k_most_of_area = 0.9;

/// A triangle in space with the curvature that its sides have together: to each side belongs half
/// of its turn, spread over the triangle (Cohen-Steiner and Morvan 2003).
class BentTriangle {
 public:
  BentTriangle(const Patch& patch, Index t, const TriangleHinges& hinges, double area)
      : hinges_(hinges), area_(area) {
    const double scale = patch.unit_scale();
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = scale * patch.positions()[patch.triangles()[t][k]];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 side = corners[(k + 1) % 3] - corners[k];
      lengths_[k] = norm(side);
      along_[k] = lengths_[k] > 0.0 ? (1.0 / lengths_[k]) * side : Vec3{};
    }
    const Vec3 normal = cross(along_[0], corners[2] - corners[0]);
    const double height = norm(normal);
    for (std::size_t k = 0; k < 3; ++k)
      outwards_[k] = height > 0.0 ? (1.0 / height) * cross(along_[k], normal) : Vec3{};
  }

  double length(std::size_t side) const { return lengths_[side]; }
  Vec3 along(std::size_t side) const { return along_[side]; }

  /// The curvature in a direction, a unit vector in the plane of the triangle.
  double curvature(Vec3 direction) const {
    if (!(area_ > 0.0)) return 0.0;
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double across = dot(outwards_[k], direction);
      sum += hinges_[k].angle * lengths_[k] * across * across;
    }
    return 0.5 * sum / area_;
  }

  /// A direction of this triangle when it is folded flat onto the one beyond a side.
  Vec3 beyond(std::size_t side, Vec3 direction, const BentTriangle& other,
              std::size_t other_side) const {
    return dot(direction, along_[side]) * along_[side] -
           dot(direction, outwards_[side]) * other.outwards_[other_side];
  }

 private:
  TriangleHinges hinges_;
  double area_;
  std::array<double, 3> lengths_{};
  std::array<Vec3, 3> along_{}, outwards_{};
};

std::size_t side_towards(const TriangleHinges& hinges, Index t) {
  return hinges[0].other == t ? 0 : hinges[1].other == t ? 1 : 2;
}

/// A triangle and those beyond its sides.
class Neighbourhood {
 public:
  Neighbourhood(const Patch& patch, const std::vector<TriangleHinges>& hinges,
                const std::vector<double>& areas, Index t)
      : own_(patch, t, hinges[t], areas[t]) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index other = hinges[t][k].other;
      if (other == TriangleHinge::none) continue;
      beyond_.push_back({BentTriangle(patch, other, hinges[other], areas[other]), k,
                         side_towards(hinges[other], t)});
    }
  }

  /// The largest arc that a side of the triangle spans, radians; 0 where it is a crease.
  double turn() const {
    double turn = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      turn = std::max(turn, own_.length(k) * common_curvature(own_.along(k)));
    return turn < k_crease_turn ? turn : 0.0;
  }

 private:
  struct Beyond {
    BentTriangle triangle;
    std::size_t side, own_side;  // of the triangle in the middle, and of this one
  };

  /// The curvature in a direction that all have in common. A crease of the design stands alone: it
  /// bends a triangle and the one beyond, and not the other two. Without one of the three, on the
  /// border, all must be bent.
  double common_curvature(Vec3 direction) const {
    const double own = own_.curvature(direction), sign = own < 0.0 ? -1.0 : 1.0;
    double least = std::abs(own), second = std::numeric_limits<double>::infinity();
    for (const Beyond& beyond : beyond_) {
      const Vec3 there = own_.beyond(beyond.side, direction, beyond.triangle, beyond.own_side);
      const double curvature = sign * beyond.triangle.curvature(there);
      second = std::min(second, std::max(least, curvature));
      least = std::min(least, curvature);
    }
    return std::max(0.0, beyond_.size() == 3 ? second : least);
  }

  BentTriangle own_;
  std::vector<Beyond> beyond_;
};

/// What a share of the area stays at or below.
double usual_turn(const std::vector<double>& turns, const std::vector<double>& areas) {
  std::vector<std::pair<double, Index>> order;
  NeumaierSum area;
  for (Index t = 0; t < turns.size(); ++t) {
    order.emplace_back(turns[t], t);
    area.add(areas[t]);
  }
  std::sort(order.begin(), order.end());
  NeumaierSum so_far;
  for (const auto& [turn, t] : order) {
    so_far.add(areas[t]);
    if (so_far.value() >= k_most_of_area * area.value()) return turn;
  }
  return 0.0;
}

}  // namespace

std::optional<CoarseFacets> find_coarse_facets(const Patch& patch) {
  const std::vector<TriangleHinges> hinges = triangle_hinges(patch);
  const std::vector<double> areas = triangle_areas(patch);
  std::vector<double> turns;
  turns.reserve(hinges.size());
  for (Index t = 0; t < hinges.size(); ++t)
    turns.push_back(Neighbourhood(patch, hinges, areas, t).turn());
  const double turn = usual_turn(turns, areas);
  if (!(turn > k_coarse_turn)) return std::nullopt;
  return CoarseFacets{turn / k_radian, 1.0 - 2.0 * math::sin(0.5 * turn) / turn};
}

}  // namespace planish
