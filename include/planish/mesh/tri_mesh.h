#pragma once

#include <array>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// The three vertices of a triangle, counter-clockwise seen from outside.
using Triangle = std::array<Index, 3>;

/// A triangle mesh: n positions and m triangles over them, nothing else. It may be anything, also
/// broken: inspect() says what; a Patch refuses what is no oriented manifold.
struct TriMesh {
  std::vector<Vec3> positions;      ///< model units
  std::vector<Triangle> triangles;  ///< by numbers of positions
};

/// Length of the diagonal of the bounding box of the vertices that triangles use, computed without
/// overflow; 0 for a mesh without triangles. Model units.
double bounding_box_diagonal(const TriMesh& mesh);

/// The power of two that brings the largest coordinate difference of the used vertices into
/// [0.5, 1). Multiplying by it is exact, so that squares of lengths can neither overflow nor vanish
/// and every angle keeps its value. 1 for a mesh of one point.
double unit_scale(const TriMesh& mesh);

/// The mesh with all coordinates multiplied.
TriMesh scaled(TriMesh mesh, double factor);

}  // namespace planish
