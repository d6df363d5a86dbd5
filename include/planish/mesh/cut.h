#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/core/error.h>
#include <planish/mesh/patch.h>

namespace planish {

/// A line that a mesh is to be cut open along.
struct CutPath {
  /// From end to end. Two that follow each other and are not joined by an edge stand for the
  /// shortest path of edges between them that keeps off the border.
  std::vector<Index> vertices;
  SourceLocation place = {};  ///< where it was asked for, for errors
};

/// A mesh that was cut open.
struct CutMesh {
  /// The triangles in their order, with the same corners in place. A vertex of the mesh keeps its
  /// number; its copies come behind all vertices, by the numbers of what they are copies of.
  TriMesh mesh;
  std::vector<Index> source;              ///< vertex of the cut mesh -> vertex of the mesh
  std::vector<std::vector<Index>> paths;  ///< of the mesh, every vertex, as they were cut
  std::size_t edges = 0;                  ///< that were opened, each once
  double length = 0.0;                    ///< of these on the mesh, model units
};

/// Cuts a mesh open: the triangles on the two sides of a path no longer share vertices, but for an
/// end of a path that is inside. Paths may cross, branch and share edges, and may divide the mesh.
/// The result depends only on which edges are cut. Positions keep their bits. O((n + m) log m).
/// @throws Error index_out_of_range, or misplaced_cut: a path of fewer than two vertices, along the
///   border, between vertices that nothing joins inside, or that together with the paths that it
///   meets does not touch the border of a part that has one, or is a single edge of a closed one.
///   The message counts the paths from 1, `first` is the vertex
CutMesh cut_open(const Patch& patch, std::span<const CutPath> paths);

/// Length of a path on the mesh, model units.
double path_length(std::span<const Index> path, std::span<const Vec3> positions);

}  // namespace planish
