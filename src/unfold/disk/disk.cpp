#include "unfold/disk/disk.h"

#include <algorithm>
#include <cmath>

#include "core/neumaier_sum.h"
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
  for (const Index v : patch.border_loops().front())
    disk.border.push_back(number_of[v]);

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

std::vector<double> border_lengths(const TriMesh& mesh, const Disk& disk) {
  std::vector<double> lengths;
  lengths.reserve(disk.border.size());
  for (std::size_t k = 0; k < disk.border.size(); ++k) {
    const Vec3 a = mesh.positions[disk.vertex_of[disk.border[k]]];
    const Vec3 b = mesh.positions[disk.vertex_of[disk.border[(k + 1) % disk.border.size()]]];
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

bool all_upright(const Disk& disk, std::span<const Vec2> flat) {
  return std::all_of(disk.triangles.begin(), disk.triangles.end(), [&](const Triangle& t) {
    const Vec2 a = flat[t[1]] - flat[t[0]], b = flat[t[2]] - flat[t[0]], c = b - a;
    // The coordinates are near 1, so differences of them err by about 1e-16.
    const double longest = std::sqrt(std::max({dot(a, a), dot(b, b), dot(c, c)}));
    return cross(a, b) > 4e-16 * longest;
  });
}

}  // namespace planish
