#include "measure/cautions/plane_facets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/math.h"

namespace planish {

namespace {

// Radians. A facet of several triangles is plane but for the rounding of coordinates, or for a
// twist that is small beside the bends.
constexpr double k_plane_angle = 1e-4, k_plane_share = 0.02;
// Radians. Edges of an outline that turn less make one side; together they may be a curve.
constexpr double k_corner = 0.2, k_curve = 1.0;

/// A side of a triangle.
struct Side {
  Index triangle = 0;
  std::size_t number = 0;
};

class FacetFinder {
 public:
  FacetFinder(const Patch& patch, std::span<const TriangleHinges> hinges)
      : patch_(patch),
        hinges_(hinges),
        flat_angle_(k_plane_angle + k_plane_share * largest_turn(hinges)),
        is_walked_(hinges.size(), {false, false, false}) {
    found_.of_triangle.assign(hinges.size(), PlaneFacet::none);
  }

  PlaneFacets run() && {
    for (Index t = 0; t < hinges_.size(); ++t) {
      if (found_.of_triangle[t] == PlaneFacet::none) unite_from(t);
    }
    std::vector<std::size_t> outlines(sizes_.size(), 0);
    for (Index t = 0; t < hinges_.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (!is_outline({t, k}) || is_walked_[t][k]) continue;
        ++outlines[found_.of_triangle[t]];
        describe(outline_from({t, k}));
      }
    }
    for (std::size_t f = 0; f < outlines.size(); ++f)
      found_.facets[f].is_meant = found_.facets[f].is_meant || outlines[f] != 1;
    return std::move(found_);
  }

 private:
  static double largest_turn(std::span<const TriangleHinges> hinges) {
    double largest = 0.0;
    for (const TriangleHinges& triangle : hinges) {
      for (const TriangleHinge& hinge : triangle)
        largest = std::max(largest, std::abs(hinge.angle));
    }
    return largest;
  }

  const TriangleHinge& hinge(Side side) const { return hinges_[side.triangle][side.number]; }
  bool is_bent(Side side) const { return std::abs(hinge(side).angle) > flat_angle_; }
  bool is_outline(Side side) const { return hinge(side).is_border() || is_bent(side); }
  Index start(Side side) const { return patch_.triangles()[side.triangle][side.number]; }
  static Side next_in_triangle(Side side) { return {side.triangle, (side.number + 1) % 3}; }

  void unite_from(Index first) {
    const auto facet = static_cast<Index>(found_.facets.size());
    std::vector<Index> stack = {first};
    std::size_t size = 0;
    found_.of_triangle[first] = facet;
    while (!stack.empty()) {
      const Index t = stack.back();
      stack.pop_back();
      ++size;
      for (std::size_t k = 0; k < 3; ++k) {
        const Index other = hinges_[t][k].other;
        if (is_outline({t, k}) || found_.of_triangle[other] != PlaneFacet::none) continue;
        found_.of_triangle[other] = facet;
        stack.push_back(other);
      }
    }
    found_.facets.emplace_back();
    sizes_.push_back(size);
  }

  /// The side of the outline behind one.
  Side next_on_outline(Side side) const {
    for (side = next_in_triangle(side); !is_outline(side); side = next_in_triangle(side)) {
      const Index end = start(next_in_triangle(side)), other = hinge(side).other;
      std::size_t k = 0;
      while (k < 2 && patch_.triangles()[other][k] != end)
        ++k;
      side = {other, k};
    }
    return side;
  }

  std::vector<Side> outline_from(Side first) {
    std::vector<Side> outline;
    for (Side side = first; !is_walked_[side.triangle][side.number]; side = next_on_outline(side)) {
      is_walked_[side.triangle][side.number] = true;
      outline.push_back(side);
    }
    return outline;
  }

  /// By how much the outline turns where a side begins.
  double turn_at(Side before, Side side) const {
    const double scale = patch_.unit_scale();
    const auto place = [&](Side s) { return scale * patch_.positions()[start(s)]; };
    const Vec3 from = place(side) - place(before), to = place(next_in_triangle(side)) - place(side);
    return math::atan2(norm(cross(from, to)), dot(from, to));
  }

  /// Of the side from each corner to the next, whether an edge of it is bent.
  std::vector<bool> bent_sides(const std::vector<Side>& outline,
                               const std::vector<std::size_t>& corners) const {
    const std::size_t n = outline.size();
    std::vector<bool> bent(corners.size(), false);
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const std::size_t end = c + 1 < corners.size() ? corners[c + 1] : corners.front() + n;
      for (std::size_t i = corners[c]; i < end; ++i)
        bent[c] = bent[c] || is_bent(outline[i < n ? i : i - n]);
    }
    return bent;
  }

  void describe(const std::vector<Side>& outline) {
    const Index number = found_.of_triangle[outline.front().triangle];
    PlaneFacet& facet = found_.facets[number];
    const std::size_t n = outline.size(), size = sizes_[number];
    std::vector<std::size_t> corners;
    double curve = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const double turn = turn_at(outline[(i + n - 1) % n], outline[i]);
      if (size == 1 || turn > k_corner) {
        corners.push_back(i);
      } else {
        curve += turn;
      }
    }
    // Of n sides and without a vertex inside, a polygon has n - 2 triangles.
    facet.is_meant = facet.is_meant || corners.size() > 3 || curve > k_curve || size + 2 > n;
    for (const Side side : outline) {
      if (is_bent(side)) facet.beyond.push_back(found_.of_triangle[hinge(side).other]);
    }
    const std::vector<bool> bent = bent_sides(outline, corners);
    facet.bent_sides = static_cast<std::size_t>(std::count(bent.begin(), bent.end(), true));
    if (facet.bent_sides != 2) return;
    for (std::size_t c = 0; c < corners.size(); ++c) {
      if (bent[c] && bent[(c + corners.size() - 1) % corners.size()])
        facet.apex = start(outline[corners[c]]);
    }
  }

  const Patch& patch_;
  std::span<const TriangleHinges> hinges_;
  double flat_angle_;
  std::vector<std::array<bool, 3>> is_walked_;
  std::vector<std::size_t> sizes_;  // triangles of each facet
  PlaneFacets found_;
};

}  // namespace

PlaneFacets plane_facets(const Patch& patch, std::span<const TriangleHinges> hinges) {
  return FacetFinder(patch, hinges).run();
}

}  // namespace planish
