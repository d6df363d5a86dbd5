#pragma once

#include <cstddef>
#include <vector>

#include <planish/mesh/carry.h>
#include <planish/mesh/patch.h>

#include "mesh/half_edges.h"

namespace planish {

/// A mesh whose triangles can be laid into the plane one after the other. The frame of a half-edge
/// is the plane with its first vertex at 0, itself along the x axis and its triangle above that.
class UnfoldedMesh {
 public:
  static constexpr Index none = HalfEdges::none;

  /// Scaled to about 1. Linear time.
  /// @throws Error as require() for Purpose::measure
  explicit UnfoldedMesh(const Patch& patch);

  const HalfEdges& half_edges() const { return half_edges_; }
  double scale() const { return scale_; }
  std::size_t vertex_count() const { return positions_.size(); }
  Vec3 position(Index v) const { return positions_[v]; }
  Vec3 position(const SurfacePoint& place) const { return position_of(place, positions_); }

  double length(Index h) const { return sides_[h].length; }
  /// The third vertex of its triangle, in the frame of h.
  Vec2 apex(Index h) const { return sides_[h].apex; }
  /// Of the triangle, at the first vertex of h.
  double corner_angle(Index h) const;

  /// A place in the frame of h in those of the other sides of the triangle, and of its twin.
  Vec2 in_next(Index h, Vec2 p) const;
  Vec2 in_previous(Index h, Vec2 p) const;
  Vec2 in_twin(Index h, Vec2 p) const { return {length(h) - p.x, -p.y}; }
  /// A place of the triangle of h.
  Vec2 in_frame(Index h, const SurfacePoint& place) const;

  /// The half-edge from v in a triangle; none where v is no corner of it.
  Index corner(Index triangle, Index v) const;
  /// Around v counter-clockwise from the first half-edge, which is along the border if there is
  /// one, to h from v.
  double angle_to(Index h) const;
  /// All of it.
  double angle_around(Index v) const;

  /// With the corners in the order of their triangle, shares that are rounding errors cleared.
  /// @throws Error option_out_of_range for corners that are no triangle, shares that are none
  SurfacePoint checked(const SurfacePoint& place) const;
  /// The one with these corners; none if there is none.
  Index triangle_of(const Triangle& corners) const;
  /// The vertex that a place is at, if it is at one.
  static Index vertex_of(const SurfacePoint& place);
  /// All triangles that a place lies on.
  std::vector<Index> triangles_at(const SurfacePoint& place) const;
  /// Whether a place lies on the triangle.
  bool is_on(Index triangle, const SurfacePoint& place) const;
  /// Whether a place lies on the edge.
  bool is_on_edge(Index h, const SurfacePoint& place) const;

  SurfacePoint at_vertex(Index h) const;
  /// @param t share of the second vertex of h; at the end of the edge, the place is the vertex
  SurfacePoint on_edge(Index h, double t) const;
  /// @param t share of b
  /// @pre both are on the triangle
  SurfacePoint between(Index triangle, const SurfacePoint& a, const SurfacePoint& b,
                       double t) const;

 private:
  struct Side {
    double length;
    Vec2 apex;
  };

  double scale_;
  std::vector<Vec3> positions_;
  HalfEdges half_edges_;
  std::vector<Side> sides_;
};

}  // namespace planish
