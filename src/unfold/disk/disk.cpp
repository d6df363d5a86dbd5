#include "unfold/disk/disk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math.h"
#include "core/neumaier_sum.h"
#include "geometry/crosses_itself.h"
#include "mesh/border_loops.h"
#include "solve/dissection.h"

namespace planish {

namespace {

RestTriangle rest_triangle(Vec3 a, Vec3 b, Vec3 c) {
  // Below this share of its length a triangle's height says nothing about the surface.
  constexpr double least_height = 1e-6;
  const Vec3 side = b - a;
  const double length = norm(side);
  const double along = dot(side, c - a) / length;
  const double height = norm(cross(side, c - a)) / length;
  const double longest = std::max({length, norm(c - a), norm(c - b)});
  return {length, {along, std::max(height, least_height * longest)}};
}

/// The used vertices.
std::vector<Index> elimination_order(std::span<const Vec3> positions,
                                     const Connectivity& connectivity) {
  Graph graph;
  std::vector<Index> used;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto v = static_cast<Index>(i);
    const auto ring = connectivity.ring(v);
    graph.neighbours.insert(graph.neighbours.end(), ring.begin(), ring.end());
    graph.start.push_back(graph.neighbours.size());
    if (!ring.empty()) used.push_back(v);
  }
  return nested_dissection(positions, graph, std::move(used));
}

/// The loops of the border, the outline first.
std::vector<std::span<const Index>> ordered_loops(const Patch& patch) {
  std::vector<std::span<const Index>> loops(patch.border_loops().begin(),
                                            patch.border_loops().end());
  const std::size_t outline =
      border_kinds(patch.positions(), patch.connectivity(), patch.unit_scale()).outline;
  const auto begin = loops.begin(), at = begin + static_cast<std::ptrdiff_t>(outline);
  std::rotate(begin, at, at + 1);
  return loops;
}

}  // namespace

Disk make_disk(const Patch& patch) {
  Disk disk;
  disk.vertex_of = elimination_order(patch.positions(), patch.connectivity());
  disk.vertex_count = disk.vertex_of.size();
  std::vector<Index> number_of(patch.vertex_count(), 0);
  for (std::size_t i = 0; i < disk.vertex_count; ++i) {
    number_of[disk.vertex_of[i]] = static_cast<Index>(i);
    disk.on_border.push_back(patch.is_border(disk.vertex_of[i]) ? 1 : 0);
  }
  std::vector<std::size_t> sizes;
  for (const std::span<const Index> loop : ordered_loops(patch)) {
    sizes.push_back(loop.size());
    for (const Index v : loop)
      disk.border.push_back(number_of[v]);
  }
  disk.loops = LoopOrder(sizes);

  for (const Triangle& t : patch.triangles())
    disk.triangles.push_back({number_of[t[0]], number_of[t[1]], number_of[t[2]]});
  // In the order of their vertices, so that those of one triangle after another lie close.
  std::stable_sort(disk.triangles.begin(), disk.triangles.end(),
                   [](const Triangle& a, const Triangle& b) {
                     return std::min({a[0], a[1], a[2]}) < std::min({b[0], b[1], b[2]});
                   });

  const double to_unit_box = patch.unit_scale();
  NeumaierSum area;
  for (const Triangle& t : disk.triangles) {
    const auto corner = [&](int k) {
      return to_unit_box * patch.positions()[disk.vertex_of[t[k]]];
    };
    disk.rest.push_back(rest_triangle(corner(0), corner(1), corner(2)));
    area.add(disk.rest.back().area());
  }
  const double to_unit_area = 1.0 / std::sqrt(area.value());
  for (RestTriangle& rest : disk.rest) {
    rest.length *= to_unit_area;
    rest.tip = to_unit_area * rest.tip;
  }
  disk.box_scale = to_unit_box;
  disk.area_scale = to_unit_area;
  return disk;
}

std::optional<Disk> with_holes_filled(const Disk& disk, const Patch& patch) {
  if (disk.hole_count() == 0) return std::nullopt;
  // Lower triangles, as those of a narrow slit would be, only make the equations worse.
  constexpr double least_height = 0.1;
  Disk filled = disk;
  for (std::size_t hole = 1; hole < disk.loops.count(); ++hole) {
    const auto place = [&](std::size_t k) {
      return disk.area_scale * (disk.box_scale * patch.positions()[disk.vertex_of[disk.border[k]]]);
    };
    const std::size_t begin = disk.loops.begin(hole), end = disk.loops.end(hole);
    Vec3 middle;
    for (std::size_t k = begin; k < end; ++k)
      middle = middle + (1.0 / static_cast<double>(end - begin)) * place(k);
    const auto centre = static_cast<Index>(filled.vertex_count++);
    filled.on_border.push_back(0);
    for (std::size_t k = begin; k < end; ++k) {
      const auto [from, to] = disk.border_edge(k);
      filled.on_border[from] = 0;
      filled.triangles.push_back({to, from, centre});
      RestTriangle rest = rest_triangle(place(disk.loops.next(k)), place(k), middle);
      rest.tip.y = std::max(rest.tip.y, least_height * rest.length);
      filled.rest.push_back(rest);
    }
  }
  filled.border.resize(disk.loops.end(0));
  const std::size_t outer = disk.loops.end(0);
  filled.loops = LoopOrder(std::span(&outer, 1));
  return filled;
}

std::vector<double> border_lengths(const TriMesh& mesh, const Disk& disk) {
  std::vector<double> lengths;
  lengths.reserve(disk.border.size());
  for (std::size_t k = 0; k < disk.border.size(); ++k) {
    const auto [from, to] = disk.border_edge(k);
    const Vec3 a = mesh.positions[disk.vertex_of[from]], b = mesh.positions[disk.vertex_of[to]];
    lengths.push_back(disk.area_scale * norm(disk.box_scale * b - disk.box_scale * a));
  }
  return lengths;
}

std::vector<Vec2> border_of(const Disk& disk, std::span<const Vec2> flat) {
  std::vector<Vec2> outline;
  outline.reserve(disk.border.size());
  for (const Index v : disk.border)
    outline.push_back(flat[v]);
  return outline;
}

bool border_crosses_itself(const Disk& disk, std::span<const Vec2> flat) {
  return crosses_itself(border_of(disk, flat), disk.loops);
}

bool holes_cross(const Disk& disk, std::span<const Vec2> flat) {
  constexpr std::size_t k_most = 1000;
  if (disk.hole_count() == 0) return false;
  const auto pairs = crossing_sides(border_of(disk, flat), disk.loops, k_most);
  const std::size_t first = disk.loops.begin(1);
  return std::any_of(pairs.begin(), pairs.end(),
                     [&](const auto& pair) { return pair.first >= first || pair.second >= first; });
}

bool holes_are_open(const Disk& disk, std::span<const Vec2> flat) {
  if (disk.hole_count() == 0) return true;
  std::vector<double> angles(disk.vertex_count, 0.0);
  for (const Triangle& t : disk.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 a = flat[t[(k + 1) % 3]] - flat[t[k]], b = flat[t[(k + 2) % 3]] - flat[t[k]];
      angles[t[k]] += math::atan2(cross(a, b), dot(a, b));
    }
  }
  for (std::size_t hole = 1; hole < disk.loops.count(); ++hole) {
    double turning = 0.0;  // a multiple of 2 pi, but for rounding
    for (std::size_t k = disk.loops.begin(hole); k < disk.loops.end(hole); ++k)
      turning += std::numbers::pi - angles[disk.border[k]];
    if (!(std::abs(turning + 2.0 * std::numbers::pi) < 1.0)) return false;
  }
  return true;
}

bool all_upright(const Disk& disk, std::span<const Vec2> flat) {
  return std::all_of(disk.triangles.begin(), disk.triangles.end(), [&](const Triangle& t) {
    const Vec2 a = flat[t[1]] - flat[t[0]], b = flat[t[2]] - flat[t[0]], c = b - a;
    // The coordinates are near 1, so differences of them err by about 1e-16.
    const double longest = std::sqrt(std::max({dot(a, a), dot(b, b), dot(c, c)}));
    return cross(a, b) > 4e-16 * longest;
  });
}

}  // namespace planish
