#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>

namespace planish {

/// How lines become edges.
struct ImprintOptions {
  /// A point of a line that is this near to a vertex, or to another point on the same edge, is put
  /// there: of the shortest edge at the vertex, 0 to 0.25.
  double snap = 0.05;
  /// And at most this far, of the diagonal of the mesh.
  double farthest_snap = 5e-5;
  /// Angles below this, degrees, are made larger by more vertices on edges, where new short edges
  /// cause them; 0: not.
  double least_angle = 7.0;
};

/// A mesh with lines as edges.
struct ImprintedMesh {
  /// Vertices of the mesh keep numbers and bits, new ones are behind. Triangles that lines cross
  /// are divided in their place; each lies within one of the mesh, so the surface is the same.
  TriMesh mesh;
  std::vector<SurfacePoint> new_vertices;  ///< where they are on the mesh
  std::vector<Index> triangle_of;          ///< triangle -> that of the mesh which it is part of
  std::vector<std::vector<Index>> paths;   ///< the vertices along each line, joined by edges
  std::size_t snapped = 0;                 ///< points of lines that were put onto something
  double farthest_snap = 0.0;              ///< the farthest of them, model units
};

/// Makes lines on a mesh edges of it: divides edges and triangles where lines run, by a constrained
/// Delaunay triangulation of each triangle. Lines may cross, touch, branch, run along edges and
/// along each other. Which side of a line a vertex is on is decided exactly. Points between which a
/// line is straight but for 1e-6 of the diagonal are left out. O(n + k log k) for k crossings.
/// @throws Error misplaced_cut, counting the lines from 1, `first` from 0, where a point names no
/// triangle of the
///   mesh or has coordinates that are no numbers >= 0, and where two points that follow each other
///   lie on no triangle together
ImprintedMesh imprint(const Patch& patch, std::span<const SurfaceLine> lines,
                      const ImprintOptions& options = {});

}  // namespace planish
