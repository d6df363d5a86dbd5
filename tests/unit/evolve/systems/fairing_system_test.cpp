#include "evolve/systems/fairing_system.h"

#include <cmath>
#include <numbers>

#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "evolve/systems/positions.h"
#include "geometry/cotangents.h"

namespace planish {
namespace {

struct PatchToFair {
  explicit PatchToFair(const char* name) : mesh(make_shape(name, 300)), state(surface, pool) {}

  TriMesh mesh;
  Patch surface{mesh};
  ThreadPool pool{1};
  PatchState state;
  std::vector<unsigned char> movable = std::vector<unsigned char>(state.inner_count(), 1);
  std::vector<double> weights = std::vector<double>(state.inner_count(), 1.0);
};

std::vector<Vec3> ring_places(const PatchState& state, std::span<const Index> ring) {
  std::vector<Vec3> positions;
  for (const Index v : ring)
    positions.push_back(state.position(v));
  return positions;
}

/// A regular ring of n corners around the origin, at this distance.
std::vector<Vec3> regular_ring(int n, double radius) {
  std::vector<Vec3> ring;
  for (int j = 0; j < n; ++j) {
    const double angle = 2.0 * std::numbers::pi * j / n;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.0});
  }
  return ring;
}

TEST(CotangentWeights, AreThoseOfARegularRing) {
  // The angles opposite an edge to the middle are (pi - 2 pi / n) / 2 each.
  for (const int n : {3, 4, 5, 6, 9}) {
    const double angle = 0.5 * (std::numbers::pi - 2.0 * std::numbers::pi / n);
    for (const double weight : cotangent_weights({}, regular_ring(n, 2.0)))
      EXPECT_NEAR(weight, 1.0 / std::tan(angle), 1e-14);
  }
}

TEST(CotangentWeights, SumUpToTheGradientOfTheArea) {
  const std::vector<Vec3> ring = {{1, 0, 0.1}, {0.2, 1, 0}, {-1, 0.3, 0.2}, {-0.4, -1, -0.1}};
  const Vec3 p = {0.1, 0.05, 0.3};
  const auto area = [&](Vec3 at) {
    double sum = 0.0;
    for (std::size_t j = 0; j < ring.size(); ++j)
      sum += 0.5 * norm(cross(ring[j] - at, ring[(j + 1) % ring.size()] - at));
    return sum;
  };
  const auto weights = cotangent_weights(p, ring);
  Vec3 gradient;
  for (std::size_t j = 0; j < ring.size(); ++j)
    gradient += weights[j] * (p - ring[j]);
  constexpr double h = 1e-6;
  EXPECT_NEAR(gradient.x, (area(p + Vec3{h, 0, 0}) - area(p - Vec3{h, 0, 0})) / (2 * h), 1e-9);
  EXPECT_NEAR(gradient.y, (area(p + Vec3{0, h, 0}) - area(p - Vec3{0, h, 0})) / (2 * h), 1e-9);
  EXPECT_NEAR(gradient.z, (area(p + Vec3{0, 0, h}) - area(p - Vec3{0, 0, h})) / (2 * h), 1e-9);
}

TEST(MixedArea, IsAThirdOfARegularHexagonAndHalfOfObtuseTriangles) {
  const double triangle = 0.25 * std::sqrt(3.0);
  EXPECT_NEAR(mixed_area({}, regular_ring(6, 1.0)), 6.0 * triangle / 3.0, 1e-14);
  // Three triangles of 120 degrees at the middle.
  const double obtuse = 0.5 * std::sin(2.0 * std::numbers::pi / 3.0);
  EXPECT_NEAR(mixed_area({}, regular_ring(3, 1.0)), 3.0 * 0.5 * obtuse, 1e-14);
}

/// What the fairing makes smallest, written out.
double merit(const PatchToFair& patch, const Positions& targets, const Positions& positions,
             LaplacianWeights kind) {
  // L is that of the patch as it was.
  double area = 0.0;
  const auto rings = rings_by_vertex(patch.state.plan());
  for (Index v = 0; v < rings.size(); ++v)
    area += mixed_area(patch.state.position(v), ring_places(patch.state, rings[v]));
  const double mean = area / static_cast<double>(rings.size());
  double sum = 0.0;
  for (Index v = 0; v < rings.size(); ++v) {
    const auto ring = ring_places(patch.state, rings[v]);
    std::vector<double> weights(ring.size(), 1.0 / static_cast<double>(ring.size()));
    double scale = 1.0;
    if (kind == LaplacianWeights::cotangent) {
      weights = cotangent_weights(patch.state.position(v), ring);
      scale = mean / mixed_area(patch.state.position(v), ring);
    }
    Vec3 laplacian;
    for (std::size_t j = 0; j < ring.size(); ++j) {
      const Vec3 w = patch.state.is_inner(rings[v][j]) ? positions[rings[v][j]]
                                                       : patch.state.position(rings[v][j]);
      laplacian += (scale * weights[j]) * (positions[v] - w);
    }
    const Vec3 off = patch.weights[v] * (positions[v] - targets[v]);
    sum += dot(laplacian, laplacian) + dot(off, off);
  }
  return sum;
}

class FairingKinds : public testing::TestWithParam<LaplacianWeights> {};

TEST_P(FairingKinds, EndAtTheMinimumOfWhatTheyMakeSmall) {
  PatchToFair patch("dome");
  for (std::size_t v = 0; v < patch.weights.size(); v += 3)
    patch.weights[v] = 4.0;
  const FairingSystem fairing(patch.state, patch.movable, GetParam(), patch.weights, patch.pool);
  ASSERT_TRUE(fairing.solvable());
  Positions targets = inner_positions(patch.state);
  for (std::size_t v = 0; v < targets.size(); ++v)
    targets[v] += Vec3{0.0, 0.0, 0.02 * std::sin(7.0 * static_cast<double>(v))};
  const Positions faired = fairing.apply(targets, patch.pool);
  const double least = merit(patch, targets, faired, GetParam());
  EXPECT_LT(least, 0.9 * merit(patch, targets, targets, GetParam()));
  Positions direction(faired.size());
  for (std::size_t v = 0; v < direction.size(); ++v)
    direction[v] = {std::cos(3.0 * static_cast<double>(v)), 1.0, std::sin(static_cast<double>(v))};
  for (const double t : {-1e-4, 1e-4}) {
    // A quadratic at its minimum: the same rise to both sides, no slope.
    EXPECT_GT(merit(patch, targets, sum_of(faired, t, direction), GetParam()), least);
  }
  const double up = merit(patch, targets, sum_of(faired, 1e-3, direction), GetParam());
  const double down = merit(patch, targets, sum_of(faired, -1e-3, direction), GetParam());
  EXPECT_NEAR(up - least, down - least, 1e-8 * (up - least));
}

TEST_P(FairingKinds, LeaveWhatIsHeldAtItsTarget) {
  PatchToFair patch("saddle");
  patch.movable[5] = patch.movable[50] = 0;
  const FairingSystem fairing(patch.state, patch.movable, GetParam(), patch.weights, patch.pool);
  const Positions targets = inner_positions(patch.state);
  const Positions faired = fairing.apply(targets, patch.pool);
  EXPECT_EQ(faired[5], targets[5]);
  EXPECT_EQ(faired[50], targets[50]);
  EXPECT_NE(faired, targets);
}

INSTANTIATE_TEST_SUITE_P(Both, FairingKinds,
                         testing::Values(LaplacianWeights::uniform, LaplacianWeights::cotangent),
                         [](const auto& test) {
                           return test.param == LaplacianWeights::uniform ? "uniform" : "cotangent";
                         });

}  // namespace
}  // namespace planish
