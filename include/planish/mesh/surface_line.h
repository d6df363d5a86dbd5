#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <planish/core/error.h>
#include <planish/mesh/patch.h>

namespace planish {

/// A place on a triangle of a mesh. It means the same place on every mesh with the same triangles.
struct SurfacePoint {
  Triangle corners = {};                                       ///< vertices of the triangle
  std::array<double, 3> shares = {1.0 / 3, 1.0 / 3, 1.0 / 3};  ///< barycentric, >= 0, with sum 1
};

/// Where the place is on a mesh with these vertices.
Vec3 position_of(const SurfacePoint& place, std::span<const Vec3> positions);
/// The same in a pattern.
Vec2 position_of(const SurfacePoint& place, std::span<const Vec2> positions);

/// The place of a mesh that is nearest to a point, of several always the same one. Linear time.
/// @throws Error no_triangles; non_finite_coordinate for a point that is no number
SurfacePoint nearest_place(const Patch& patch, Vec3 point);

/// A line on a mesh from end to end, straight between two points that follow each other, which lie
/// on one triangle: a point on an edge may be given by either triangle, a vertex by any. A closed
/// line ends in its first point.
using SurfaceLine = std::vector<SurfacePoint>;

/// A line along edges.
/// @param path vertices, each joined to the next one by an edge
SurfaceLine line_along_edges(const Patch& patch, std::span<const Index> path);

/// Length of the line on a mesh with these vertices, model units.
double length_of(std::span<const SurfacePoint> line, std::span<const Vec3> positions);

/// How jagged a line is: its length over that of its chords, of which each spans an equal part of
/// it, near to a length of four edges of the mesh. 1 for a straight line and for one that is
/// shorter than two such parts; a bend of radius r makes it 1 + c^2 / (24 r^2) for chords c.
/// @param edge mean length of an edge, model units
double jag_of(std::span<const Vec3> line, double edge);

/// A plane: all p with dot(normal, p) = offset.
struct Plane {
  Vec3 normal = {0.0, 0.0, 1.0};  ///< of any length but 0
  double offset = 0.0;            ///< model units times the length of the normal
};

/// Where a plane meets a mesh: lines through its triangles, each as long as it can be, in the order
/// of the triangles that they begin in. A vertex nearer to the plane than `snap` counts as on it;
/// an edge on the plane belongs to a line where the mesh lies on both sides of the plane there.
/// Linear time.
/// @param snap model units
/// @throws Error option_out_of_range for a normal of length 0 and what is no number
std::vector<SurfaceLine> plane_section(const Patch& patch, const Plane& plane, double snap = 0.0);

/// Creases of a mesh, as chains of edges: those where its triangles meet at an angle of at least
/// `least`, and edges that lead on from their ends with at least a third of it. Chains end where
/// three creases meet, and at the border.
/// @param least between normals, degrees, above 0
/// @throws Error option_out_of_range
std::vector<SurfaceLine> crease_lines(const Patch& patch, double least = 30.0);

/// A stretch of a line that ran beside another line, or the border.
struct DoubleStretch {
  std::size_t line = 0;                    ///< its number, from 0
  std::optional<std::size_t> beside = {};  ///< the other line; none: the border
  double length = 0.0;                     ///< model units
};

/// Lines of which none runs beside another one, or along the border.
struct SingleLines {
  std::vector<SurfaceLine> lines;           ///< what is left, in the same order
  std::vector<std::size_t> of = {};         ///< of each, the line that it is a part of
  std::vector<DoubleStretch> doubled = {};  ///< what was left out
};

/// Removes the parts of lines that run beside an earlier line or the border: closer than the
/// tolerance, over a length of at least six tolerances. Both seams would leave a strip too narrow
/// to sew. A line that is all along the border stays. What is left is led on to the other line by
/// join_lines().
/// @param tolerance model units
SingleLines single_lines(const Patch& patch, std::vector<SurfaceLine> lines, double tolerance);

/// An end of a line, and what is nearest to it.
struct LineEnd {
  std::size_t line = 0;                ///< its number, from 0
  bool is_last = false;                ///< its last point, else its first one
  double distance = 0.0;               ///< that it was away, model units; infinite from nothing
  std::optional<std::size_t> to = {};  ///< the other line, or its own one; none: the border
};

/// Lines of which ends meet others, or the border.
struct JoinedLines {
  std::vector<SurfaceLine> lines;    ///< in the same order
  std::vector<LineEnd> joined = {};  ///< ends that were not where they are now
  std::vector<LineEnd> free = {};    ///< ends that meet nothing
};

/// Makes ends of lines that nearly meet another line, or the border, meet it: goes straight on to
/// the nearest place, and where it runs beside that line to a place ahead, six times as far. An end
/// on the border or on a line, and both of a closed line, stay.
/// @param tolerance how far an end may be away, model units
JoinedLines join_lines(const Patch& patch, std::vector<SurfaceLine> lines, double tolerance);

/// A tolerance that fits drawn lines: 0.5 % of the diagonal, or 1.5 mean edges where that is more.
/// @pre the mesh has a triangle
double join_tolerance(const TriMesh& mesh);

}  // namespace planish
