#include <cmath>
#include <cstdio>
#include <string>

#include <planish/measure/cautions.h>

#include <gtest/gtest.h>

#include "support/bent_sheets.h"
#include "support/meshes.h"
#include "unit/measure/cautions/random_diagonals.h"

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

/// As C prints and reads it, with so many digits.
double printed(double x, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  return std::stod(text);
}

TriMesh printed(TriMesh mesh, int digits) {
  return rounded(std::move(mesh), [digits](double x) { return printed(x, digits); });
}

/// Turned by an angle whose tangent is `tangent`.
TriMesh turned(TriMesh mesh, double tangent) {
  const double c = 1.0 / std::hypot(1.0, tangent), s = tangent * c;
  for (Vec3& p : mesh.positions)
    p = {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
  return mesh;
}

// Edges are 20 times as long as the last digit.
TEST(CoarseCoordinates, AreThoseOfTheGeneralFormatHoweverFewThereAre) {
  for (const int digits : {6, 7, 8}) {
    const double step = std::pow(10.0, 6 - digits);
    for (const std::size_t cells : {2u, 3u, 12u}) {
      const TriMesh plate = meshes::flat_grid(cells, 2);
      for (const double size : {1.37, 2.6, 20.3}) {
        const TriMesh there =
            moved(turned(plate, 0.23), size * step, {412345.4 - 0.3 * step, 312345.7, 0.0});
        EXPECT_FALSE(coarse_in(there)) << cells << " cells of " << size;
        const auto coarse = coarse_in(printed(there, digits));
        ASSERT_TRUE(coarse) << cells << " cells of " << size << ", " << digits << " digits";
        EXPECT_NEAR(coarse->step, step, 1e-3 * step);
        EXPECT_TRUE(coarse_in(moved(printed(there, digits), 25.4, {}))) << "read in inches";
      }
    }
  }
}

TEST(CoarseCoordinates, AreSeenInEqualRowsWhereTheyStepUnequally) {
  const TriMesh row = moved(meshes::flat_grid(6, 1), 5.37, {412345.4, 20.0, 0.0});
  EXPECT_FALSE(coarse_in(row));
  EXPECT_TRUE(coarse_in(printed(row, 6)));
}

// Rows of vertices show nothing here, and that all sizes have the same number of digits does.
TEST(CoarseCoordinates, AreSeenByDigitsThatFillNumbersOfAllSizes) {
  TriMesh arch = meshes::flat_grid(4, 3);
  for (Vec3& p : arch.positions)
    p = {412300.31 + 17.13 * p.x * p.x, 7.0 * p.y + 10.0,
         20.0 + 2.345678 * p.x + 0.7123 * p.y * p.y};
  EXPECT_FALSE(coarse_in(arch));
  const auto coarse = coarse_in(printed(arch, 6));
  ASSERT_TRUE(coarse);
  EXPECT_EQ(coarse->step, 1.0);
}

// A plate of 120 x 80 mm, 12 to 60 m from the origin, its edges of 3 to 6 mm.
TEST(CoarseCoordinates, AreThoseOfFiveDigits) {
  TriMesh plate = meshes::flat_grid(40, 20);
  for (Vec3& p : plate.positions)
    p = {3.0 * p.x, 4.0 * p.y, 0.0};
  const auto scientific = [](double x) {
    char text[64];
    std::snprintf(text, sizeof text, "%.4e", x);
    return std::stod(text);
  };
  for (const Vec3 far :
       {Vec3{41234.5, 53123.0, 0.0}, Vec3{12345.0, 0.0, 0.0}, Vec3{0.0, 23456.7, 0.0}}) {
    const TriMesh there = moved(turned(plate, 0.309), 1.0, far);
    EXPECT_FALSE(coarse_in(there));
    for (const TriMesh& written : {printed(there, 5), rounded(there, scientific),
                                   rounded(there, [](double x) { return std::round(x); })}) {
      const auto coarse = coarse_in(written);
      ASSERT_TRUE(coarse) << far.x << " " << far.y;
      EXPECT_EQ(coarse->step, 1.0);
    }
    EXPECT_FALSE(coarse_in(rounded(there, [](double x) { return std::round(1e3 * x) / 1e3; })));
  }
}

TEST(CoarseCoordinates, AreNotTheWholeMillimetresOfADesign) {
  for (const double far : {12345.0, 41234.0, 80000.0}) {
    TriMesh grid = meshes::flat_grid(24, 16);
    EXPECT_FALSE(coarse_in(moved(grid, 5.0, {far, 53123.0, 0.0}))) << far;
    for (Vec3& p : grid.positions)
      p = {3.0 * p.x - 4.0 * p.y, 4.0 * p.x + 3.0 * p.y, 0.0};
    EXPECT_FALSE(coarse_in(moved(grid, 1.0, {far, 53123.0, 0.0}))) << far;
    // Fields of 2, 3, 4, 5 and 7 mm in an order without a rule.
    TriMesh fields = meshes::flat_grid(24, 16);
    const double sizes[] = {3.0, 7.0, 2.0, 5.0, 3.0, 4.0, 7.0};
    const auto place = [&](double n) {
      double at = 0.0;
      for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k)
        at += sizes[k % 7];
      return at;
    };
    for (Vec3& p : fields.positions)
      p = {far + place(p.x), 53123.0 + place(p.y), 0.0};
    EXPECT_FALSE(coarse_in(fields)) << far;
  }
}

TEST(CoarseCoordinates, AreSeenInTheShortestTextOf32Bits) {
  const TriMesh sheet = rounded(moved(meshes::bent_cylinder(8), 2.4, {4e5, 3e5, 20.0}), as_float);
  const auto coarse = coarse_in(printed(sheet, 9));
  ASSERT_TRUE(coarse);
  EXPECT_EQ(coarse->step, k_step);
  const auto of_text = coarse_in(rounded(
      sheet, [](double x) { return std::stod(std::to_string(std::round(100.0 * x) / 100.0)); }));
  ASSERT_TRUE(of_text) << "31 mm, written to centimetres";
}

TEST(CoarseCoordinates, AreNotTheGridOfADesign) {
  // Turned by the angle of 3, 4 and 5, with whole numbers and one decimal.
  for (const double unit : {1.0, 0.1, 10.0, 0.5}) {
    for (const double far : {1e4, 1e5, 4e5, 5648123.0}) {
      TriMesh grid = meshes::flat_grid(7, 5);
      for (Vec3& p : grid.positions)
        p = {unit * (3.0 * p.x - 4.0 * p.y), unit * (4.0 * p.x + 3.0 * p.y), 0.0};
      EXPECT_FALSE(coarse_in(rounded(moved(grid, 1.0, {far, far, 0.0}),
                                     [](double x) { return std::round(10.0 * x) / 10.0; })))
          << unit << " at " << far;
    }
  }
  TriMesh irregular = meshes::grid_with_random_diagonals(9, 9);
  for (Vec3& p : irregular.positions)
    p = {412300.0 + 0.7 * p.x, 412300.0 + 0.5 * p.y, 0.0};
  EXPECT_FALSE(coarse_in(rounded(irregular, [](double x) { return std::round(10.0 * x) / 10.0; })))
      << "divided at random";
  TriMesh uneven = meshes::flat_grid(5, 1);  // fields of 50, 75, 100 ... mm
  for (Vec3& p : uneven.positions)
    p = {412350.0 + 37.5 * p.x + 12.5 * p.x * p.x, 100.0 * p.y, 0.0};
  EXPECT_FALSE(coarse_in(uneven));
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
