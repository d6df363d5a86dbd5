#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>

#include "energy/symmetric_dirichlet.h"
#include "geometry/loop_order.h"

namespace planish {

/// A disk, perhaps with holes, as the unfolding needs it: used vertices only, numbered in an order
/// that keeps sparse factors small, so that matrices over them are factored as they are; lengths
/// scaled so that the total area is 1.
struct Disk {
  std::size_t vertex_count = 0;
  std::vector<Triangle> triangles;
  std::vector<RestTriangle> rest;
  /// Of the border loops, one behind the other: the outer one, which is the largest, and those of
  /// the holes; the disk is on their left.
  std::vector<Index> border;
  LoopOrder loops;               ///< the order around the places in `border`
  std::vector<Index> vertex_of;  ///< number in the mesh
  /// From model units to these: one after the other, as their product may be out of range.
  double box_scale = 1.0, area_scale = 1.0;

  bool is_border(Index v) const { return on_border[v] != 0; }
  std::size_t hole_count() const { return loops.count() - 1; }
  /// The vertices of the outer border loop.
  std::span<const Index> outer_border() const { return std::span(border).first(loops.end(0)); }
  /// The border edge from border[k] to the next vertex around.
  std::array<Index, 2> border_edge(std::size_t k) const {
    return {border[k], border[loops.next(k)]};
  }
  std::vector<unsigned char> on_border;
};

/// @pre the mesh is a disk, perhaps with holes
Disk make_disk(const Patch& patch);

/// The disk without its holes: each is closed by a fan around a vertex at its middle, whose
/// triangles have any shape. These vertices come behind the others, and so do these triangles.
/// Nothing where there is no hole.
std::optional<Disk> with_holes_filled(const Disk& disk, const Patch& patch);

/// The lengths on the patch of the border edges, in the disk's units.
std::vector<double> border_lengths(const TriMesh& mesh, const Disk& disk);

/// How long the border edges of a disk are to be, by their numbers there.
struct BorderLengths {
  std::vector<double> of_edges;    ///< in the disk's units
  std::vector<char> is_free = {};  ///< of each: it may have any length; empty: none may

  bool may_change(std::size_t k) const { return !is_free.empty() && is_free[k] != 0; }
};

/// The border laid flat, vertex by vertex.
std::vector<Vec2> border_of(const Disk& disk, std::span<const Vec2> flat);

/// Whether the border laid flat crosses itself. If it does not, and all_upright(), no part of the
/// disk lies over another one: an immersion of a disk with h holes has winding numbers of its loops
/// that add up to 1 - h, those of loops that do not cross are 1 or -1, and a place is covered as
/// many times as the loops around it add up to; so one loop is around all others.
bool border_crosses_itself(const Disk& disk, std::span<const Vec2> flat);

/// Whether the border of a hole crosses itself or another part of the border; of many crossings
/// some are looked at.
bool holes_cross(const Disk& disk, std::span<const Vec2> flat);

/// Whether every hole laid flat is turned as it has to be: its loop goes around once, the disk on
/// its left. @pre all_upright()
bool holes_are_open(const Disk& disk, std::span<const Vec2> flat);

/// Twice the signed area of a triangle laid flat.
inline double doubled_area(const Triangle& t, std::span<const Vec2> flat) {
  return cross(flat[t[1]] - flat[t[0]], flat[t[2]] - flat[t[0]]);
}

/// True if every triangle laid flat has an area above 0 larger than rounding errors.
bool all_upright(const Disk& disk, std::span<const Vec2> flat);

}  // namespace planish
