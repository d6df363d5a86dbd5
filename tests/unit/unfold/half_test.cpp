#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <planish/flatten/flatten.h>
#include <planish/unfold/unfold.h>

#include <gtest/gtest.h>

#include "mesh/match/symmetric_whole.h"
#include "support/meshes.h"

namespace planish {
namespace {

constexpr std::size_t k_columns = 8, k_rows = 10;

Index vertex_of_cell(std::size_t column, std::size_t row) {
  return static_cast<Index>(row * (k_columns + 1) + column);
}

/// The right half of a body bulging about its middle, which is the fold, turned in space.
TriMesh bulging_half(double height, double turn = 0.4) {
  TriMesh mesh = meshes::height_field(k_columns, k_rows, [&](double x, double y) {
    return height * (1.0 - 0.012 * x * x - 0.02 * (y - 4.0) * (y - 4.0));
  });
  const double c = std::cos(turn), s = std::sin(turn);
  for (Vec3& p : mesh.positions)
    p = {c * p.x - s * p.z, p.y + 0.1 * p.x, s * p.x + c * p.z};
  return mesh;
}

/// Its mirror image would meet it at x = 0 only where nothing leans.
TriMesh upright_half(double height) {
  return meshes::height_field(k_columns, k_rows, [&](double x, double y) {
    return height * (1.0 - 0.012 * x * x - 0.02 * (y - 4.0) * (y - 4.0));
  });
}

TriMesh whole_of(const TriMesh& half) {
  const auto whole =
      symmetric_whole(Patch(half), {vertex_of_cell(0, 0), vertex_of_cell(0, k_rows)});
  return whole->patch.mesh();
}

const std::array<Index, 2> k_fold = {vertex_of_cell(0, 0), vertex_of_cell(0, k_rows)};

double bow(const std::vector<Vec2>& pattern) {
  const Vec2 from = pattern[k_fold[0]], way = pattern[k_fold[1]] - from;
  double most = 0.0;
  for (std::size_t row = 0; row <= k_rows; ++row)
    most = std::max(most, std::abs(cross(way, pattern[vertex_of_cell(0, row)] - from)) / norm(way));
  return most;
}

double fold_length(const std::vector<Vec2>& pattern) {
  return norm(pattern[k_fold[1]] - pattern[k_fold[0]]);
}

// The plane of its bowed edge is that of the plate: the whole would be the plate twice.
TEST(SymmetricWhole, IsNoneOfAPlateWithABowedEdge) {
  TriMesh plate = meshes::height_field(k_columns, k_rows, [](double, double) { return 0.0; });
  for (std::size_t row = 0; row <= k_rows; ++row) {
    const double v = static_cast<double>(row) / k_rows;
    for (std::size_t column = 0; column <= k_columns; ++column) {
      const double inside = 1.0 - static_cast<double>(column) / k_columns;
      plate.positions[vertex_of_cell(column, row)].x += 2.0 * inside * v * (1.0 - v);
    }
  }
  EXPECT_FALSE(symmetric_whole(Patch(plate), k_fold));
}

TEST(SymmetricWhole, IsTwiceTheHalfInEveryPlane) {
  for (const double turn : {0.0, 0.4, -1.1}) {
    const Patch half(bulging_half(3.0, turn));
    const auto whole = symmetric_whole(half, k_fold);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->patch.triangles().size(), 2 * half.triangles().size());
    EXPECT_EQ(whole->patch.vertex_count(), 2 * half.vertex_count() - (k_rows + 1));
    EXPECT_EQ(whole->patch.border_loops().size(), 1U);
    EXPECT_EQ(whole->half_size, half.vertex_count());
    const std::vector<Vec3>& all = whole->patch.positions();
    for (Index v = 0; v < half.vertex_count(); ++v) {
      EXPECT_NEAR(norm(all[v] - half.positions()[v]), 0.0, 1e-9);
      EXPECT_NEAR(norm(mirrored(whole->plane, all[v]) - all[whole->image[v]]), 0.0, 1e-9);
    }
  }
}

TEST(SymmetricWhole, IsThereForAStraightFold) {
  const Patch flat(meshes::flat_grid(k_columns, k_rows));
  for (const auto& ends :
       {k_fold, std::array<Index, 2>{vertex_of_cell(0, k_rows), vertex_of_cell(0, 0)}}) {
    const auto whole = symmetric_whole(flat, ends);
    ASSERT_TRUE(whole);
    for (const Vec3& p : whole->patch.positions())
      EXPECT_NEAR(p.z, 0.0, 1e-12) << "a flat half is that of a flat whole";
  }
}

TEST(SymmetricWhole, IsNotThereForAFoldThatLeavesItsPlane) {
  TriMesh twisted = upright_half(3.0);
  for (Vec3& p : twisted.positions)
    p.x += 0.3 * std::sin(0.7 * p.y);
  EXPECT_FALSE(symmetric_whole(Patch(twisted), k_fold));
  const Patch half(upright_half(3.0));
  EXPECT_FALSE(symmetric_whole(half, {vertex_of_cell(0, 0), vertex_of_cell(0, 0)}));
  EXPECT_FALSE(symmetric_whole(half, {vertex_of_cell(0, 0), vertex_of_cell(3, 3)}))
      << "not on the border";
}

TEST(UnfoldOfAHalf, HasAStraightFoldAsLongAsInTheWhole) {
  for (const double height : {0.0, 1.0, 4.0}) {
    const Patch half(upright_half(height));
    const Pattern plain = unfold(half);
    const Pattern pattern = unfold(half, {.fold = k_fold});
    const Pattern whole = unfold(Patch(whole_of(half.mesh())));
    EXPECT_LT(bow(pattern.positions), 1e-9);
    if (height > 1.0) {
      EXPECT_GT(bow(plain.positions), 0.01) << "else there is nothing to mend";
    }
    EXPECT_NEAR(fold_length(pattern.positions), fold_length(whole.positions), 1e-5);
    EXPECT_EQ(pattern.flipped_triangles, 0U);
    EXPECT_FALSE(pattern.overlaps);
    EXPECT_TRUE(pattern.converged);
  }
}

TEST(UnfoldOfAHalf, KeepsLimitsAndTheLengthsOfSeams) {
  const Patch half(upright_half(4.0));
  const Pattern matched = unfold(half, {.match_seams = true, .fold = k_fold});
  EXPECT_LT(bow(matched.positions), 1e-9);
  for (std::size_t row = 0; row < k_rows; ++row) {
    const Index a = vertex_of_cell(k_columns, row), b = vertex_of_cell(k_columns, row + 1);
    const double length = norm(half.positions()[b] - half.positions()[a]);
    EXPECT_NEAR(norm(matched.positions[b] - matched.positions[a]), length, 1e-7 * length);
  }
  EXPECT_EQ(matched.unmatched_least_stretch.size(), half.vertex_count());
  const EdgeStrain least = edge_strain(half, unfold(half, {.fold = k_fold}).positions);
  const double limit = 0.8 * least.max;
  const Pattern limited = unfold(half, {.limits = {.max = limit}, .fold = k_fold});
  EXPECT_LE(edge_strain(half, limited.positions).max, limit);
  EXPECT_LT(bow(limited.positions), 1e-9);
}

TEST(UnfoldOfAHalf, KeepsALimitAndTheLengthsOfSeamsTogether) {
  const Patch half(upright_half(4.0));
  const Pattern least = unfold(half, {.match_seams = true, .least_stretch = true, .fold = k_fold});
  const double limit = 0.8 * edge_strain(half, least.positions).max;
  const Pattern pattern =
      unfold(half, {.match_seams = true, .limits = {.max = limit}, .fold = k_fold});
  EXPECT_LE(edge_strain(half, pattern.positions).max, limit);
  EXPECT_EQ(pattern.least_stretch.size(), half.vertex_count());
  EXPECT_LT(bow(pattern.positions), 1e-9);
  for (std::size_t row = 0; row < k_rows; ++row) {
    const Index a = vertex_of_cell(k_columns, row), b = vertex_of_cell(k_columns, row + 1);
    const double length = norm(half.positions()[b] - half.positions()[a]);
    EXPECT_NEAR(norm(pattern.positions[b] - pattern.positions[a]), length, 1e-7 * length);
  }
}

TEST(UnfoldOfAHalf, IsPlainWhereTheFoldLeavesItsPlane) {
  TriMesh twisted = upright_half(3.0);
  for (Vec3& p : twisted.positions)
    p.x += 0.3 * std::sin(0.7 * p.y);
  const Patch patch(twisted);
  EXPECT_EQ(unfold(patch, {.fold = k_fold}).positions, unfold(patch).positions);
}

TEST(FlattenOfAHalf, EvolvesTheWhole) {
  const Patch half(upright_half(4.0));
  FlattenOptions options = preset_options(5);
  options.fold = k_fold;
  const FlattenReport report = flatten(half, "half", options);
  EXPECT_LT(bow(report.unfold.pattern.positions), 1e-9);
  EXPECT_LT(bow(report.design_least_stretch.pattern.positions), 1e-9);
  EXPECT_GT(report.evolve.deviation.max, 0.0) << "it was evolved";
  for (std::size_t row = 0; row <= k_rows; ++row)
    EXPECT_NEAR(report.processed.positions()[vertex_of_cell(0, row)].x, 0.0, 1e-9)
        << "in the plane";
  const FlattenReport whole = flatten(Patch(whole_of(half.mesh())), "whole", preset_options(5));
  EXPECT_NEAR(report.unfold.strain.rms, whole.unfold.strain.rms, 0.02 * whole.unfold.strain.rms);
  EXPECT_NEAR(report.evolve.deviation.max, whole.evolve.deviation.max,
              0.02 * whole.evolve.deviation.max);
  EXPECT_NEAR(fold_length(report.unfold.pattern.positions),
              fold_length(whole.unfold.pattern.positions), 1e-3);
}

}  // namespace
}  // namespace planish
