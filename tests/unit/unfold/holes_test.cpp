#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <planish/mesh/patch.h>
#include <planish/mesh/shapes.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

using meshes::blocks, meshes::on_cone, meshes::on_cylinder, meshes::on_plane, meshes::perforated,
    meshes::Place;

/// The largest difference between the lengths of an edge in the pattern and on the patch.
double largest_change(const Patch& patch, const Pattern& pattern) {
  double largest = 0.0;
  for (const Edge& edge : patch.edges()) {
    const double before = norm(patch.positions()[edge.to] - patch.positions()[edge.from]);
    const double after = norm(pattern.positions[edge.to] - pattern.positions[edge.from]);
    largest = std::max(largest, std::abs(after - before));
  }
  return largest;
}

TEST(UnfoldWithHoles, KeepsAllLengthsOfPerforatedDevelopableSurfaces) {
  for (const Place& place : {Place(on_plane), Place(on_cylinder), Place(on_cone)}) {
    for (const auto& [across, along, size] :
         {std::array<std::size_t, 3>{1, 1, 1}, std::array<std::size_t, 3>{1, 1, 12},
          std::array<std::size_t, 3>{8, 5, 2}}) {
      const Patch patch(perforated(40, 24, blocks(40, 24, across, along, size), place));
      ASSERT_EQ(patch.border_loops().size(), across * along + 1);
      const Pattern pattern = unfold(patch);
      EXPECT_EQ(pattern.flipped_triangles, 0U);
      EXPECT_FALSE(pattern.overlaps);
      EXPECT_LE(largest_change(patch, pattern), 1e-9 * 40.0) << across << " x " << along;
    }
  }
}

TEST(UnfoldWithHoles, LaysAWasherFlat) {
  constexpr Index n = 90;
  TriMesh washer;
  for (Index k = 0; k < n; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / n;
    for (const double radius : {40.0, 50.0})
      washer.positions.push_back({radius * std::cos(angle), 0.0, radius * std::sin(angle)});
  }
  for (Index k = 0; k < n; ++k) {
    const Index a = 2 * k, b = 2 * ((k + 1) % n);
    washer.triangles.push_back({a, a + 1, b + 1});
    washer.triangles.push_back({a, b + 1, b});
  }
  const Patch patch(washer);
  const Pattern pattern = unfold(patch);
  EXPECT_LE(largest_change(patch, pattern), 1e-9 * 100.0);
  EXPECT_FALSE(pattern.overlaps);
}

// A dome whose top is a hole of any size is stretched no more than the dome itself.
TEST(UnfoldWithHoles, TakesStretchOutOfADome) {
  const TriMesh dome = make_shape("dome", 1500);
  const Patch whole(dome);
  TriMesh open = dome;
  double top = 0.0;
  for (const Vec3& p : dome.positions)
    top = std::max(top, p.z);
  std::erase_if(open.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](Index v) { return dome.positions[v].z > 0.8 * top; });
  });
  const Patch with_hole(open);
  ASSERT_EQ(with_hole.border_loops().size(), 2U);
  const Pattern pattern = unfold(with_hole, {.least_stretch = true});
  EXPECT_FALSE(pattern.overlaps);
  EXPECT_EQ(pattern.flipped_triangles, 0U);
  const double rms = edge_strain(with_hole, pattern.positions).rms;
  EXPECT_LT(rms, edge_strain(whole, unfold(whole, {.least_stretch = true}).positions).rms);
  EXPECT_GT(rms, 0.0);
}

// Every loop keeps the lengths of its edges where seams are to match.
TEST(UnfoldWithHoles, KeepsTheLengthsOfAllBordersWhereSeamsMatch) {
  const Place hill = [](double x, double y) {
    return Vec3{x, y, 3.0 * std::sin(x / 9.0) * std::sin(y / 7.0)};
  };
  const Patch patch(perforated(30, 24, blocks(30, 24, 2, 2, 4), hill));
  const Pattern pattern = unfold(patch, {.match_seams = true});
  EXPECT_LE(largest_border_strain(patch, pattern.positions, {}), 1e-9);
  EXPECT_FALSE(pattern.overlaps);
}

TEST(UnfoldWithHoles, KeepsLimitsOfStrain) {
  const Place hill = [](double x, double y) {
    return Vec3{x, y, 3.0 * std::sin(x / 9.0) * std::sin(y / 7.0)};
  };
  const Patch patch(perforated(30, 24, blocks(30, 24, 2, 1, 5), hill));
  const double least = edge_strain(patch, unfold(patch, {.least_stretch = true}).positions).max;
  UnfoldOptions options;
  options.limits.max = 0.8 * least;
  const Pattern pattern = unfold(patch, options);
  EXPECT_LE(edge_strain(patch, pattern.positions).max, 0.8 * least);
}

TEST(UnfoldWithHoles, GivesTheSameBitsForEveryNumberOfThreads) {
  const Patch patch(perforated(60, 40, blocks(60, 40, 3, 2, 7), on_cone));
  const std::vector<Vec2> alone = unfold(patch, {}, {.threads = 1}).positions;
  EXPECT_EQ(unfold(patch, {}, {.threads = 4}).positions, alone);
}

// Holes of three vertices at random places of a random grid.
TEST(UnfoldWithHoles, TakesMissingTriangles) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 20; ++trial) {
    TriMesh mesh = meshes::rough_grid(12, 12, static_cast<std::uint64_t>(trial));
    for (int k = 0; k < 3; ++k)
      mesh.triangles.erase(mesh.triangles.begin() +
                           static_cast<std::ptrdiff_t>(random() % mesh.triangles.size()));
    if (inspect(mesh).problems.size() > 0) continue;  // touching holes are no manifold
    const Patch patch(mesh);
    const Pattern pattern = unfold(patch);
    EXPECT_EQ(pattern.flipped_triangles, 0U);
    EXPECT_EQ(pattern.positions.size(), mesh.positions.size());
  }
}

}  // namespace
}  // namespace planish
