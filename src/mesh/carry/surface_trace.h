#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include "geometry/box.h"
#include "mesh/carry/line_pieces.h"
#include "mesh/half_edges.h"
#include "mesh/search/closest_point.h"

namespace planish {

/// Finds what of space lies on the triangles of a mesh, or is near to them.
class SurfaceTrace {
 public:
  /// @param mesh an oriented manifold, at a scale at which it is about 1 large; must outlive it
  /// @param reach how far beyond the border a point may be
  /// @param most how far from the mesh a point may be
  /// @param step how long a line off the mesh may be and not be looked at in its middle
  SurfaceTrace(const TriMesh& mesh, double reach, double most, double step);

  /// The nearest place; nothing for a point off the mesh.
  std::optional<PlaceOnTriangle> place_of(Vec3 p) const;

  /// Follows the line from p to q along the mesh, after what was added last.
  void follow(Vec3 p, Vec3 q, LinePieces& pieces) const;

 private:
  /// A point of a line, and where it is on the mesh, if it is.
  struct Stop {
    Vec3 point;
    std::optional<PlaceOnTriangle> place;
  };

  /// Where a walk along a section of the mesh led.
  struct Walk {
    std::vector<PlaceOnTriangle> places;  ///< behind the first one, up to the border or the target
    bool arrived = false;
  };

  Stop stop_at(Vec3 p) const;
  std::vector<Index> triangles_at(const PlaceOnTriangle& place) const;
  Vec3 normal_at(const PlaceOnTriangle& place) const;
  bool are_on_one_triangle(const PlaceOnTriangle& a, const PlaceOnTriangle& b) const;
  std::optional<PlaceOnTriangle> moved_beside(const PlaceOnTriangle& place,
                                              const PlaceOnTriangle& other) const;
  std::optional<Walk> walk(const PlaceOnTriangle& from, Vec3 normal, Vec3 along, double length,
                           const PlaceOnTriangle* target) const;
  void follow(const Stop& a, const Stop& b, int depth, LinePieces& pieces) const;
  void follow_inside(const Stop& a, const Stop& b, int depth, LinePieces& pieces) const;
  void leave(const Stop& a, const Stop& b, int depth, LinePieces& pieces) const;
  void halve(const Stop& a, const Stop& b, int depth, LinePieces& pieces) const;

  const TriMesh& mesh_;
  HalfEdges half_edges_;
  ClosestPointTree nearest_;
  Box box_;
  double reach_, most_, step_;
};

}  // namespace planish
