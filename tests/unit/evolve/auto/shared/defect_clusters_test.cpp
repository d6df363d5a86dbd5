#include "evolve/auto/shared/defect_clusters.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "evolve/auto/shared/smallest_angle.h"
#include "evolve/systems/positions.h"
#include "unit/evolve/auto/shared/flattened_panel.h"

namespace planish {
namespace {

/// A flattenable panel on which a few vertices far from one another stand out.
TriMesh panel_with_bumps() {
  TriMesh mesh = flattened_panel(3000);
  const Patch patch(mesh);
  const double edge =
      norm(mesh.positions[mesh.triangles[0][0]] - mesh.positions[mesh.triangles[0][1]]);
  for (const std::size_t i : {300U, 1500U, 2600U})
    mesh.positions[patch.inner_vertices()[i]].z += 0.05 * edge;
  return mesh;
}

struct Bumps {
  explicit Bumps(const Constraints& constraints = {})
      : mesh(panel_with_bumps()),
        state(Patch(mesh), pool, constraints),
        jacobian(angle_jacobian_of(state)) {
    state.measure(pool);
    for (std::size_t v = 0; v < state.inner_count(); ++v)
      before.push_back(state.position(v));
  }
  double reduce(const DescentLimits& limits = {}) {
    const std::vector<double> weights(state.inner_count(), 1.0);
    reduce_largest_defects(state, jacobian, weights, limits, pool);
    return state.measure(pool).energy;
  }
  bool moved(Index v) const { return state.position(v) != before[v]; }

  TriMesh mesh;
  ThreadPool pool{1};
  PatchState state;
  AngleJacobian jacobian;
  std::vector<Vec3> before;
};

std::set<Index> closed_ring_of(const Bumps& bumps, Index v) {
  std::set<Index> ring{v};
  for (const Index w : bumps.jacobian.ring(v)) {
    if (bumps.state.is_inner(w)) ring.insert(w);
  }
  return ring;
}

TEST(DefectClusters, AreAroundTheVerticesThatStandOut) {
  const Bumps bumps;
  const DefectClusters clusters = clusters_of_largest_defects(bumps.state, bumps.jacobian);
  EXPECT_EQ(clusters.count, 3U);
  std::vector<double> largest(clusters.count, 0.0);
  for (std::size_t row = 0; row < clusters.rows.size(); ++row) {
    double& most = largest[clusters.cluster_of_row[row]];
    most = std::max(most, std::abs(bumps.state.defect(clusters.rows[row])));
  }
  EXPECT_GT(*std::min_element(largest.begin(), largest.end()), 1e-3);
  EXPECT_LT(clusters.rows.size(), bumps.state.inner_count() / 4);
}

TEST(DefectClusters, HaveTheRowsThatTheirVerticesChange) {
  const Bumps bumps;
  const DefectClusters clusters = clusters_of_largest_defects(bumps.state, bumps.jacobian);
  std::vector<std::set<Index>> rows(clusters.count);
  for (std::size_t i = 0; i < clusters.vertices.size(); ++i)
    rows[clusters.cluster_of_vertex[i]].merge(closed_ring_of(bumps, clusters.vertices[i]));
  std::size_t all = 0;
  for (Index c = 0; c < clusters.count; ++c) {
    std::set<Index> listed;
    for (std::size_t row = 0; row < clusters.rows.size(); ++row) {
      if (clusters.cluster_of_row[row] == c) listed.insert(clusters.rows[row]);
    }
    EXPECT_EQ(listed, rows[c]) << c;
    all += rows[c].size();
  }
  EXPECT_EQ(all, clusters.rows.size());
}

/// Of each cluster, as of the last measure().
std::vector<double> sums_of(const DefectClusters& clusters, const Bumps& bumps,
                            double (*term)(double)) {
  std::vector<double> sums(clusters.count, 0.0);
  for (std::size_t row = 0; row < clusters.rows.size(); ++row)
    sums[clusters.cluster_of_row[row]] += term(bumps.state.defect(clusters.rows[row]));
  return sums;
}

TEST(DefectClusters, LoseNearlyAllOfTheirEnergy) {
  Bumps bumps;
  const DefectClusters clusters = clusters_of_largest_defects(bumps.state, bumps.jacobian);
  const auto square = [](double d) { return d * d; };
  const std::vector<double> before = sums_of(clusters, bumps, square);
  const double energy = bumps.state.measure(bumps.pool).energy;
  EXPECT_LT(bumps.reduce(), 0.05 * energy);
  const std::vector<double> after = sums_of(clusters, bumps, square);
  for (std::size_t c = 0; c < clusters.count; ++c)
    EXPECT_LT(after[c], 0.1 * before[c]) << c;
  for (Index v = 0; v < bumps.state.inner_count(); ++v) {
    const bool may = std::binary_search(clusters.vertices.begin(), clusters.vertices.end(), v);
    if (!may) {
      EXPECT_FALSE(bumps.moved(v)) << v;
    }
  }
}

// A curve that stays where it is turns as much as before, so what it encloses has the same defects
// in all (Gauss and Bonnet).
TEST(DefectClusters, KeepTheSumsOfTheirDefectsAwayFromTheBorder) {
  Bumps bumps;
  const DefectClusters clusters = clusters_of_largest_defects(bumps.state, bumps.jacobian);
  std::vector<unsigned char> at_border(clusters.count, 0);
  for (std::size_t i = 0; i < clusters.vertices.size(); ++i) {
    for (const Index w : bumps.jacobian.ring(clusters.vertices[i])) {
      if (!bumps.state.is_inner(w)) at_border[clusters.cluster_of_vertex[i]] = 1;
    }
  }
  const auto itself = [](double d) { return d; };
  const std::vector<double> before = sums_of(clusters, bumps, itself);
  bumps.reduce();
  const std::vector<double> after = sums_of(clusters, bumps, itself);
  for (std::size_t c = 0; c < clusters.count; ++c) {
    if (at_border[c] == 0) {
      EXPECT_NEAR(after[c], before[c], 1e-12) << c;
    }
  }
  EXPECT_LT(std::count(at_border.begin(), at_border.end(), 1), std::ssize(at_border));
}

TEST(DefectClusters, KeepTheLimitOfDeviationAndWhatIsFixed) {
  Bumps loose;
  const DefectClusters clusters = clusters_of_largest_defects(loose.state, loose.jacobian);
  const Index held = clusters.vertices[clusters.vertices.size() / 2];
  loose.reduce();
  ASSERT_TRUE(loose.moved(held));
  double furthest = 0.0;
  for (std::size_t v = 0; v < loose.state.inner_count(); ++v)
    furthest = std::max(furthest, norm(loose.state.position(v) - loose.state.origin(v)));

  const std::vector<Index> fixed = {loose.state.vertex_of(held)};
  Bumps bumps({.fixed = fixed});
  DescentLimits limits;
  limits.deviation = 0.3 * furthest;
  const double before = bumps.state.measure(bumps.pool).energy;
  EXPECT_LT(bumps.reduce(limits), before);
  for (std::size_t v = 0; v < bumps.state.inner_count(); ++v)
    EXPECT_LE(norm(bumps.state.position(v) - bumps.state.origin(v)), limits.deviation);
  EXPECT_FALSE(bumps.moved(held));
}

TEST(DefectClusters, KeepTheLimitOfAngles) {
  Bumps loose, bumps;
  const auto angles_at = [](const Bumps& of, Index v) {
    double least = 10.0;
    const auto ring = of.jacobian.ring(v);
    for (std::size_t j = 0; j < ring.size(); ++j)
      least = std::min(least, smallest_angle(of.state, {v, ring[j], ring[(j + 1) % ring.size()]}));
    return least;
  };
  const DefectClusters clusters = clusters_of_largest_defects(bumps.state, bumps.jacobian);
  const auto least_of = [&](const Bumps& of) {
    double least = 10.0;
    for (const Index v : clusters.vertices)
      least = std::min(least, angles_at(of, v));
    return least;
  };
  DescentLimits limits;
  limits.angle = least_of(bumps);
  loose.reduce();
  ASSERT_LT(least_of(loose), limits.angle);
  bumps.reduce(limits);
  EXPECT_GE(least_of(bumps), limits.angle);
}

TEST(DefectClusters, MoveNothingOfWhatIsFlat) {
  const TriMesh mesh = make_shape("panel", 400);
  TriMesh flat = mesh;
  for (Vec3& p : flat.positions)
    p.z = 0.0;
  ThreadPool pool(1);
  PatchState state{Patch(flat), pool};
  const AngleJacobian jacobian = angle_jacobian_of(state);
  state.measure(pool);
  const std::vector<double> weights(state.inner_count(), 1.0);
  reduce_largest_defects(state, jacobian, weights, {}, pool);
  EXPECT_EQ(state.positions_in_mesh_order(), flat.positions);
}

}  // namespace
}  // namespace planish
