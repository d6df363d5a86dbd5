#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <planish/core/error.h>
#include <planish/mesh/cut.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/repair.h>

#include "geometry/curve_size.h"
#include "mesh/disjoint_sets.h"
#include "mesh/edge_sides.h"
#include "mesh/repair/border_places.h"
#include "mesh/repair/repaired.h"
#include "mesh/repair/sheets.h"
#include "mesh/repair/triangulate_loop.h"

namespace planish {

namespace {

// Closing a hole takes cubic time.
constexpr std::size_t k_most_edges = 500;

/// A corner of a hole. Where holes touch, their border has several vertices at one place.
struct HoleCorner {
  Index arrival, departure;  // vertices at which the edges before and behind it end
};

/// A closed curve of the border that passes no place twice, the surface on its left.
struct Hole {
  std::vector<HoleCorner> corners;
  CurveSize size = {};
  Index piece = 0;
  std::size_t loop = 0;  // of the border

  /// Two edges on each other.
  bool is_slit() const { return corners.size() == 2; }
};

/// Divides loops where they pass a place again.
class LoopDivision {
 public:
  explicit LoopDivision(const TriMesh& mesh)
      : place_(first_at_place(mesh.positions)), where_(place_.size(), RepairedMesh::none) {}

  std::vector<Hole> holes_of(const std::vector<Index>& loop) {
    std::vector<Hole> holes;
    std::vector<HoleCorner> open;
    for (const Index v : loop) {
      Index& where = where_[place_[v]];
      if (where == RepairedMesh::none) {
        where = static_cast<Index>(open.size());
        open.push_back({v, v});
        continue;
      }
      Hole hole{{{v, open[where].departure}}};
      hole.corners.insert(hole.corners.end(), open.begin() + where + 1, open.end());
      forget(std::span(hole.corners).subspan(1));
      open.resize(where + 1);
      open.back().departure = v;
      holes.push_back(std::move(hole));
    }
    forget(open);
    holes.push_back({std::move(open)});
    return holes;
  }

 private:
  void forget(std::span<const HoleCorner> corners) {
    for (const HoleCorner& corner : corners)
      where_[place_[corner.arrival]] = RepairedMesh::none;
  }

  std::vector<Index> place_;  // of each vertex
  std::vector<Index> where_;  // among the open corners, by place
};

/// The vertices at the ends of the edge behind a corner.
std::vector<Index> edge_behind(const Hole& hole, std::size_t corner) {
  const std::size_t next = (corner + 1) % hole.corners.size();
  return {hole.corners[corner].departure, hole.corners[next].arrival};
}

/// The sides of all triangles by edge, to be looked up.
class EdgeTable {
 public:
  explicit EdgeTable(const TriMesh& mesh) : sides_(sorted_sides(mesh)) {}

  /// The triangle of an edge of one; none where there is no such edge.
  Index triangle_at(Index a, Index b) const {
    const auto [low, high] = std::minmax(a, b);
    const auto at =
        std::lower_bound(sides_.begin(), sides_.end(), std::pair<Index, Index>(low, high),
                         [](const EdgeSide& side, const std::pair<Index, Index>& ends) {
                           return std::pair(side.low, side.high) < ends;
                         });
    const bool found = at != sides_.end() && at->low == low && at->high == high;
    return found ? at->triangle : RepairedMesh::none;
  }

 private:
  std::vector<EdgeSide> sides_;
};

Vec3 unit_normal(const Triangle& t, const std::vector<Vec3>& positions) {
  const Vec3 normal = cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
  const double length = norm(normal);
  return length > 0.0 ? 1.0 / length * normal : Vec3{};
}

/// Every curve of the border, and which of them are the outer ones of their piece: the largest, in
/// a tie the first.
struct BorderCurves {
  std::vector<Hole> holes;
  std::vector<unsigned char> is_outer;

  struct Loop {
    double length = 0.0;
    bool has_outer = false;  // with the outer curve of its piece
  };
  std::vector<Loop> loops;
};

BorderCurves border_curves(const TriMesh& mesh, const Connectivity& connectivity,
                           const EdgeTable& edges) {
  LoopDivision division(mesh);
  const Sheets pieces = find_sheets(mesh);
  BorderCurves curves;
  constexpr std::size_t k_no_hole = static_cast<std::size_t>(-1);
  std::vector<std::size_t> outer(pieces.count, k_no_hole);
  for (const std::vector<Index>& loop : connectivity.border_loops()) {
    curves.loops.emplace_back();
    for (Hole& hole : division.holes_of(loop)) {
      Box box;
      for (std::size_t i = 0; i < hole.corners.size(); ++i) {
        hole.size.length += path_length(edge_behind(hole, i), mesh.positions);
        box.add(mesh.positions[hole.corners[i].arrival]);
      }
      hole.size.reach = diagonal_of(box);
      hole.piece = pieces.of_triangle[edges.triangle_at(loop[0], loop[1])];
      hole.loop = curves.loops.size() - 1;
      curves.loops.back().length += hole.size.length;
      std::size_t& best = outer[hole.piece];
      if (best == k_no_hole || is_larger(hole.size, curves.holes[best].size))
        best = curves.holes.size();
      curves.holes.push_back(std::move(hole));
    }
  }
  curves.is_outer.assign(curves.holes.size(), 0);
  for (const std::size_t hole : outer) {
    if (hole == k_no_hole) continue;
    curves.is_outer[hole] = 1;
    curves.loops[curves.holes[hole].loop].has_outer = true;
  }
  return curves;
}

/// Triangles that close the hole, with the surface's orientation; corners that are several vertices
/// are named by their arrivals.
/// @param mesh at the scale of unit_scale()
std::optional<std::vector<Triangle>> filling(const TriMesh& mesh, const EdgeTable& edges,
                                             const Hole& hole) {
  const std::size_t count = hole.corners.size();
  if (count < 3 || count > k_most_edges) return std::nullopt;
  // The surface is on the left of the border, the filling on its right.
  const auto corner = [&](std::size_t i) { return hole.corners[count - 1 - i]; };
  std::vector<Vec3> places, beside;
  for (std::size_t i = 0; i < count; ++i) {
    places.push_back(mesh.positions[corner(i).arrival]);
    const std::vector<Index> edge = edge_behind(hole, (2 * count - 2 - i) % count);
    beside.push_back(
        unit_normal(mesh.triangles[edges.triangle_at(edge[0], edge[1])], mesh.positions));
  }
  const auto may_join = [&](std::size_t i, std::size_t j) {
    for (const Index v : {corner(i).arrival, corner(i).departure}) {
      for (const Index w : {corner(j).arrival, corner(j).departure}) {
        if (edges.triangle_at(v, w) != RepairedMesh::none) return false;
      }
    }
    return true;
  };
  auto triangles = triangulate_loop(places, beside, may_join);
  if (!triangles) return std::nullopt;
  for (Triangle& t : *triangles)
    t = {corner(t[0]).arrival, corner(t[1]).arrival, corner(t[2]).arrival};
  return triangles;
}

void join_sides(const Hole& hole, DisjointSets<Index>& vertices) {
  for (const HoleCorner& corner : hole.corners)
    vertices.join(corner.arrival, corner.departure);
}

}  // namespace

FilledMesh fill_holes(const TriMesh& mesh, double length) {
  if (!(length > 0.0)) {
    throw Error(ErrorCode::option_out_of_range,
                "the length of holes to fill must be above 0, not " + std::to_string(length));
  }
  FilledMesh result{unchanged(mesh)};
  const auto connectivity = Connectivity::build(mesh);
  if (mesh.triangles.empty() || !connectivity) return result;
  const EdgeTable edges(mesh);
  const BorderCurves curves = border_curves(mesh, *connectivity, edges);
  TriMesh unit = mesh;
  const double scale = unit_scale(mesh);
  for (Vec3& p : unit.positions)
    p = scale * p;
  DisjointSets<Index> vertices(mesh.positions.size());
  std::vector<unsigned char> is_welded(curves.loops.size(), 0);
  for (std::size_t h = 0; h < curves.holes.size(); ++h) {
    const Hole& hole = curves.holes[h];
    if (hole.is_slit()) {
      // One from the outer border is a cut. The others of a loop are one hole.
      const BorderCurves::Loop& loop = curves.loops[hole.loop];
      if (loop.has_outer || !(loop.length <= length)) continue;
      join_sides(hole, vertices);
      result.filled += 1 - is_welded[hole.loop];
      is_welded[hole.loop] = 1;
      continue;
    }
    if (curves.is_outer[h] != 0 || !(hole.size.length <= length)) continue;
    const auto triangles = filling(unit, edges, hole);
    ++(triangles ? result.filled : result.left);
    if (!triangles) continue;
    result.mesh.triangles.insert(result.mesh.triangles.end(), triangles->begin(), triangles->end());
    join_sides(hole, vertices);
  }
  result.source.resize(result.mesh.triangles.size(), RepairedMesh::none);
  for (Triangle& t : result.mesh.triangles) {
    for (Index& v : t)
      v = vertices.first_of(v);
  }
  if (result.filled == 0 || Connectivity::build(result.mesh)) return result;
  // Holes that touch where the mesh was not sound before it was divided.
  return {unchanged(mesh), 0, result.filled + result.left};
}

}  // namespace planish
