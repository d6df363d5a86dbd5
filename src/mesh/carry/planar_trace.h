#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include "mesh/carry/line_pieces.h"
#include "mesh/search/box_tree.h"
#include "mesh/search/closest_point.h"

namespace planish {

/// Finds what of the plane lies on the triangles of a flat mesh.
class PlanarTrace {
 public:
  /// @param mesh flat, at a scale at which it is about 1 large; must outlive it
  /// @param reach how far beyond the border a point may be
  PlanarTrace(const TriMesh& mesh, double reach)
      : mesh_(mesh), tree_(mesh), nearest_(mesh), reach_(reach) {}

  /// The place of a point; nothing off the mesh.
  std::optional<PlaceOnTriangle> place_of(Vec3 p) const;

  /// Follows the straight line from p to q, after what was added last.
  void follow(Vec3 p, Vec3 q, LinePieces& pieces) const;

 private:
  /// The part of a line that a triangle has, of its length from 0 to 1.
  struct Span {
    Index triangle = 0;
    double begin = 0.0, end = 1.0;
  };

  Vec3 onto_border(Vec3 p) const;
  std::vector<Span> spans_of(Vec3 p, Vec3 q) const;
  std::optional<Span> span_of(std::size_t place, Vec3 p, Vec3 q) const;
  bool share_corner(Index s, Index t) const;
  Span next_span(std::span<const Span> spans, const std::optional<Index>& last) const;

  const TriMesh& mesh_;
  BoxTree tree_;
  ClosestPointTree nearest_;
  double reach_;
};

}  // namespace planish
