#include "evolve/methods/local_region.h"

#include <map>
#include <queue>

#include <planish/mesh/patch.h>

#include <gtest/gtest.h>

#include "evolve/state/patch_state.h"
#include "oracle/plain.h"
#include "support/meshes.h"

namespace planish {
namespace {

/// A patch with what regions of it need.
struct Prepared {
  TriMesh mesh = meshes::rough_grid(11, 9, 3, 0.2, 0.2);
  ThreadPool pool{1};
  PatchState state{Patch(mesh), pool};
  std::vector<std::span<const Index>> rings = rings_by_vertex(state.plan());

  LocalRegion region(Index center, int radius, const std::function<bool(Index)>& may_move) {
    return region_around(center, radius, rings, may_move);
  }
};

bool any(Index) {
  return true;
}

TEST(LocalRegion, IsAllThatIsSoManyEdgesAway) {
  Prepared patch;
  for (const int radius : {1, 2, 3}) {
    for (Index center = 0; center < patch.rings.size(); center += 5) {
      std::map<Index, int> distance{{center, 0}};
      std::queue<Index> queue({center});
      for (; !queue.empty(); queue.pop()) {
        for (const Index w : patch.rings[queue.front()]) {
          if (w < patch.rings.size() && distance.emplace(w, distance[queue.front()] + 1).second)
            queue.push(w);
        }
      }
      std::vector<Index> active, constrained;
      for (const auto& [v, steps] : distance) {
        if (steps <= radius) active.push_back(v);
        if (steps <= radius + 1) constrained.push_back(v);
      }
      const LocalRegion region = patch.region(center, radius, any);
      EXPECT_EQ(region.active, active);
      EXPECT_EQ(region.constrained, constrained);
    }
  }
}

TEST(LocalRegion, MovesOnlyWhatMayMoveButConstrainsAll) {
  Prepared patch;
  const LocalRegion whole = patch.region(7, 2, any);
  const LocalRegion even = patch.region(7, 2, [](Index v) { return v % 2 == 0; });
  EXPECT_EQ(even.constrained, whole.constrained);
  EXPECT_LT(even.active.size(), whole.active.size());
  for (const Index v : even.active) {
    EXPECT_EQ(v % 2, 0U);
    EXPECT_EQ(even.active[even.slot_of(v)], v);
  }
  EXPECT_EQ(even.slot_of(7), even.active.size());
}

TEST(AngleRows, AreTheDifferenceQuotientsOfTheAngleSums) {
  Prepared patch;
  const PatchState& state = patch.state;
  const LocalRegion region = patch.region(40, 1, [](Index v) { return v % 3 != 0; });
  const Eigen::MatrixXd rows = angle_rows(region, patch.rings, patch.state.sites());
  constexpr double h = 1e-6;
  const auto angle_sums = [&](Index moved, Vec3 by) {
    plain::Patch plain(patch.mesh);
    plain.mesh.positions[state.vertex_of(moved)] += (1.0 / state.scale()) * by;
    Eigen::VectorXd sums(rows.rows());
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
      sums[i] = plain.angle_sum(state.vertex_of(region.constrained[static_cast<std::size_t>(i)]));
    return sums;
  };
  for (std::size_t place = 0; place < region.active.size(); ++place) {
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 by{axis == 0 ? h : 0.0, axis == 1 ? h : 0.0, axis == 2 ? h : 0.0};
      const Index v = region.active[place];
      const Eigen::VectorXd quotient = (angle_sums(v, by) - angle_sums(v, -by)) / (2.0 * h);
      const auto column = static_cast<Eigen::Index>(3 * place) + axis;
      EXPECT_LT((rows.col(column) - quotient).norm(), 1e-6 * rows.norm());
    }
  }
}

TEST(AngleRows, SumToNothingWhereNoBorderIsNear) {
  // Moving a vertex conserves the total of the angle sums.
  Prepared patch;
  for (Index center = 0; center < patch.rings.size(); ++center) {
    const LocalRegion region = patch.region(center, 1, any);
    const bool is_inside =
        std::all_of(region.constrained.begin(), region.constrained.end(), [&](Index v) {
          return std::all_of(patch.rings[v].begin(), patch.rings[v].end(),
                             [&](Index w) { return patch.state.is_inner(w); });
        });
    if (!is_inside) continue;
    const Eigen::MatrixXd rows = angle_rows(region, patch.rings, patch.state.sites());
    EXPECT_LT(rows.colwise().sum().norm(), 1e-12 * rows.norm());
  }
}

}  // namespace
}  // namespace planish
