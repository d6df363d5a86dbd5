#include "mesh/coarsen/triangle_grade.h"

#include <array>
#include <cmath>
#include <utility>

namespace planish {

TriangleGrade grade_of(const FineSurface& surface, Index a, Index b, Index c) {
  const Vec3 p = surface.positions[a], q = surface.positions[b], r = surface.positions[c];
  const Vec3 n = cross(q - p, r - p);
  const double area = dot(n, n);
  std::array<double, 3> sides{dot(q - p, q - p), dot(r - q, r - q), dot(p - r, p - r)};
  if (!(area > 0.0)) return {1.0, -1.0, sides[0] > 0.0 && sides[1] > 0.0 && sides[2] > 0.0};
  if (sides[1] < sides[0]) std::swap(sides[0], sides[1]);
  if (sides[2] < sides[0]) std::swap(sides[0], sides[2]);
  const Vec3 fine = surface.normals[a] + surface.normals[b] + surface.normals[c];
  const double lengths = std::sqrt(area * dot(fine, fine));
  return {(sides[1] + sides[2] - sides[0]) / (2.0 * std::sqrt(sides[1] * sides[2])),
          lengths > 0.0 ? dot(n, fine) / lengths : -1.0};
}

}  // namespace planish
