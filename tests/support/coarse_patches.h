#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include <planish/mesh/inspect.h>

#include <gtest/gtest.h>

#include "mesh/coarsen/coarsen.h"
#include "mesh/search/closest_point.h"

namespace planish {

inline CoarsePatch coarse(const TriMesh& mesh, std::size_t vertices, CoarseBorder border,
                          std::span<const unsigned char> keep = {}) {
  return coarsen(Patch(mesh), vertices, border, keep);
}

/// Degrees, the smallest of each triangle, in increasing order.
inline std::vector<double> smallest_angles(const TriMesh& mesh) {
  std::vector<double> smallest;
  for (const Triangle& t : mesh.triangles) {
    double least = 180.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = mesh.positions[t[(k + 1) % 3]] - mesh.positions[t[k]];
      const Vec3 b = mesh.positions[t[(k + 2) % 3]] - mesh.positions[t[k]];
      least = std::min(least, std::atan2(norm(cross(a, b)), dot(a, b)));
    }
    smallest.push_back(least * 180.0 / std::numbers::pi);
  }
  std::sort(smallest.begin(), smallest.end());
  return smallest;
}

/// The farthest vertex of the fine mesh from the coarse one, to the diagonal.
inline double farthest(const TriMesh& fine, const TriMesh& coarse) {
  const ClosestPointTree tree(coarse);
  double square = 0.0;
  for (const Vec3 p : fine.positions)
    square = std::max(square, tree.query(p).squared_distance);
  return std::sqrt(square) / bounding_box_diagonal(fine);
}

/// What holds of every coarse patch.
inline void expect_sound(const TriMesh& mesh, const CoarsePatch& patch) {
  const Inspection was = inspect(mesh), is = inspect(patch.mesh);
  EXPECT_FALSE(blocking_problem(is, Purpose::measure));
  for (const Problem& problem : is.problems) {  // of a few vertices none may be left inside
    EXPECT_TRUE(problem.code == ErrorCode::no_inner_vertex || !was.problems.empty())
        << problem.message;
  }
  EXPECT_EQ(is.topology.euler_characteristic, was.topology.euler_characteristic);
  EXPECT_EQ(is.topology.border_loops, was.topology.border_loops);
  EXPECT_EQ(is.topology.components, was.topology.components);
  EXPECT_EQ(is.topology.vertices, patch.mesh.positions.size());
  ASSERT_EQ(patch.source.size(), patch.mesh.positions.size());
  const Patch fine(mesh), coarse(patch.mesh);
  for (Index v = 0; v < patch.source.size(); ++v) {
    ASSERT_LT(patch.source[v], mesh.positions.size());
    EXPECT_TRUE(v == 0 || patch.source[v - 1] < patch.source[v]);
    EXPECT_EQ(patch.mesh.positions[v], mesh.positions[patch.source[v]]);
    EXPECT_EQ(coarse.is_border(v), fine.is_border(patch.source[v]));
  }
}

/// The border loops in the numbers of the fine mesh.
inline std::vector<std::vector<Index>> loops_in_fine(const CoarsePatch& patch) {
  auto loops = Patch(patch.mesh).border_loops();
  for (auto& loop : loops) {
    for (Index& v : loop)
      v = patch.source[v];
  }
  return loops;
}

}  // namespace planish
