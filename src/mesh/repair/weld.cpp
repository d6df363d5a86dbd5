#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <planish/core/error.h>
#include <planish/mesh/weld.h>

#include "mesh/repair/border_places.h"
#include "mesh/repair/glue.h"
#include "mesh/repair/repaired.h"
#include "mesh/repair/sheets.h"
#include "mesh/repair/t_junctions.h"

namespace planish {

namespace {

constexpr double k_default_share = 1e-5;

void require_length(double length) {
  if (length >= 0.0) return;
  throw Error(ErrorCode::option_out_of_range,
              "a length to weld within must be 0 or more, not " + std::to_string(length));
}

TriMesh at_unit_scale(TriMesh mesh) {
  const double scale = unit_scale(mesh);
  for (Vec3& p : mesh.positions)
    p = scale * p;
  return mesh;
}

/// A mesh divided at T-junctions, and what is to be joined of it.
struct Weld {
  DividedTriangles divided;
  std::vector<TJunction> junctions;
  Gluing gluing;
};

/// Divides at the junctions and finds what can be joined.
Weld weld_with(const TriMesh& mesh, const BorderPlaces& places, std::vector<TJunction> junctions) {
  Weld weld{divide_at(mesh, junctions), std::move(junctions), {}};
  std::vector<Index> place = places.of_vertex;
  for (const TJunction& junction : weld.junctions)
    place.push_back(junction.vertex);
  weld.gluing = find_gluing(weld.divided.mesh, place);
  return weld;
}

/// The junctions that let something be joined.
std::vector<TJunction> useful(const Weld& weld, std::size_t vertices) {
  std::vector<TJunction> kept;
  for (std::size_t j = 0; j < weld.junctions.size(); ++j) {
    if (weld.gluing.first[vertices + j] < vertices) kept.push_back(weld.junctions[j]);
  }
  return kept;
}

std::size_t divided_edges(const std::vector<TJunction>& junctions) {
  std::size_t count = 0;
  for (std::size_t j = 0; j < junctions.size(); ++j) {
    const bool same = j > 0 && junctions[j].side.triangle == junctions[j - 1].side.triangle &&
                      junctions[j].side.corner == junctions[j - 1].side.corner;
    count += same ? 0 : 1;
  }
  return count;
}

/// The mesh with what was joined, and only those new vertices that it needs.
WeldedMesh welded(const TriMesh& mesh, const Weld& weld, double scale) {
  const std::size_t count = mesh.positions.size();
  WeldedMesh result{unchanged(mesh)};
  std::vector<Index> number = weld.gluing.first;
  for (std::size_t v = count; v < number.size(); ++v) {
    if (number[v] != v) continue;
    number[v] = static_cast<Index>(result.mesh.positions.size());
    result.vertex_source.push_back(weld.divided.vertex_source[v]);
    result.mesh.positions.push_back(mesh.positions[weld.divided.vertex_source[v]]);
  }
  for (std::size_t v = count; v < number.size(); ++v) {
    if (const Index first = weld.gluing.first[v]; first != v) number[v] = number[first];
  }
  result.mesh.triangles = weld.divided.mesh.triangles;
  for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
    Triangle& corners = result.mesh.triangles[t];
    for (Index& v : corners)
      v = number[v];
    if (weld.gluing.turned[t] != 0) std::swap(corners[1], corners[2]);
    result.turned += weld.gluing.turned[t];
  }
  result.source = weld.divided.source;
  result.joined = weld.gluing.joined;
  result.left = weld.gluing.left;
  result.length = weld.gluing.length / scale;
  result.divided = divided_edges(weld.junctions);
  return result;
}

/// An edge of the border of a sheet.
struct SheetEdge {
  Vec3 from, to;
  Index sheet;

  double low() const { return std::min(from.x, to.x); }
};

double squared_distance(Vec3 p, const SheetEdge& edge) {
  const Vec3 way = edge.to - edge.from;
  const double all = dot(way, way);
  const double share = all > 0.0 ? std::clamp(dot(p - edge.from, way) / all, 0.0, 1.0) : 0.0;
  const Vec3 rest = p - edge.from - share * way;
  return dot(rest, rest);
}

}  // namespace

std::optional<double> nearest_border_gap(const TriMesh& mesh) {
  require_entries(mesh);
  if (mesh.triangles.empty()) return std::nullopt;
  const TriMesh unit = at_unit_scale(mesh);
  const Sheets sheets = find_sheets(unit);
  std::vector<SheetEdge> edges;
  double longest = 0.0;
  for (const EdgeSide& side : border_sides(unit)) {
    edges.push_back(
        {unit.positions[side.low], unit.positions[side.high], sheets.of_triangle[side.triangle]});
    longest = std::max(longest, std::abs(edges.back().to.x - edges.back().from.x));
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const SheetEdge& a, const SheetEdge& b) { return a.low() < b.low(); });
  double best = std::numeric_limits<double>::infinity();  // squared
  for (const SheetEdge& one : edges) {
    for (const Vec3 p : {one.from, one.to}) {
      const double reach = std::sqrt(best);
      auto at =
          std::lower_bound(edges.begin(), edges.end(), p.x - reach - longest,
                           [](const SheetEdge& edge, double value) { return edge.low() < value; });
      for (; at != edges.end() && at->low() <= p.x + std::sqrt(best); ++at) {
        if (at->sheet != one.sheet) best = std::min(best, squared_distance(p, *at));
      }
    }
  }
  if (std::isinf(best)) return std::nullopt;
  return std::sqrt(best) / unit_scale(mesh);
}

double default_weld_length(const TriMesh& mesh) {
  return k_default_share * bounding_box_diagonal(mesh);
}

WeldedMesh weld(const TriMesh& mesh, double length) {
  require_length(length);
  require_entries(mesh);
  if (mesh.triangles.empty()) return {unchanged(mesh)};
  const TriMesh unit = at_unit_scale(mesh);
  const double scale = unit_scale(mesh);
  const std::vector<EdgeSide> border = border_sides(unit);
  const BorderPlaces places = find_border_places(unit, border, scale * length);
  Weld found = weld_with(unit, places, find_t_junctions(unit, border, places));
  // A vertex beside an edge whose neighbours are not beside it joins nothing. Leaving it out may
  // spoil another one's edge, so this is done again; one that is of no use does no harm.
  constexpr int k_rounds = 8;
  for (int round = 0; round < k_rounds; ++round) {
    auto kept = useful(found, mesh.positions.size());
    if (kept.size() == found.junctions.size()) break;
    found = weld_with(unit, places, std::move(kept));
  }
  WeldedMesh result = welded(mesh, found, scale);
  result.held =
      static_cast<std::size_t>(std::count_if(places.reach.begin(), places.reach.end(),
                                             [&](double reach) { return reach < scale * length; }));
  return result;
}

TouchingPieces find_touching_pieces(const TriMesh& mesh, double length) {
  require_length(length);
  require_entries(mesh);
  const Sheets before = find_sheets(mesh);
  if (before.count < 2) return {};
  const WeldedMesh joined = weld(mesh, length);
  const Sheets after = find_sheets(joined.mesh);
  std::vector<std::pair<Index, Index>> pieces;  // of the welded mesh, of the mesh
  for (std::size_t t = 0; t < joined.source.size(); ++t)
    pieces.emplace_back(after.of_triangle[t], before.of_triangle[joined.source[t]]);
  std::sort(pieces.begin(), pieces.end());
  pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
  TouchingPieces touching;
  for (std::size_t begin = 0; begin < pieces.size();) {
    std::size_t end = begin;
    while (end < pieces.size() && pieces[end].first == pieces[begin].first)
      ++end;
    if (end - begin > 1) {
      touching.pieces += end - begin;
      ++touching.joined;
    }
    begin = end;
  }
  if (touching.joined > 0) touching.length = joined.length;
  return touching;
}

}  // namespace planish
