#pragma once

#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// An edge of a layout in the plane, with its length on the patch.
struct FlatEdge {
  Index from, to;
  double length;
  double area;  ///< a third of that of its triangles; those of all edges add up to 1
};

/// Derivatives of a function of the vector from one end of an edge to the other.
struct EdgeTerm {
  Vec2 gradient;
  double xx, xy, yy;  ///< the second ones
};

/// An edge where its ends are: its length, the direction u of that, which is the length's gradient
/// by the second end, and its strain q = length / length on the patch - 1.
struct LaidEdge {
  double length, strain;
  Vec2 along;

  LaidEdge(const FlatEdge& edge, const std::vector<Vec2>& flat) {
    const Vec2 d = flat[edge.to] - flat[edge.from];
    length = norm(d);
    strain = length / edge.length - 1.0;
    along = (1.0 / length) * d;
  }

  /// Of a function f of the length: f' u, f'' u u^T + a (I - u u^T).
  /// @param across a: f' over the length. What an edge that is to get longer gains by turning is
  ///   left out, that is a below 0, so that the matrix stays positive
  EdgeTerm term(double first, double second, double across) const {
    const Vec2 u = along;
    return {first * u, second * u.x * u.x + across * u.y * u.y, (second - across) * u.x * u.y,
            second * u.y * u.y + across * u.x * u.x};
  }
};

}  // namespace planish
