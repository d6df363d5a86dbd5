#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/core/error.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>

namespace planish {

/// A line that was drawn over a mesh, straight from point to point. A closed one ends in its first
/// point.
struct DrawnLine {
  std::vector<Vec3> points;   ///< model units of the mesh
  SourceLocation place = {};  ///< where it was drawn, for errors
};

/// What was drawn over a mesh.
struct DrawnLines {
  std::vector<DrawnLine> lines;  ///< of two points or more
  std::vector<Vec3> points;      ///< that belong to no line
};

/// The lines with those joined that end in one point where no third one does, as programs write a
/// line edge by edge.
std::vector<DrawnLine> chained_lines(std::vector<DrawnLine> lines);

/// A fairer line near a drawn one: without the teeth that it has where its points were put onto
/// vertices of a mesh (Taubin 1995: smoothing that does not shrink). Ends stay, and points where it
/// turns by more than 60 degrees over four points.
/// @param tolerance how far a point may move, model units; 0: the line as it is
DrawnLine smoothed_line(DrawnLine line, double tolerance);

/// Lines and points that lie on a mesh, and how much of what was drawn does not.
struct TracedLines {
  /// Each of two places or more, two that follow each other on one triangle. A line that leaves the
  /// mesh and comes back gives one for each part.
  std::vector<SurfaceLine> lines;
  std::vector<SurfacePoint> points;  ///< in the order that they were drawn
  double outside_length = 0.0;       ///< of lines that lie off the mesh, model units
  std::size_t outside_points = 0;    ///< points that lie off the mesh
  double farthest = 0.0;  ///< of the points that were taken from their places; model units
};

/// Finds the places of what was drawn over a mesh. A line is split where it crosses edges.
///
/// Over a flat mesh (z is the same everywhere) with drawn points in its plane, lines are cut by the
/// triangles that they run over, exactly but for rounding. Over any other mesh a point stands for
/// the nearest place, and a straight line between two points for the section of the mesh with the
/// plane that holds both places and the mean of the normals there.
///
/// A point beyond the border by at most a thousandth of a mean edge is on the border; one that is
/// farther beyond, or more than three mean edges from the mesh, lies off it.
/// @throws Error no_triangles; too_large, with the place of the line, for lines with more than
///   20 million places, and for what is a million sizes of the mesh away
TracedLines trace_lines(const Patch& patch, const DrawnLines& drawn);

/// Whether all triangles lie in a plane of equal z.
bool is_flat(const TriMesh& mesh);

/// Checks that two meshes have the same triangles, so that each place of one is a place of the
/// other.
/// @throws Error malformed_file, without a place, saying where they first differ
void check_same_triangles(const TriMesh& one, const TriMesh& other);

}  // namespace planish
