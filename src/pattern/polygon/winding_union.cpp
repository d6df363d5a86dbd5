#include "pattern/polygon/winding_union.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <planish/core/error.h>

#include <polyclipping/clipper.hpp>

namespace planish {

namespace {

constexpr double k_steps = 1e5;      // of the grid in a millimetre
constexpr double k_farthest = 1e10;  // millimetres; Clipper's own limit is some 4000 times as far

ClipperLib::IntPoint on_grid(Vec2 p) {
  if (!(std::abs(p.x) < k_farthest && std::abs(p.y) < k_farthest)) {
    throw Error(ErrorCode::too_large, "the pattern is too large to lay an allowance around it");
  }
  return {static_cast<ClipperLib::cInt>(std::llround(p.x * k_steps)),
          static_cast<ClipperLib::cInt>(std::llround(p.y * k_steps))};
}

Polygon off_grid(const ClipperLib::Path& path) {
  Polygon polygon;
  polygon.reserve(path.size());
  for (const ClipperLib::IntPoint& p : path)
    polygon.push_back({static_cast<double>(p.X) / k_steps, static_cast<double>(p.Y) / k_steps});
  return polygon;
}

ClipperLib::Paths united(const ClipperLib::Paths& paths) {
  // Clipper catches whatever is thrown within and tells only that it failed. Where there was no
  // memory for a moment, the second try is right; where there is none, preparing it throws.
  for (int i = 0; i < 2; ++i) {
    ClipperLib::Clipper clipper;
    clipper.StrictlySimple(true);
    clipper.AddPaths(paths, ClipperLib::ptSubject, true);
    ClipperLib::Paths result;
    if (clipper.Execute(ClipperLib::ctUnion, result, ClipperLib::pftPositive)) return result;
  }
  throw std::runtime_error("the outlines of a piece could not be united");
}

}  // namespace

std::vector<Polygon> winding_union(std::span<const Polygon> lines) {
  ClipperLib::Paths paths;
  paths.reserve(lines.size());
  for (const Polygon& line : lines) {
    ClipperLib::Path& path = paths.emplace_back();
    path.reserve(line.size());
    for (const Vec2 p : line)
      path.push_back(on_grid(p));
  }
  // Crossings are rounded to the grid, which may make lines cross anew: hence the second time.
  const ClipperLib::Paths once = united(paths);
  if (once.empty()) return {};  // Clipper fails where there is nothing to unite
  const ClipperLib::Paths result = united(once);
  std::vector<Polygon> polygons;
  polygons.reserve(result.size());
  for (const ClipperLib::Path& path : result)
    polygons.push_back(off_grid(path));
  // Where lines have edges in common, Clipper may tell of holes first.
  std::stable_partition(polygons.begin(), polygons.end(),
                        [](const Polygon& polygon) { return signed_area(polygon) > 0.0; });
  return polygons;
}

}  // namespace planish
