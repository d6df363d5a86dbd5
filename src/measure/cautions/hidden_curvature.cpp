#include <algorithm>
#include <vector>

#include <planish/measure/cautions.h>

#include "core/careful_sum.h"
#include "measure/cautions/plane_facets.h"
#include "measure/cautions/triangle_hinges.h"

namespace planish {

namespace {

constexpr double k_little_area = 0.01;

/// Rulings of a cone meet on its border: one that they meet in inside would be a tip.
bool is_in_fan(const PlaneFacet& facet, const PlaneFacets& all, const Patch& patch) {
  return facet.apex != PlaneFacet::none && patch.is_border(facet.apex) &&
         std::all_of(facet.beyond.begin(), facet.beyond.end(), [&](Index f) {
           const PlaneFacet& other = all.facets[f];
           return other.is_meant || other.bent_sides == 1 || other.apex == facet.apex;
         });
}

/// Whether the sides of a facet that are bent can be rulings of a sheet.
bool is_ruled(const PlaneFacet& facet, const PlaneFacets& all, const Patch& patch) {
  if (facet.beyond.empty() || facet.is_meant) return true;
  if (facet.bent_sides != 1) return is_in_fan(facet, all, patch);
  // At an end: what is beside it says which.
  return std::all_of(facet.beyond.begin(), facet.beyond.end(), [&](Index f) {
    const PlaneFacet& other = all.facets[f];
    return other.is_meant || is_in_fan(other, all, patch);
  });
}

/// Of all the area, that of triangles which are neither plane nor ruled.
double unknown_share(const Patch& patch, const std::vector<double>& areas, double area) {
  const PlaneFacets all = plane_facets(patch, triangle_hinges(patch));
  std::vector<bool> ruled;
  ruled.reserve(all.facets.size());
  for (const PlaneFacet& facet : all.facets)
    ruled.push_back(is_ruled(facet, all, patch));
  CarefulSum unknown;
  for (Index t = 0; t < areas.size(); ++t) {
    if (!ruled[all.of_triangle[t]]) unknown.add(areas[t]);
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
