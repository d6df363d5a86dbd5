#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/mesh/wall.h>

#include "core/math.h"
#include "mesh/disjoint_sets.h"
#include "mesh/edge_sides.h"
#include "mesh/repair/facing.h"
#include "mesh/repair/repaired.h"
#include "mesh/repair/sheets.h"
#include "mesh/turning_sets.h"

namespace planish {

namespace {

// Triangles at the side of others go with them while normals differ by less than 30 degrees.
constexpr double k_smooth = 0.8660254037844386;
// Of the area, what contradicts that a side faces the other one and not itself.
constexpr double k_contradiction = 0.02;
// A side bulges where its bends make up this fraction of all bends, either way, and this many
// radians across the root of its area. A sheet that turns by half a degree is flat.
constexpr double k_one_way = 0.1;
constexpr double k_least_turn = 0.01;

constexpr Index k_no_sheet = static_cast<Index>(-1);

/// The mesh at the scale of its unit_scale(), with the first vertex of a triangle at the origin.
TriMesh near_origin(TriMesh mesh) {
  const double scale = unit_scale(mesh);
  const Vec3 origin = scale * mesh.positions[mesh.triangles.front().front()];
  for (Vec3& p : mesh.positions)
    p = scale * p - origin;
  return mesh;
}

/// Parts of the sides: triangles that face others and share edges.
Sheets facing_sheets(const FacingTriangles& facing, const std::vector<EdgeSides>& edges) {
  const std::size_t count = facing.opposite.size();
  DisjointSets<Index> sets(count);
  const auto faces = [&](Index t) { return facing.opposite[t] != FacingTriangles::none; };
  for (const EdgeSides& edge : edges) {
    if (edge.size() != 2) continue;
    const Index a = edge.begin[0].triangle, b = edge.begin[1].triangle;
    if (faces(a) && faces(b)) sets.join(a, b);
  }
  Sheets sheets{std::vector<Index>(count, k_no_sheet), 0};
  for (std::size_t i = 0; i < count; ++i) {
    const auto t = static_cast<Index>(i);
    if (!faces(t)) continue;
    const Index first = sets.first_of(t);
    sheets.of_triangle[t] =
        first == t ? static_cast<Index>(sheets.count++) : sheets.of_triangle[first];
  }
  return sheets;
}

/// Two sheets that face each other, on some area.
struct Pair {
  Index one, other;
  double area;
};

std::vector<Pair> facing_pairs(const FacingTriangles& facing, const Sheets& sheets,
                               const std::vector<double>& areas) {
  std::vector<Pair> pairs;
  for (std::size_t t = 0; t < areas.size(); ++t) {
    if (facing.opposite[t] == FacingTriangles::none) continue;
    const Index here = sheets.of_triangle[t], there = sheets.of_triangle[facing.opposite[t]];
    if (there == k_no_sheet) continue;
    pairs.push_back({std::min(here, there), std::max(here, there), areas[t]});
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.one, a.other) < std::tie(b.one, b.other);
  });
  std::vector<Pair> sums;
  for (const Pair& pair : pairs) {
    if (!sums.empty() && sums.back().one == pair.one && sums.back().other == pair.other) {
      sums.back().area += pair.area;
    } else {
      sums.push_back(pair);
    }
  }
  std::sort(sums.begin(), sums.end(), [](const Pair& a, const Pair& b) {
    return a.area != b.area ? a.area > b.area : std::tie(a.one, a.other) < std::tie(b.one, b.other);
  });
  return sums;
}

/// Which sheets are on the side of the first sheet of what they hang together with (0) and which
/// on the other (1); nothing where sheets face themselves.
std::optional<TurningSets> sides_of(const std::vector<Pair>& pairs, std::size_t sheets) {
  TurningSets sets(sheets);
  double whole = 0.0, contradicts = 0.0;
  for (const Pair& pair : pairs) {
    whole += pair.area;
    if (pair.one == pair.other || !sets.join(pair.one, pair.other, 1)) contradicts += pair.area;
  }
  if (contradicts > k_contradiction * whole) return std::nullopt;
  return sets;
}

/// Of each triangle the side that it is on: 2 s for that of the first sheet of what hangs together
/// with sheet s, 2 s + 1 for the other one; k_no_sheet for what faces nothing that faces a side.
std::vector<Index> sides_of_triangles(TurningSets sets, const Sheets& sheets) {
  std::vector<std::array<bool, 2>> has(sheets.count, {false, false});
  for (std::size_t s = 0; s < sheets.count; ++s) {
    const auto first = sets.first_of(static_cast<Index>(s));
    has[first.number][first.turned] = true;
  }
  std::vector<Index> side(sheets.of_triangle.size(), k_no_sheet);
  for (std::size_t t = 0; t < side.size(); ++t) {
    if (sheets.of_triangle[t] == k_no_sheet) continue;
    const auto first = sets.first_of(sheets.of_triangle[t]);
    if (has[first.number][0] && has[first.number][1]) side[t] = 2 * first.number + first.turned;
  }
  return side;
}

/// Of each triangle the neighbour across each of its sides; k_no_sheet where there is none.
using Neighbors = std::vector<std::array<Index, 3>>;

Neighbors neighbors_of(std::size_t triangles, const std::vector<EdgeSides>& edges) {
  Neighbors neighbors(triangles, {k_no_sheet, k_no_sheet, k_no_sheet});
  for (const EdgeSides& edge : edges) {
    if (edge.size() != 2) continue;
    const EdgeSide &a = edge.begin[0], &b = edge.begin[1];
    neighbors[a.triangle][a.corner] = b.triangle;
    neighbors[b.triangle][b.corner] = a.triangle;
  }
  return neighbors;
}

Vec3 unit_normal(const TriMesh& mesh, std::size_t t) {
  const Triangle& corners = mesh.triangles[t];
  const Vec3 normal = cross(mesh.positions[corners[1]] - mesh.positions[corners[0]],
                            mesh.positions[corners[2]] - mesh.positions[corners[0]]);
  const double length = norm(normal);
  return length > 0.0 ? 1.0 / length * normal : Vec3{};
}

/// Gives triangles beside a side, such as those near a fold, to it where the surface goes on
/// smoothly.
std::vector<Index> spread(const TriMesh& mesh, const Neighbors& neighbors,
                          std::vector<Index> side) {
  std::vector<Vec3> normals;
  normals.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    normals.push_back(unit_normal(mesh, t));
  struct Waiting {
    Index triangle;
    Index seed;  // a triangle that faces the other side
  };
  std::vector<Waiting> waiting;
  for (std::size_t t = 0; t < side.size(); ++t) {
    if (side[t] != k_no_sheet) waiting.push_back({static_cast<Index>(t), static_cast<Index>(t)});
  }
  for (std::size_t i = 0; i < waiting.size(); ++i) {
    const Waiting from = waiting[i];
    for (const Index to : neighbors[from.triangle]) {
      if (to == k_no_sheet || side[to] != k_no_sheet) continue;
      if (dot(normals[to], normals[from.seed]) < k_smooth) continue;
      side[to] = side[from.triangle];
      waiting.push_back({to, from.seed});
    }
  }
  return side;
}

/// Gives what lies within one side to it. A rim is between two sides, or at a border.
std::vector<Index> without_gaps(const Neighbors& neighbors, std::vector<Index> side) {
  std::vector<unsigned char> seen(side.size(), 0);
  for (std::size_t t = 0; t < side.size(); ++t) {
    if (seen[t] != 0 || side[t] != k_no_sheet) continue;
    std::vector<Index> gap{static_cast<Index>(t)};
    seen[t] = 1;
    Index around = k_no_sheet;
    bool is_rim = false;
    for (std::size_t i = 0; i < gap.size(); ++i) {
      for (const Index to : neighbors[gap[i]]) {
        if (to == k_no_sheet) {
          is_rim = true;
        } else if (side[to] == k_no_sheet) {
          if (seen[to] == 0) gap.push_back(to);
          seen[to] = 1;
        } else {
          is_rim = is_rim || (around != k_no_sheet && around != side[to]);
          around = side[to];
        }
      }
    }
    for (const Index within : gap)
      side[within] = is_rim ? k_no_sheet : around;
  }
  return side;
}

/// Whether the triangle is oriented towards the one that it faces.
bool must_turn(const TriMesh& mesh, const FacingTriangles& facing, std::size_t t) {
  if (facing.way != Facing::same_way) return facing.way == Facing::towards;
  const Triangle &here = mesh.triangles[t], &there = mesh.triangles[facing.opposite[t]];
  const Vec3 normal = cross(mesh.positions[here[1]] - mesh.positions[here[0]],
                            mesh.positions[here[2]] - mesh.positions[here[0]]);
  const auto sum = [&](const Triangle& corners) {
    return mesh.positions[corners[0]] + mesh.positions[corners[1]] + mesh.positions[corners[2]];
  };
  return dot(normal, sum(there) - sum(here)) > 0.0;
}

/// How the sides of a wall bend: lengths of edges times angles, above 0 where the side bulges.
class SideBends {
 public:
  SideBends(const TriMesh& mesh, const FacingTriangles& facing) : mesh_(mesh), facing_(facing) {
    away_.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const bool faces = facing.opposite[t] != FacingTriangles::none;
      const Vec3 normal = unit_normal(mesh, t);
      away_.push_back(faces && must_turn(mesh, facing, t) ? -normal : normal);
    }
  }

  /// The bend that both sides have there: a bevel is on one side only, or on both against each
  /// other.
  double at(const EdgeSide& one, const EdgeSide& other) const {
    const Index a = facing_.opposite[one.triangle], b = facing_.opposite[other.triangle];
    if (a == FacingTriangles::none || b == FacingTriangles::none) return 0.0;
    const Vec3 normal = away_[one.triangle], next = away_[other.triangle];
    const Vec3 axis = cross(normal, next);
    const double sine = norm(axis);
    if (!(sine > 0.0)) return 0.0;
    const Vec3 there = along(a, normal), there_next = along(b, next);
    const double here = math::atan2(sine, dot(normal, next));
    const double beyond =
        math::atan2(dot(cross(there, there_next), axis) / sine, dot(there, there_next));
    const Vec3 from = mesh_.positions[one.low];
    const double length = norm(mesh_.positions[one.high] - from);
    const Vec3 third = mesh_.positions[third_of(other)] - from;
    const double sign = dot(third, normal) < 0.0 ? 1.0 : -1.0;
    return sign * length * std::min(here, std::max(beyond, 0.0));
  }

 private:
  Index third_of(const EdgeSide& side) const {
    return mesh_.triangles[side.triangle][(side.corner + 2) % 3];
  }
  /// The normal of a triangle of the other side, as that on this side points.
  Vec3 along(Index t, Vec3 normal) const {
    return dot(away_[t], normal) < 0.0 ? -away_[t] : away_[t];
  }

  const TriMesh& mesh_;
  const FacingTriangles& facing_;
  std::vector<Vec3> away_;  // normals away from the other side
};

/// What tells which side of each wall is the outer one: by the numbers of sides, the bends that
/// make it bulge less those that make it hollow, all of them, and the area.
struct BendsOfSide {
  double sum = 0.0, all = 0.0, area = 0.0;
};

std::vector<BendsOfSide> bends_of_sides(const TriMesh& mesh, const FacingTriangles& facing,
                                        const std::vector<EdgeSides>& edges,
                                        const std::vector<Index>& side,
                                        const std::vector<double>& areas, std::size_t sheets) {
  const SideBends bends(mesh, facing);
  std::vector<BendsOfSide> sums(2 * sheets);
  for (std::size_t t = 0; t < side.size(); ++t) {
    if (side[t] != k_no_sheet) sums[side[t]].area += areas[t];
  }
  for (const EdgeSides& edge : edges) {
    if (edge.size() != 2) continue;
    const Index here = side[edge.begin[0].triangle];
    if (here == k_no_sheet || here != side[edge.begin[1].triangle]) continue;
    const double bend = bends.at(edge.begin[0], edge.begin[1]);
    sums[here].sum += bend;
    sums[here].all += std::abs(bend);
  }
  return sums;
}

/// In every wall of the mesh the side that bulges is the outer one.
/// @return also whether some wall is level
std::pair<std::vector<WallPart>, bool> parts_of(const std::vector<Index>& side,
                                                const std::vector<BendsOfSide>& bends) {
  bool is_level = false;
  std::vector<unsigned char> second_is_outer(bends.size() / 2, 0);
  for (std::size_t k = 0; k < second_is_outer.size(); ++k) {
    const BendsOfSide &first = bends[2 * k], &second = bends[2 * k + 1];
    const double area = 0.5 * (first.area + second.area);
    if (!(area > 0.0)) continue;
    const double sum = 0.5 * (first.sum - second.sum), all = 0.5 * (first.all + second.all);
    const bool bulges = std::abs(sum) > std::max(k_one_way * all, k_least_turn * std::sqrt(area));
    is_level = is_level || !bulges;
    second_is_outer[k] = bulges && sum < 0.0 ? 1 : 0;
  }
  std::vector<WallPart> parts(side.size(), WallPart::rim);
  for (std::size_t t = 0; t < side.size(); ++t) {
    if (side[t] == k_no_sheet) continue;
    const bool is_second = side[t] % 2 != 0;
    const bool is_outer = is_second == (second_is_outer[side[t] / 2] != 0);
    parts[t] = is_outer ? WallPart::outer : WallPart::inner;
  }
  return {std::move(parts), is_level};
}

}  // namespace

std::optional<Wall> find_wall(const TriMesh& mesh) {
  require_entries(mesh);
  if (mesh.triangles.empty() || !Connectivity::build(mesh)) return std::nullopt;
  const TriMesh near = near_origin(mesh);
  const auto facing = find_facing(near);
  if (!facing) return std::nullopt;
  const std::vector<EdgeSide> sides = sorted_sides(near);
  const std::vector<EdgeSides> edges = group_by_edge(sides);
  const Sheets sheets = facing_sheets(*facing, edges);
  const std::vector<double> areas = unit_areas(near);
  auto sets = sides_of(facing_pairs(*facing, sheets, areas), sheets.count);
  if (!sets) return std::nullopt;
  const Neighbors neighbors = neighbors_of(near.triangles.size(), edges);
  const std::vector<Index> side = without_gaps(
      neighbors, spread(near, neighbors, sides_of_triangles(*std::move(sets), sheets)));
  auto [parts, is_level] =
      parts_of(side, bends_of_sides(near, *facing, edges, side, areas, sheets.count));
  Wall wall{facing->distance / unit_scale(mesh), std::move(parts), {}, is_level};
  std::array<double, 3> turned{};  // area of each part that faces the other side, less the rest
  for (std::size_t t = 0; t < areas.size(); ++t) {
    if (facing->opposite[t] == FacingTriangles::none) continue;
    turned[static_cast<std::size_t>(wall.part[t])] +=
        must_turn(near, *facing, t) ? areas[t] : -areas[t];
  }
  wall.turned = {turned[0] > 0.0, turned[1] > 0.0};
  return wall;
}

RepairedMesh take_side(const TriMesh& mesh, const Wall& wall, WallPart side) {
  std::vector<Index> others;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (wall.part[t] != side) others.push_back(static_cast<Index>(t));
  }
  RepairedMesh taken = without_triangles(mesh, others);
  if (side != WallPart::rim && wall.turned[static_cast<std::size_t>(side)])
    taken.mesh = turned_over(std::move(taken.mesh));
  return taken;
}

}  // namespace planish
