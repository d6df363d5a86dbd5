#include <numeric>
#include <vector>

#include <planish/mesh/repair.h>

#include "mesh/repair/repaired.h"
#include "mesh/repair/sheets.h"

namespace planish {

namespace {

// Shares of the area: of a crumb below, of all crumbs at most.
constexpr double k_crumb = 0.01, k_all_crumbs = 0.1;

}  // namespace

Crumbs find_crumbs(const TriMesh& mesh) {
  require_entries(mesh);
  const Sheets sheets = find_sheets(mesh);
  const std::vector<double> areas = sums_over(sheets, unit_areas(mesh));
  const double whole = std::accumulate(areas.begin(), areas.end(), 0.0);
  Crumbs crumbs;
  double area = 0.0;
  for (const double of_sheet : areas) {
    if (!(of_sheet < k_crumb * whole)) continue;
    ++crumbs.pieces;
    area += of_sheet;
  }
  if (crumbs.pieces == 0 || !(area <= k_all_crumbs * whole)) return {};
  crumbs.area_share = area / whole;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (areas[sheets.of_triangle[t]] < k_crumb * whole)
      crumbs.triangles.push_back(static_cast<Index>(t));
  }
  return crumbs;
}

}  // namespace planish
