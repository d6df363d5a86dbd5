#include <cmath>

#include <planish/measure/cautions.h>

#include <gtest/gtest.h>

#include "support/bent_sheets.h"
#include "support/meshes.h"

namespace planish {
namespace {

std::optional<CoarseCoordinates> coarse_in(const TriMesh& mesh) {
  return find_coarse_coordinates(Patch(mesh));
}

TriMesh moved(TriMesh mesh, double size, Vec3 to) {
  for (Vec3& p : mesh.positions)
    p = size * p + to;
  return mesh;
}

template <class Round>
TriMesh rounded(TriMesh mesh, Round round) {
  for (Vec3& p : mesh.positions)
    p = {round(p.x), round(p.y), round(p.z)};
  return mesh;
}

double as_float(double x) {
  return static_cast<double>(static_cast<float>(x));
}

// The distance of neighbouring 32-bit numbers from 2^18 = 262,144 to 2^19 = 524,288.
constexpr double k_step = 1.0 / 32.0;

TEST(CoarseCoordinates, AreThoseOf32BitsFarFromTheOrigin) {
  // Metres: a sheet 2.4 m wide, its edges of 8 cm.
  const TriMesh sheet = moved(meshes::bent_cylinder(30), 2.4, {4e5, 3e5, 20.0});
  EXPECT_FALSE(coarse_in(sheet)) << "with all its digits";
  const auto coarse = coarse_in(rounded(sheet, as_float));
  ASSERT_TRUE(coarse);
  EXPECT_EQ(coarse->step, k_step);
  EXPECT_NEAR(coarse->mean_edge, 0.08, 0.02);
  EXPECT_FALSE(coarse_in(rounded(meshes::bent_cylinder(30), as_float))) << "near the origin";
}

TEST(CoarseCoordinates, AreSeenOnOneAxisAndBelowZero) {
  const TriMesh sheet = moved(meshes::bent_sphere(30), 2.4, {0.0, -4e5, 0.0});
  const auto coarse = coarse_in(rounded(sheet, as_float));
  ASSERT_TRUE(coarse);
  EXPECT_EQ(coarse->step, k_step);
}

// Rounding leaves an axis few numbers where it is coarse.
TEST(CoarseCoordinates, AreSeenWhereRoundingLeavesFewNumbers) {
  TriMesh plate = meshes::flat_grid(6, 3);
  for (Vec3& p : plate.positions)
    p = {0.4 * p.x + 0.013, 0.4 * p.y + 0.007, 0.0};
  for (const double far : {4e5, 5.4e6}) {
    const TriMesh there = moved(plate, 1.0, {far, far, 0.0});
    EXPECT_FALSE(coarse_in(there)) << far;
    EXPECT_TRUE(coarse_in(rounded(there, as_float))) << far;
  }
  EXPECT_FALSE(coarse_in(rounded(moved(plate, 1.0, {0.0, 0.0, 4e5}), as_float)))
      << "one number that is rounded moves all of the plate";
}

TEST(CoarseCoordinates, AreSeenInOtherUnitsToo) {
  const TriMesh metres = rounded(moved(meshes::bent_cylinder(30), 2.4, {4e5, 0.0, 0.0}), as_float);
  for (const double unit : {1000.0, 25.4, 0.0254}) {
    const auto coarse = coarse_in(moved(metres, unit, {}));
    ASSERT_TRUE(coarse) << unit;
    EXPECT_NEAR(coarse->step, unit * k_step, 1e-4 * unit * k_step);
  }
}

TEST(CoarseCoordinates, AreThoseOfFewDecimalDigits) {
  const TriMesh sheet = moved(meshes::bent_cylinder(30), 2.4, {413256.0, 5648123.0, 0.0});
  const auto tenths = [](double x) { return std::round(10.0 * x) / 10.0; };
  const auto coarse = coarse_in(rounded(sheet, tenths));
  ASSERT_TRUE(coarse);
  EXPECT_NEAR(coarse->step, 0.1, 1e-5);
  const auto tenths_of_millimetres = [](double x) { return std::round(1e4 * x) / 1e4; };
  EXPECT_FALSE(coarse_in(rounded(sheet, tenths_of_millimetres))) << "1/800 of an edge";
}

TEST(CoarseCoordinates, AreNotTheGridOfADesign) {
  EXPECT_FALSE(coarse_in(meshes::flat_grid(20, 20)));
  EXPECT_FALSE(coarse_in(moved(meshes::flat_grid(20, 20), 1.0, {400000.0, 5648123.0, 0.0})));
  EXPECT_FALSE(coarse_in(moved(meshes::flat_grid(20, 20), 25.0, {400000.0, 0.0, 0.0})));
}

TEST(CoarseCoordinates, AreNoneWhereTheStepIsAHundredthOfAnEdge) {
  // Edges of 3.2 m and of 2.9 m.
  const auto sheet = [](double size) {
    return rounded(moved(meshes::bent_sheet(20,
                                            [](double u, double v) {
                                              return Vec3{u, v, 0.2 * u * v};
                                            }),
                         20.0 * size, {4e5, 0.0, 0.0}),
                   as_float);
  };
  EXPECT_FALSE(coarse_in(sheet(3.2)));
  EXPECT_TRUE(coarse_in(sheet(2.9)));
}

}  // namespace
}  // namespace planish
