#include <algorithm>
#include <array>
#include <vector>

#include <planish/mesh/carry.h>
#include <planish/mesh/symmetry.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

const Plane k_middle{{1.0, 0.0, 0.0}, 6.0};
constexpr double k_tolerance = 0.3;

/// Symmetric in x = 6, vertex by vertex, but not triangle by triangle.
Patch grid_hill() {
  return Patch(meshes::height_field(12, 8, [](double x, double y) {
    return 4.0 - 0.1 * (x - 6.0) * (x - 6.0) - 0.1 * (y - 4.0) * (y - 4.0);
  }));
}

/// And triangle by triangle, with other numbers.
Patch hill() {
  return Patch(symmetric_mesh(grid_hill(), k_middle, MirrorSide::above).mesh);
}

/// The same surface but for its vertices inside, which are nowhere.
Patch uneven_hill() {
  TriMesh mesh = grid_hill().mesh();
  meshes::Random random(3);
  for (Vec3& p : mesh.positions) {
    if (p.x > 0.0 && p.x < 12.0 && p.y > 0.0 && p.y < 8.0)
      p = {p.x + 0.2 * random.number(), p.y + 0.2 * random.number(), 0.0};
    p.z = 4.0 - 0.1 * (p.x - 6.0) * (p.x - 6.0) - 0.1 * (p.y - 4.0) * (p.y - 4.0);
  }
  return Patch(mesh);
}

SurfaceLine drawn(const Patch& patch, const std::vector<Vec3>& points) {
  const std::array line = {DrawnLine{points, {}}};
  return trace_lines(patch, {{line.begin(), line.end()}, {}}).lines.at(0);
}

std::vector<Vec3> places(const Patch& patch, const SurfaceLine& line) {
  std::vector<Vec3> all;
  for (const SurfacePoint& place : line)
    all.push_back(position_of(place, patch.positions()));
  return all;
}

double distance_to(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 along = b - a;
  const double share = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
  return norm(p - (a + share * along));
}

SymmetricLines symmetric(const Patch& patch, const std::vector<SurfaceLine>& lines) {
  return symmetric_lines(patch, lines, symmetry_in(patch, k_middle), k_tolerance);
}

/// The largest distance of a point of lines from the mirror image of all.
double asymmetry(const Patch& patch, const SymmetricLines& lines) {
  double largest = 0.0;
  for (const MirroredLine& line : lines.lines) {
    for (const Vec3 p : places(patch, line.line)) {
      double nearest = 1e9;
      for (const MirroredLine& other : lines.lines) {
        const std::vector<Vec3> way = places(patch, other.line);
        for (std::size_t k = 1; k < way.size(); ++k)
          nearest = std::min(nearest, distance_to(mirrored(k_middle, p), way[k - 1], way[k]));
      }
      largest = std::max(largest, nearest);
    }
  }
  return largest;
}

TEST(SymmetricLines, GetAnExactMirrorImage) {
  const Patch patch = grid_hill();
  const SurfaceLine line = line_along_edges(patch, std::array<Index, 3>{7, 20, 34});
  const SymmetricLines both = symmetric(patch, {line});
  ASSERT_EQ(both.lines.size(), 2U);
  EXPECT_FALSE(both.lines[0].is_mirrored);
  EXPECT_TRUE(both.lines[1].is_mirrored);
  EXPECT_EQ(both.lines[1].of, 0U);
  EXPECT_EQ(both.drawn_side, MirrorSide::above);
  // The image of the diagonal is no edge of this mesh: the line is laid on it.
  EXPECT_LE(norm(places(patch, both.lines[1].line).back() - patch.positions()[30]), 1e-12);
  const SurfaceLine along = line_along_edges(patch, std::array<Index, 3>{7, 20, 33});
  const SymmetricLines exact = symmetric(patch, {along});
  ASSERT_EQ(exact.lines.at(1).line.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(exact.lines[1].line[k].corners[0], (std::array<Index, 3>{5, 18, 31}[k]));
  EXPECT_EQ(asymmetry(patch, exact), 0.0);
}

TEST(SymmetricLines, AreLaidOnTheSurfaceWhereVerticesHaveNoImages) {
  const Patch patch = uneven_hill();
  const SurfaceLine line = drawn(patch, {{8.2, 1.1, 0}, {10.3, 4.4, 0}});
  const SymmetricLines both = symmetric(patch, {line});
  ASSERT_EQ(both.lines.size(), 2U);
  const std::vector<Vec3> image = places(patch, both.lines[1].line);
  EXPECT_LE(norm(image.front() - mirrored(k_middle, places(patch, line).front())), 0.1);
  EXPECT_LE(norm(image.back() - mirrored(k_middle, places(patch, line).back())), 0.1);
}

TEST(SymmetricLines, OnThePlaneAreThereOnce) {
  const Patch patch = hill();
  for (const double off : {0.0, 0.2}) {
    std::vector<Vec3> points;
    for (int k = 0; k <= 8; ++k)
      points.push_back({6.0 + off * (k % 2), static_cast<double>(k), 4.0});
    const SymmetricLines once = symmetric(patch, {drawn(patch, points)});
    ASSERT_EQ(once.lines.size(), 1U) << off;
    for (const Vec3 p : places(patch, once.lines[0].line))
      EXPECT_NEAR(p.x, 6.0, 1e-12);
    EXPECT_FALSE(once.drawn_side);
  }
}

TEST(SymmetricLines, ThatCrossThePlaneAreDividedThere) {
  const Patch patch = hill();
  const SymmetricLines halves = symmetric(patch, {drawn(patch, {{2, 3, 2}, {11, 3, 2}})});
  EXPECT_LE(asymmetry(patch, halves), 1e-9);
  EXPECT_EQ(halves.drawn_side, MirrorSide::above);
  double drawn_length = 0.0, length = 0.0;
  for (const MirroredLine& line : halves.lines) {
    length += length_of(line.line, patch.positions());
    if (!line.is_mirrored) drawn_length += length_of(line.line, patch.positions());
  }
  EXPECT_NEAR(length, 2.0 * drawn_length, 1e-12);
  EXPECT_GT(drawn_length, 5.0);
}

TEST(SymmetricLines, WithACounterpartGetNoSecondOne) {
  const std::vector<Vec3> right = {{8, 1, 3}, {10, 4, 3}}, left = {{3.9, 1.1, 3}, {2.1, 4, 3}};
  const Patch even = hill();
  const SymmetricLines exact = symmetric(even, {drawn(even, right), drawn(even, left)});
  ASSERT_EQ(exact.lines.size(), 2U);
  EXPECT_LE(asymmetry(even, exact), 0.1);
  // Where nothing is exact, both stay where they are.
  const Patch uneven = uneven_hill();
  const SymmetricLines kept = symmetric(uneven, {drawn(uneven, right), drawn(uneven, left)});
  ASSERT_EQ(kept.lines.size(), 2U);
  EXPECT_FALSE(kept.lines[0].is_mirrored || kept.lines[1].is_mirrored);
}

TEST(SymmetricLines, OnBothSidesAreAllMirrored) {
  const Patch patch = hill();
  const SymmetricLines four = symmetric(
      patch, {drawn(patch, {{8, 1, 3}, {10, 1, 3}}), drawn(patch, {{3, 6, 3}, {1, 6, 3}})});
  EXPECT_EQ(four.lines.size(), 4U);
  EXPECT_LE(asymmetry(patch, four), 1e-9);
}

TEST(SymmetricLines, OfNoneAreNone) {
  EXPECT_TRUE(symmetric(hill(), {}).lines.empty());
}

}  // namespace
}  // namespace planish
