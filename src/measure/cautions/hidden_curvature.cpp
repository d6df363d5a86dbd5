#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <planish/measure/cautions.h>

#include "core/careful_sum.h"
#include "measure/cautions/triangle_hinges.h"

namespace planish {

namespace {

// Radians. A facet of several triangles is plane but for the rounding of coordinates, or for a
// twist that is small beside the bends.
constexpr double k_plane_angle = 1e-4, k_plane_share = 0.02;
constexpr double k_little_area = 0.01;

/// How the triangles of a mesh make facets.
class Facets {
 public:
  explicit Facets(const std::vector<TriangleHinges>& hinges) : hinges_(hinges) {
    double largest = 0.0;
    for (const TriangleHinges& triangle : hinges) {
      for (const TriangleHinge& hinge : triangle)
        largest = std::max(largest, std::abs(hinge.angle));
    }
    flat_angle_ = k_plane_angle + k_plane_share * largest;
  }

  /// Whether a triangle is part of a facet of several.
  bool is_part(Index t) const {
    return std::any_of(hinges_[t].begin(), hinges_[t].end(), [&](const TriangleHinge& hinge) {
      return !hinge.is_border() && !is_bent(hinge);
    });
  }

  /// The vertex in which the rulings of a triangle meet: its sides that are bent.
  /// @return TriangleHinge::none where not two sides are bent
  Index apex(Index t, const Patch& patch) const {
    if (bent_sides(t) != 2) return TriangleHinge::none;
    // Side k goes from corner k to the next.
    for (std::size_t k = 0; k < 3; ++k) {
      if (is_bent(hinges_[t][k]) && is_bent(hinges_[t][(k + 2) % 3]))
        return patch.triangles()[t][k];
    }
    return TriangleHinge::none;
  }

  /// Whether the sides of a triangle that are bent can be rulings of a sheet.
  bool is_ruled(Index t, const Patch& patch) const {
    const int bent = bent_sides(t);
    if (bent == 0 || is_part(t)) return true;
    if (bent == 2) return is_in_fan(t, patch);
    // At an end: what is beside it says which.
    return bent == 1 && all_beside(t, [&](Index other) {
             return is_part(other) || (bent_sides(other) == 2 && is_in_fan(other, patch));
           });
  }

 private:
  bool is_bent(const TriangleHinge& hinge) const { return std::abs(hinge.angle) > flat_angle_; }

  int bent_sides(Index t) const {
    return static_cast<int>(
        std::count_if(hinges_[t].begin(), hinges_[t].end(),
                      [&](const TriangleHinge& hinge) { return is_bent(hinge); }));
  }

  template <class Test>
  bool all_beside(Index t, const Test& test) const {
    return std::all_of(hinges_[t].begin(), hinges_[t].end(), [&](const TriangleHinge& hinge) {
      return !is_bent(hinge) || test(hinge.other);
    });
  }

  /// Rulings of a cone meet on its border: one that they meet in inside would be a tip.
  bool is_in_fan(Index t, const Patch& patch) const {
    const Index tip = apex(t, patch);
    return tip != TriangleHinge::none && patch.is_border(tip) && all_beside(t, [&](Index other) {
             return is_part(other) || bent_sides(other) == 1 || apex(other, patch) == tip;
           });
  }

  const std::vector<TriangleHinges>& hinges_;
  double flat_angle_ = 0.0;
};

/// Of all the area, that of triangles which are neither plane nor ruled.
double unknown_share(const Patch& patch, const std::vector<double>& areas, double area) {
  const std::vector<TriangleHinges> hinges = triangle_hinges(patch);
  const Facets facets(hinges);
  CarefulSum unknown;
  for (Index t = 0; t < areas.size(); ++t) {
    if (!facets.is_ruled(t, patch)) unknown.add(areas[t]);
  }
  return unknown.value() / area;
}

}  // namespace

std::optional<HiddenCurvature> find_hidden_curvature(const Patch& patch) {
  const std::vector<double> areas = triangle_areas(patch);
  CarefulSum all, inner;
  for (Index t = 0; t < areas.size(); ++t) {
    all.add(areas[t]);
    for (const Index v : patch.triangles()[t]) {
      if (patch.is_inner(v)) inner.add(areas[t] / 3.0);
    }
  }
  const double area = all.value();
  if (!(area > 0.0)) return std::nullopt;
  const double share = inner.value() / area;
  if (share >= k_judged_share || unknown_share(patch, areas, area) <= k_little_area)
    return std::nullopt;
  return HiddenCurvature{share};
}

}  // namespace planish
