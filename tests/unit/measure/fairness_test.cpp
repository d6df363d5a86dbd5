#include <algorithm>
#include <cmath>
#include <numbers>

#include <planish/measure/fairness.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "measure/smoothed.h"
#include "support/bent_sheets.h"
#include "support/meshes.h"

namespace planish {
namespace {

using std::numbers::pi;

Fairness compared(const TriMesh& design, const TriMesh& after) {
  return measure_fairness(Patch(design), after.positions);
}

/// A grid over [0, 40] x [0, 20] on a cylinder of this radius, its axis along y.
TriMesh rolled(double radius) {
  TriMesh mesh = meshes::flat_grid(40, 20);
  for (Vec3& p : mesh.positions)
    p = {radius * std::sin(p.x / radius), p.y, radius * std::cos(p.x / radius)};
  return mesh;
}

TEST(Fairness, OfTheDesignItselfIsSmooth) {
  const TriMesh design = meshes::bent_sphere(30);
  const Fairness same = compared(design, design);
  EXPECT_TRUE(same.unchanged);
  EXPECT_TRUE(same.is_smooth());
  EXPECT_TRUE(same.keeps_form());
  EXPECT_NEAR(*same.bending_ratio, 1.0, 0.02);
  EXPECT_EQ(*same.bending_added, 0.0);
  EXPECT_EQ(*same.bending_lost, 0.0);
  EXPECT_EQ(*same.normal_turn, 0.0);
  EXPECT_EQ(*same.border_turn, 0.0);
  EXPECT_FALSE(same.sharpest_fold);
  EXPECT_LE(same.sharp_share, 0.0101);
}

TEST(Fairness, OfADesignWithNoiseAllowsTheNoise) {
  const TriMesh design = make_shape("panel", 2000);
  TriMesh flatter = design, rougher = design;
  for (std::size_t v = 0; v < design.positions.size(); ++v) {
    flatter.positions[v].z *= 0.98;
    rougher.positions[v].z *= 1.05;
  }
  const Fairness less = compared(design, flatter), more = compared(design, rougher);
  EXPECT_GT(less.design_ratio, k_smooth_ratio) << "the noise of the design";
  EXPECT_GT(*less.bending_ratio, k_smooth_ratio);
  EXPECT_LT(*less.bending_ratio, less.design_ratio);
  EXPECT_TRUE(less.bends_little());
  EXPECT_TRUE(less.bends_at_most(0.0)) << "no more than the design";
  EXPECT_FALSE(more.bends_little());
  EXPECT_TRUE(more.bends_at_most(*more.bending_ratio));
  EXPECT_FALSE(more.bends_at_most(0.99 * *more.bending_ratio));
  EXPECT_FALSE(more.is_smooth_within(0.0)) << "no bound";
  EXPECT_TRUE(more.is_smooth_within(*more.bending_ratio));
  EXPECT_FALSE(more.is_smooth_within(0.99 * *more.bending_ratio));
  EXPECT_TRUE(less.is_smooth_within(0.0));
  EXPECT_EQ(compared(design, design).bending_ratio, less.design_ratio);
}

TEST(Fairness, OfTheDesignIsKnownFromAnyResult) {
  const TriMesh flat = meshes::flat_grid(12, 8);
  for (const TriMesh& design : {meshes::bent_sphere(30), make_shape("panel", 2000), flat}) {
    TriMesh result = design;
    for (Vec3& p : result.positions)
      p.z = 0.9 * p.z + 0.01 * p.x * p.x;
    const Fairness measured = compared(design, design);
    const Fairness known = fairness_of_design(compared(design, result));
    EXPECT_EQ(known.unchanged, measured.unchanged);
    EXPECT_EQ(known.bending_ratio, measured.bending_ratio);
    EXPECT_EQ(known.design_ratio, measured.design_ratio);
    EXPECT_EQ(known.bending_added, measured.bending_added);
    EXPECT_EQ(known.bending_lost, measured.bending_lost);
    EXPECT_EQ(known.height_ratio, measured.height_ratio);
    EXPECT_EQ(known.largest_move, measured.largest_move);
    EXPECT_EQ(known.normal_turn, measured.normal_turn);
    EXPECT_EQ(known.border_turn, measured.border_turn);
    EXPECT_EQ(known.sharpest_fold.has_value(), measured.sharpest_fold.has_value());
    EXPECT_EQ(known.sharp_share, measured.sharp_share);
  }
}

TEST(Fairness, TellsAFoldMadeByHand) {
  // A cylinder, folded along the row of edges y = 10 by half a radian: each edge there has length 1
  // and a share of 1/3 of the area, so the fold adds 40 x 3 x 1/4 to the bending.
  const TriMesh design = rolled(40.0);
  TriMesh folded = design;
  constexpr double turn = 0.5;
  const auto row = [](std::size_t i) { return i / 41; };
  for (std::size_t i = 0; i < folded.positions.size(); ++i) {
    const double over = static_cast<double>(row(i)) - 10.0;
    if (over <= 0.0) continue;
    // Shears along the radius, which leaves the other bends nearly as they are.
    const Vec3 p = design.positions[i];
    const double out = 1.0 + over * std::tan(turn) / 40.0;
    folded.positions[i] = {out * p.x, 10.0 + over, out * p.z};
  }
  const Fairness found = compared(design, folded);
  const double b0 = design_bending(Patch(design));
  EXPECT_NEAR(*found.bending_added * b0 / (40.0 * 3.0 * turn * turn), 1.0, 0.1);
  EXPECT_LT(*found.bending_lost, 0.1);
  EXPECT_NEAR(found.sharpest_fold->degrees, turn * 180.0 / pi, 1.0);
  EXPECT_EQ(row(found.sharpest_fold->from), 10U);
  EXPECT_EQ(row(found.sharpest_fold->to), 10U);
  EXPECT_NEAR(found.sharpest_fold->at.y, 10.0, 1e-12);
  EXPECT_FALSE(found.is_smooth());
  // The last row went out by 10 tan(turn).
  EXPECT_NEAR(*found.largest_move * bounding_box_diagonal(design), 10.0 * std::tan(turn), 1e-9);
  EXPECT_FALSE(found.keeps_form());
}

TEST(Fairness, TellsWhatWasFlattened) {
  const TriMesh design = rolled(40.0);
  const Fairness flat = compared(design, meshes::flat_grid(40, 20));
  EXPECT_NEAR(*flat.bending_lost, 1.0, 2e-3);
  EXPECT_EQ(*flat.bending_added, 0.0);
  EXPECT_EQ(*flat.bending_ratio, 0.0);
  EXPECT_FALSE(flat.keeps_form());
  EXPECT_TRUE(flat.is_smooth());
  // Half as much curvature: a quarter of the bending stays, and a quarter is lost.
  const Fairness half = compared(design, rolled(80.0));
  EXPECT_NEAR(*half.bending_ratio, 0.25, 1e-3);
  EXPECT_NEAR(*half.bending_lost, 0.25, 1e-3);
  EXPECT_NEAR(*half.bending_added, 0.0, 1e-9);
  // Bent the other way: all came, all went.
  TriMesh over = design;
  for (Vec3& p : over.positions)
    p.z = -p.z;
  const Fairness turned = compared(design, over);
  EXPECT_NEAR(*turned.bending_ratio, 1.0, 2e-3);
  EXPECT_NEAR(*turned.bending_added, 1.0, 2e-3);
  EXPECT_NEAR(*turned.bending_lost, 1.0, 2e-3);
}

TEST(Fairness, TellsAFormThatSank) {
  const auto dome = [](double height) {
    TriMesh mesh = meshes::flat_grid(20, 20);
    for (Vec3& p : mesh.positions)
      p.z = height * std::sin(pi * p.x / 20.0) * std::sin(pi * p.y / 20.0);
    return mesh;
  };
  const Fairness sunk = compared(dome(6.0), dome(4.4));
  EXPECT_NEAR(*sunk.height_ratio, 4.4 / 6.0, 1e-12);
  EXPECT_LT(*sunk.bending_lost, 0.5) << "the bending alone does not show it";
  EXPECT_FALSE(sunk.keeps_form());
  EXPECT_TRUE(compared(dome(6.0), dome(4.8)).keeps_form());
  EXPECT_TRUE(compared(dome(6.0), dome(8.0)).keeps_form());
  EXPECT_FALSE(compared(dome(0.3), dome(0.1)).height_ratio) << "it had no height";
  const Fairness other = measure_fairness(Patch(dome(6.0)), Patch(dome(3.0)));
  EXPECT_NEAR(*other.height_ratio, 0.5, 1e-12);
  EXPECT_FALSE(other.keeps_form());
  // In any place and size.
  TriMesh far = dome(6.0), low = dome(3.0);
  for (TriMesh* mesh : {&far, &low}) {
    for (Vec3& p : mesh->positions)
      p = {1e-6 * p.z + 1e-3, 1e-6 * p.x, 1e-6 * p.y};
  }
  EXPECT_NEAR(*compared(far, low).height_ratio, 0.5, 1e-9);
}

TEST(Fairness, TellsOfOneVertexThatMovedFar) {
  const TriMesh design = meshes::bent_sphere(40);
  const double diagonal = bounding_box_diagonal(design);
  const Index inner = Patch(design).inner_vertices()[100];
  for (const double share : {0.09, 0.11}) {
    TriMesh result = design;
    result.positions[inner].x += share * diagonal;
    Fairness fairness = compared(design, result);
    EXPECT_NEAR(*fairness.largest_move, share, 1e-12);
    fairness.form_change = {};
    fairness.height_ratio = {};
    EXPECT_EQ(fairness.keeps_form(), share < k_kept_move);
  }
  EXPECT_FALSE(measure_fairness(Patch(design), Patch(design)).largest_move) << "other triangles";
}

TEST(Fairness, TellsHowNormalsTurned) {
  const TriMesh design = rolled(40.0);
  TriMesh turned = design;
  for (Vec3& p : turned.positions)
    p = {p.x, std::cos(0.3) * p.y - std::sin(0.3) * p.z, std::sin(0.3) * p.y + std::cos(0.3) * p.z};
  const Fairness found = compared(design, turned);
  // A turn about x turns a normal at the angle a from z by less.
  EXPECT_LT(*found.normal_turn, 0.3 * 180.0 / pi);
  EXPECT_GT(*found.normal_turn, 0.25 * 180.0 / pi);
  EXPECT_NEAR(*found.bending_added, 0.0, 1e-9);
  // Only the triangles along the border turn where only the border moves.
  TriMesh lifted = meshes::flat_grid(10, 10);
  const TriMesh flat = lifted;
  for (Vec3& p : lifted.positions) {
    if (p.x == 0.0) p.z = 1.0;
  }
  // Of 36 triangles along the border those of the first column turned, by 45 degrees.
  const Fairness border = compared(flat, lifted);
  EXPECT_GT(*border.border_turn, 45.0 * std::sqrt(10.0 / 38.0) * 0.9);
  EXPECT_LT(*border.border_turn, 45.0 * std::sqrt(14.0 / 36.0));
}

TEST(Fairness, BesideAPlaneOnlyThePlaneIsSmooth) {
  const TriMesh flat = meshes::flat_grid(10, 10);
  EXPECT_TRUE(compared(flat, flat).is_smooth());
  TriMesh bent = flat;
  bent.positions[60].z = 1e-3;
  const Fairness found = compared(flat, bent);
  EXPECT_FALSE(found.bending_ratio || found.bending_added || found.bending_lost);
  EXPECT_FALSE(found.is_smooth());
  EXPECT_TRUE(found.normal_turn && found.sharpest_fold);
}

TEST(Fairness, HardlyDependsOnTheDensityOfTheMesh) {
  // A fold in a cap, at three densities.
  const auto pair = [](std::size_t cells) {
    const auto fold = [](double u) { return 0.02 * std::exp(-150.0 * (u - 0.5) * (u - 0.5)); };
    const TriMesh design = meshes::bent_sphere(cells);
    TriMesh after = design;
    for (Vec3& p : after.positions)
      p.z += fold(p.x + 0.5);
    return compared(design, after);
  };
  const Fairness coarse = pair(40), middle = pair(80), fine = pair(160);
  for (const Fairness& other : {coarse, middle}) {
    EXPECT_NEAR(*other.bending_ratio / *fine.bending_ratio, 1.0, 0.08);
    EXPECT_NEAR(*other.bending_added / *fine.bending_added, 1.0, 0.08);
    EXPECT_NEAR(*other.bending_lost / *fine.bending_lost, 1.0, 0.08);
    EXPECT_NEAR(*other.normal_turn / *fine.normal_turn, 1.0, 0.08);
    EXPECT_NEAR(other.sharp_share / fine.sharp_share, 1.0, 0.08);
  }
}

TEST(Fairness, OfOtherTrianglesIsRatioAndSharpShare) {
  const Fairness found =
      measure_fairness(Patch(meshes::folded_strip(160)), Patch(meshes::folded_strip(80)));
  EXPECT_NEAR(*found.bending_ratio, 1.0, 0.08);
  EXPECT_FALSE(found.bending_added || found.bending_lost || found.normal_turn ||
               found.border_turn || found.sharpest_fold);
  EXPECT_TRUE(found.is_smooth());
  EXPECT_FALSE(measure_fairness(Patch(meshes::bent_sphere(60)), Patch(meshes::crumpled_sheet(60)))
                   .is_smooth());
}

TEST(Fairness, DoesNotDependOnTheSizeOfTheModel) {
  const TriMesh design = meshes::rough_grid(9, 9, 1), after = meshes::rough_grid(9, 9, 2);
  const Fairness found = compared(design, after);
  TriMesh a = design, b = after;
  for (std::size_t v = 0; v < a.positions.size(); ++v) {
    a.positions[v] = 0x1p-300 * a.positions[v];
    b.positions[v] = 0x1p-300 * b.positions[v];
  }
  const Fairness small = compared(a, b);
  EXPECT_DOUBLE_EQ(*small.bending_added, *found.bending_added);
  EXPECT_DOUBLE_EQ(*small.normal_turn, *found.normal_turn);
  EXPECT_DOUBLE_EQ(small.sharp_share, found.sharp_share);
}

}  // namespace
}  // namespace planish
