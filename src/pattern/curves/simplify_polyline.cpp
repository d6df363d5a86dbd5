#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <planish/pattern/curve.h>

#include "pattern/curves/corners.h"
#include "pattern/polygon/plane.h"

namespace planish {

namespace {

// Millimetres: tries go down to it by a factor of 0.6.
constexpr double k_least_chord_tolerance = 0.016;
constexpr double k_same = 1e-6;        // millimetres: two places are one
constexpr double k_on_line = 1e-3;     // millimetres: a place is on a line
constexpr double k_for_chords = 0.83;  // of the tolerance: moving points outwards takes up the rest

/// The directions in which a line from a point passes near others.
class Wedge {
 public:
  Wedge(Vec2 from, double tolerance) : from_(from), tolerance_(tolerance) {}

  /// Whether the line to a point passes near all that narrowed the wedge, and goes on with them.
  bool holds(Vec2 p) const {
    const Vec2 way = p - from_;
    if (!(norm(way) >= reached_ - tolerance_)) return false;
    return !is_bounded_ || (cross(right_, way) >= 0.0 && cross(way, left_) >= 0.0);
  }

  /// Lines are to pass near this point too.
  void narrow(Vec2 p) {
    const Vec2 way = p - from_;
    const double distance = norm(way);
    reached_ = std::max(reached_, distance);
    if (!(distance > tolerance_)) return;
    const double sine = tolerance_ / distance, cosine = std::sqrt(1.0 - sine * sine);
    const Vec2 right = {cosine * way.x + sine * way.y, cosine * way.y - sine * way.x};
    const Vec2 left = {cosine * way.x - sine * way.y, cosine * way.y + sine * way.x};
    if (!is_bounded_ || cross(right_, right) > 0.0) right_ = right;
    if (!is_bounded_ || cross(left_, left) < 0.0) left_ = left;
    is_bounded_ = true;
  }

 private:
  Vec2 from_;
  double tolerance_;
  double reached_ = 0.0;
  bool is_bounded_ = false;
  Vec2 right_, left_;
};

/// Points of the line, each as far on as the chord to it stays near.
std::vector<std::size_t> chosen_points(std::span<const Vec2> points, double tolerance) {
  std::vector<std::size_t> chosen = {0};
  while (chosen.back() + 1 < points.size()) {
    const std::size_t from = chosen.back();
    Wedge wedge(points[from], tolerance);
    std::size_t best = from + 1;
    for (std::size_t i = from + 1; i < points.size(); ++i) {
      if (!wedge.holds(points[i])) break;
      best = i;
      wedge.narrow(points[i]);
    }
    chosen.push_back(best);
  }
  return chosen;
}

/// How far each point is to be moved so that chords along a bend get its length: a polygon around a
/// circle that is as long as it has its corners outside by c^2 / 24 r, for chords of length c.
std::vector<Vec2> shifts_of(const Polygon& chords, double most) {
  std::vector<Vec2> shifts(chords.size());
  for (std::size_t k = 1; k + 1 < chords.size(); ++k) {
    const Vec2 before = chords[k] - chords[k - 1], after = chords[k + 1] - chords[k];
    const double a = norm(before), b = norm(after);
    const Vec2 along = 1.0 / a * before + 1.0 / b * after;
    if (!(norm(along) > 0.1)) continue;
    const double curvature = turn_between(before, after) / (0.5 * (a + b));
    const double out = std::clamp(curvature * a * b / 24.0, -most, most);
    const Vec2 direction = direction_of(along);
    shifts[k] = out * Vec2{direction.y, -direction.x};
  }
  return shifts;
}

Polygon moved(const Polygon& chords, const std::vector<Vec2>& shifts, double share) {
  Polygon points(chords.size());
  for (std::size_t k = 0; k < chords.size(); ++k)
    points[k] = chords[k] + share * shifts[k];
  return points;
}

/// With points moved outwards until it is as long as wanted, by the secant rule within bounds; as
/// near to that as it can be.
Polygon with_length(const Polygon& chords, double length, double most) {
  const std::vector<Vec2> shifts = shifts_of(chords, most);
  const auto excess = [&](double share) {
    return length_of_line(moved(chords, shifts, share)) - length;
  };
  double low = 0.0, high = 2.0;
  double low_excess = excess(low), high_excess = excess(high);
  if (low_excess >= 0.0) return chords;
  if (high_excess <= 0.0) return moved(chords, shifts, high);
  double share = 1.0;
  for (int step = 0; step < 60; ++step) {
    share = low - low_excess * (high - low) / (high_excess - low_excess);
    const double here = excess(share);
    if (std::abs(here) <= 1e-9 * length) break;
    (here < 0.0 ? low : high) = share;
    (here < 0.0 ? low_excess : high_excess) = here;
  }
  return moved(chords, shifts, share);
}

/// Whether points are near the chords that stand for them, and the other way round.
bool is_near(std::span<const Vec2> points, const std::vector<std::size_t>& chosen,
             const Polygon& chords, double tolerance) {
  for (std::size_t k = 1; k < chosen.size(); ++k) {
    for (std::size_t i = chosen[k - 1]; i <= chosen[k]; ++i) {
      if (distance_to_segment(points[i], chords[k - 1], chords[k]) > tolerance) return false;
    }
  }
  return true;
}

Polygon fewer_points(const Polygon& points, const LineFit& fit) {
  const double length = length_of_line(points);
  double tolerance = k_for_chords * fit.tolerance;
  for (; tolerance > 0.0; tolerance = tolerance > k_least_chord_tolerance ? 0.6 * tolerance : 0.0) {
    const std::vector<std::size_t> chosen = chosen_points(points, tolerance);
    Polygon chords;
    chords.reserve(chosen.size());
    for (const std::size_t i : chosen)
      chords.push_back(points[i]);
    chords = with_length(chords, length, tolerance);
    if (std::abs(length_of_line(chords) - length) <= fit.length_tolerance &&
        is_near(points, chosen, chords, fit.tolerance))
      return chords;
  }
  return points;
}

/// The number of the edge of a closed line that a place is on; nothing where it is on none.
std::optional<std::size_t> edge_at(const Polygon& loop, Vec2 place) {
  std::optional<std::size_t> nearest;
  double least = k_on_line;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double distance = distance_to_segment(place, loop[i], loop[(i + 1) % loop.size()]);
    if (!(distance < least)) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

/// The closed line with a point at each place on it, and the numbers of these points.
std::pair<Polygon, std::vector<std::size_t>> with_points(Polygon loop,
                                                         std::span<const Vec2> places) {
  for (const Vec2 place : places) {
    const auto edge = edge_at(loop, place);
    if (!edge) continue;
    const Vec2 a = loop[*edge], b = loop[(*edge + 1) % loop.size()];
    const bool is_there = norm(place - a) < k_same || norm(place - b) < k_same;
    if (!is_there) loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(*edge) + 1, place);
  }
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const bool is_kept = std::any_of(places.begin(), places.end(),
                                     [&](Vec2 place) { return norm(place - loop[i]) < k_same; });
    if (is_kept) numbers.push_back(i);
  }
  return {std::move(loop), std::move(numbers)};
}

}  // namespace

Polygon simplify_polyline(const Polygon& loop, const LineFit& fit, std::span<const Vec2> kept) {
  auto [line, breaks] = with_points(without_repeats(loop), kept);
  if (line.size() < 4) return line;
  for (const std::size_t corner : corners_of(line))
    breaks.push_back(corner);
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  Polygon result;
  for (const Polygon& stretch : stretches_of(line, breaks)) {
    const Polygon points = fewer_points(stretch, fit);
    result.insert(result.end(), points.begin(), points.end() - 1);
  }
  return result.size() < 3 ? line : result;
}

}  // namespace planish
