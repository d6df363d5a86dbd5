#include <algorithm>
#include <cmath>
#include <vector>

#include <planish/measure/cautions.h>

#include "core/neumaier_sum.h"
#include "measure/cautions/plane_facets.h"
#include "measure/cautions/triangle_hinges.h"

namespace planish {

namespace {

constexpr double k_little_area = 0.01;

// The fewest facets around a border vertex, and the least turn of them in radians, that make a
// cone. The transition from a square to a circle has such cones at its corners. Fans that come from
// the diagonals of a strip of quadrilaterals are smaller.
constexpr std::size_t k_fewest_facets_of_cone = 3;
constexpr double k_least_turn_of_cone = 0.5;

/// Judges the facets of a patch.
class RulingJudge {
 public:
  explicit RulingJudge(const Patch& patch) : patch_(patch), fans_(patch.vertex_count()) {
    const std::vector<TriangleHinges> hinges = triangle_hinges(patch);
    all_ = plane_facets(patch, hinges);
    for (const PlaneFacet& facet : all_.facets) {
      if (facet.apex != PlaneFacet::none) ++fans_[facet.apex].facets;
    }
    for (Index t = 0; t < hinges.size(); ++t) {
      for (const TriangleHinge& hinge : hinges[t]) {
        if (hinge.is_border() || hinge.other < t) continue;
        const Index here = all_.of_triangle[t], there = all_.of_triangle[hinge.other];
        const Index apex = all_.facets[here].apex;
        if (here != there && apex != PlaneFacet::none && apex == all_.facets[there].apex)
          fans_[apex].turn += hinge.angle;
      }
    }
  }

  /// Whether the sides of a triangle's facet that are bent can be rulings of a sheet.
  bool is_ruled(Index triangle) const {
    const PlaneFacet& facet = all_.facets[all_.of_triangle[triangle]];
    if (facet.beyond.empty() || facet.is_meant) return true;
    if (facet.bent_sides != 1) return is_in_fan(facet) || is_between_cones(facet);
    // At an end: what is beside it says which.
    return std::all_of(facet.beyond.begin(), facet.beyond.end(), [&](Index f) {
      return all_.facets[f].is_meant || is_in_fan(all_.facets[f]);
    });
  }

 private:
  /// Of the facets with one apex.
  struct Fan {
    std::size_t facets = 0;
    double turn = 0.0;
  };

  bool is_of_cone(const PlaneFacet& facet) const {
    if (facet.apex == PlaneFacet::none || !patch_.is_border(facet.apex)) return false;
    const Fan& fan = fans_[facet.apex];
    return fan.facets >= k_fewest_facets_of_cone && std::abs(fan.turn) >= k_least_turn_of_cone;
  }

  /// Whether it touches the cones of two corners.
  bool is_between_cones(const PlaneFacet& facet) const {
    return facet.apex != PlaneFacet::none && patch_.is_border(facet.apex) &&
           std::all_of(facet.beyond.begin(), facet.beyond.end(), [&](Index f) {
             return all_.facets[f].apex != facet.apex && is_of_cone(all_.facets[f]);
           });
  }

  /// Rulings of a cone meet on its border: one that they meet in inside would be a tip.
  bool is_in_fan(const PlaneFacet& facet) const {
    return facet.apex != PlaneFacet::none && patch_.is_border(facet.apex) &&
           std::all_of(facet.beyond.begin(), facet.beyond.end(), [&](Index f) {
             const PlaneFacet& other = all_.facets[f];
             return other.is_meant || other.bent_sides == 1 || other.apex == facet.apex ||
                    (is_of_cone(facet) && is_between_cones(other));
           });
  }

  const Patch& patch_;
  PlaneFacets all_;
  std::vector<Fan> fans_;  // by apex
};

/// Of all the area, that of triangles which are neither plane nor ruled.
double unknown_share(const Patch& patch, const std::vector<double>& areas, double area) {
  const RulingJudge judge(patch);
  NeumaierSum unknown;
  for (Index t = 0; t < areas.size(); ++t) {
    if (!judge.is_ruled(t)) unknown.add(areas[t]);
  }
  return unknown.value() / area;
}

}  // namespace

std::optional<HiddenCurvature> find_hidden_curvature(const Patch& patch) {
  const std::vector<double> areas = triangle_areas(patch);
  NeumaierSum all, inner;
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
