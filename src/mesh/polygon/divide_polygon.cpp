#include "mesh/polygon/divide_polygon.h"

#include <algorithm>
#include <tuple>

#include "mesh/polygon/delaunay_flips.h"
#include "mesh/polygon/diagonal.h"
#include "mesh/polygon/ear_clipping.h"
#include "mesh/polygon/own_plane.h"
#include "mesh/polygon/side_crossings.h"

namespace planish {

namespace {

/// A side of a face.
struct FaceSide {
  Index low, high;
  bool rises;

  friend bool operator<(const FaceSide& a, const FaceSide& b) {
    return std::tie(a.low, a.high, a.rises) < std::tie(b.low, b.high, b.rises);
  }
  bool same_ends(const FaceSide& other) const { return low == other.low && high == other.high; }
};

/// Whether each vertex that comes k times has k - 1 bridges at least.
bool repeats_at_bridges_only(std::span<const Index> corners) {
  std::vector<Index> sorted(corners.begin(), corners.end());
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end()) return true;
  std::vector<FaceSide> sides;
  sides.reserve(corners.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Index a = corners[k], b = corners[(k + 1) % corners.size()];
    sides.push_back({std::min(a, b), std::max(a, b), a < b});
  }
  std::sort(sides.begin(), sides.end());
  std::vector<Index> ends;
  for (std::size_t k = 1; k < sides.size(); ++k) {
    if (!sides[k].same_ends(sides[k - 1])) continue;
    if (sides[k].rises == sides[k - 1].rises) return false;
    ends.insert(ends.end(), {sides[k].low, sides[k].high});
  }
  std::sort(ends.begin(), ends.end());
  std::vector<Index> repeats;
  for (std::size_t k = 1; k < sorted.size(); ++k) {
    if (sorted[k] == sorted[k - 1]) repeats.push_back(sorted[k]);
  }
  return std::includes(ends.begin(), ends.end(), repeats.begin(), repeats.end());
}

/// A way to go once around a face.
struct Round {
  std::size_t first;
  bool back;

  Index corner(std::span<const Index> corners, std::size_t k) const {
    const std::size_t n = corners.size();
    return corners[(back ? first + n - k : first + k) % n];
  }
};

/// The way around whose vertices come first in the order of words in a dictionary: it does not
/// depend on the corner that the face begins with, nor on its direction.
Round first_round(std::span<const Index> corners) {
  const Index lowest = *std::min_element(corners.begin(), corners.end());
  Round best{0, false};
  bool found = false;
  const auto comes_before = [&](const Round& a, const Round& b) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Index p = a.corner(corners, k), q = b.corner(corners, k);
      if (p != q) return p < q;
    }
    return false;
  };
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (corners[k] != lowest) continue;
    for (const bool back : {false, true}) {
      const Round round{k, back};
      if (!found || comes_before(round, best)) best = round;
      found = true;
    }
  }
  return best;
}

std::vector<Triangle> fan(std::span<const Index> corners) {
  std::vector<Triangle> triangles;
  for (std::size_t k = 2; k < corners.size(); ++k)
    triangles.push_back({corners[0], corners[k - 1], corners[k]});
  return triangles;
}

bool is_through_first(const std::array<Index, 4>& corners, const std::array<Vec2, 4>& quad) {
  switch (better_diagonal(quad)) {
    case Diagonal::through_first:
      return true;
    case Diagonal::through_second:
      return false;
    case Diagonal::either:
      break;
  }
  return std::min(corners[0], corners[2]) < std::min(corners[1], corners[3]);
}

}  // namespace

std::optional<std::array<Triangle, 2>> divide_quad(const std::array<Index, 4>& corners,
                                                   std::span<const Vec3> positions) {
  const auto [a, b, c, d] = corners;
  const std::array<Triangle, 2> through_first = {{{a, b, c}, {a, c, d}}};
  const std::array<Triangle, 2> through_second = {{{b, c, d}, {b, d, a}}};
  const std::array places = {positions[a], positions[b], positions[c], positions[d]};
  const OwnPlane plane(places);
  if (plane.shape() == OwnPlane::Shape::none) return std::nullopt;
  if (plane.shape() == OwnPlane::Shape::line) return through_first;
  const std::array quad = {plane.place(places[0]), plane.place(places[1]), plane.place(places[2]),
                           plane.place(places[3])};
  std::array<int, 4> turns = {};
  for (std::size_t k = 0; k < 4; ++k)
    turns[k] = side_of(quad[(k + 3) % 4], quad[k], quad[(k + 1) % 4]);
  // A diagonal cuts off the corners that it does not go through.
  const int first = std::min(turns[1], turns[3]), second = std::min(turns[0], turns[2]);
  if (std::max(first, second) < 0) return std::nullopt;
  if (first != second) return first > second ? through_first : through_second;
  return is_through_first(corners, quad) ? through_first : through_second;
}

std::optional<std::vector<Triangle>> divide_polygon(std::span<const Index> corners,
                                                    std::span<const Vec3> positions) {
  if (!repeats_at_bridges_only(corners)) return std::nullopt;
  const Round round = first_round(corners);
  std::vector<Index> around;
  std::vector<Vec3> in_space;
  around.reserve(corners.size());
  in_space.reserve(corners.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    around.push_back(round.corner(corners, k));
    in_space.push_back(positions[around.back()]);
  }
  const OwnPlane plane(in_space);
  if (plane.shape() == OwnPlane::Shape::line) return fan(corners);
  if (plane.shape() == OwnPlane::Shape::none) return std::nullopt;
  std::vector<Vec2> places;
  places.reserve(corners.size());
  for (const Vec3 p : in_space)
    places.push_back(plane.place(p));
  if (has_crossing_sides(places)) return std::nullopt;
  const auto ears = clip_ears(places);
  if (!ears) return std::nullopt;
  std::vector<Triangle> triangles = delaunay_triangles(places, around, *ears);
  for (Triangle& triangle : triangles) {
    for (Index& corner : triangle)
      corner = around[corner];
    if (round.back) std::swap(triangle[1], triangle[2]);
  }
  return triangles;
}

}  // namespace planish
