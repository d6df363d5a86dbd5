#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <planish/core/vec.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// Shares of a triangle below this are rounding errors.
inline constexpr double k_least_share = 1e-11;

/// A place by the number of its triangle.
struct PlaceOnTriangle {
  Index triangle = 0;
  std::array<double, 3> shares = {1.0, 0.0, 0.0};  ///< of its corners, >= 0, with sum 1

  bool operator==(const PlaceOnTriangle&) const = default;
};

/// Sets shares that are rounding errors to 0, so that what is on an edge or at a corner is so
/// exactly, and makes their sum 1.
inline std::array<double, 3> cleared(std::array<double, 3> shares) {
  for (double& share : shares) {
    if (share < k_least_share) share = 0.0;
  }
  const double sum = shares[0] + shares[1] + shares[2];
  for (double& share : shares)
    share /= sum;
  return shares;
}

/// How many of the shares are 0: 2 at a corner, 1 on an edge, 0 inside.
inline std::ptrdiff_t zeros(const std::array<double, 3>& shares) {
  return std::count(shares.begin(), shares.end(), 0.0);
}

inline Vec3 point_of(const PlaceOnTriangle& place, const TriMesh& mesh) {
  const Triangle& t = mesh.triangles[place.triangle];
  return place.shares[0] * mesh.positions[t[0]] + place.shares[1] * mesh.positions[t[1]] +
         place.shares[2] * mesh.positions[t[2]];
}

}  // namespace planish
