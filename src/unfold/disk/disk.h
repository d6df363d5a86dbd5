#pragma once

#include <span>
#include <vector>

#include <planish/mesh/patch.h>

#include "energy/symmetric_dirichlet.h"

namespace planish {

/// A disk patch as the unfolding needs it: used vertices only, numbered in an order that keeps
/// sparse factors small, so that matrices over them are factored as they are; lengths scaled so
/// that the total area is 1.
struct Disk {
  std::size_t vertex_count = 0;
  std::vector<Triangle> triangles;
  std::vector<RestTriangle> rest;
  std::vector<Index> border;     ///< the border loop, the disk on its left
  std::vector<Index> vertex_of;  ///< number in the mesh
  /// From model units to these: one after the other, as their product may be out of range.
  double box_scale = 1.0, area_scale = 1.0;

  bool is_border(Index v) const { return on_border[v] != 0; }
  std::vector<unsigned char> on_border;
};

/// @pre the mesh is a disk
Disk make_disk(const Patch& patch);

/// The lengths on the patch of the sides from border[k] to border[k + 1], in the disk's units.
std::vector<double> border_lengths(const TriMesh& mesh, const Disk& disk);

/// How long the border edges of a disk are to be: the one from border[k] to border[k + 1] is number
/// k.
struct BorderLengths {
  std::vector<double> of_edges;    ///< in the disk's units
  std::vector<char> is_free = {};  ///< of each: it may have any length; empty: none may

  bool may_change(std::size_t k) const { return !is_free.empty() && is_free[k] != 0; }
};

/// The border laid flat, vertex by vertex.
std::vector<Vec2> border_of(const Disk& disk, std::span<const Vec2> flat);

/// Twice the signed area of a triangle laid flat.
inline double doubled_area(const Triangle& t, std::span<const Vec2> flat) {
  return cross(flat[t[1]] - flat[t[0]], flat[t[2]] - flat[t[0]]);
}

/// True if every triangle laid flat has an area above 0 that can be told from rounding.
bool all_upright(const Disk& disk, std::span<const Vec2> flat);

}  // namespace planish
