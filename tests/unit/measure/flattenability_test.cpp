#include <cmath>
#include <numbers>

#include <planish/measure/deviation.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "oracle/plain.h"
#include "support/meshes.h"

namespace planish {
namespace {

using std::numbers::pi;

Flattenability figures_of(const TriMesh& mesh) {
  return measure(Patch(mesh));
}

TEST(Size, OfATubeOfFlatStrips) {
  TriMesh tube = meshes::tube(4, 3);           // a square of side sqrt 2 around the z axis, 3 high
  tube.positions.push_back({50.0, 0.0, 0.0});  // used by no triangle
  const PatchSize size = measure_size(Patch(tube));
  EXPECT_NEAR(size.extent.x, 2.0, 1e-15);
  EXPECT_NEAR(size.extent.y, 2.0, 1e-15);
  EXPECT_EQ(size.extent.z, 3.0);
  EXPECT_NEAR(size.area, 12.0 * std::numbers::sqrt2, 1e-14);
  EXPECT_NEAR(size.border_length, 8.0 * std::numbers::sqrt2, 1e-14);
}

TEST(Size, OfHugeAndTinyPatchesHasTheSameDigits) {
  const TriMesh mesh = meshes::rough_grid(5, 4, 1);
  const PatchSize plain = measure_size(Patch(mesh));
  for (const double scale : {0x1p-300, 0x1p300}) {
    TriMesh other = mesh;
    for (Vec3& p : other.positions)
      p = scale * p;
    const PatchSize size = measure_size(Patch(other));
    EXPECT_NEAR(size.extent.x / scale, plain.extent.x, 1e-14);
    EXPECT_NEAR(size.area / scale / scale, plain.area, 1e-13);
    EXPECT_NEAR(size.border_length / scale, plain.border_length, 1e-13);
  }
}

TEST(AngleDefects, OfACubeCornerIsAQuarterTurn) {
  TriMesh corner = meshes::fan(3);
  corner.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_NEAR(angle_defects(Patch(corner))[0], 0.5 * pi, 1e-15);
}

TEST(AngleDefects, FarBelowZeroWhereTheStarIsRuffled) {
  // A sum beyond 4 pi: turns must be counted.
  const TriMesh mesh = meshes::ruffled_fan(24, 4.0);
  const plain::Patch patch(mesh);
  const double defect = angle_defects(Patch(mesh))[0];
  EXPECT_LT(defect, -2.0 * pi);
  EXPECT_NEAR(defect, patch.defect(0), 1e-12);
}

TEST(AngleDefects, AgreeWithSumsOfArctangents) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const TriMesh mesh = meshes::rough_grid(9, 7, seed);
    const plain::Patch patch(mesh);
    const auto defects = angle_defects(Patch(mesh));
    for (Index v = 0; v < mesh.positions.size(); ++v) {
      ASSERT_NEAR(defects[v], patch.inner[v] ? patch.defect(v) : 0.0, 1e-13) << seed << " " << v;
    }
  }
}

TEST(AngleDefects, AndBorderTurningsAddUpToEulersCharacteristic) {
  // Gauss-Bonnet, on surfaces of every kind.
  const auto total = [](const TriMesh& mesh) {
    const plain::Patch patch(mesh);
    const Patch surface(mesh);
    double sum = 0.0;
    for (const double d : angle_defects(surface))
      sum += d;
    for (const auto& loop : surface.border_loops()) {
      for (const Index v : loop)
        sum += pi - patch.angle_sum(v);
    }
    return sum / (2.0 * pi);
  };
  EXPECT_NEAR(total(meshes::rough_grid(8, 8, 3)), 1.0, 1e-12);
  EXPECT_NEAR(total(meshes::tube(7, 4)), 0.0, 1e-12);
  EXPECT_NEAR(total(meshes::torus(9, 11)), 0.0, 1e-12);
  EXPECT_NEAR(total(meshes::tetrahedron()), 2.0, 1e-12);
  for (const Shape& shape : shapes()) {
    EXPECT_NEAR(total(make_shape(shape.name, 700)), 1.0, 1e-12) << shape.name;
  }
}

TEST(Measure, SumsAsThePaperDoesOverInnerVerticesOnly) {
  const TriMesh mesh = meshes::rough_grid(6, 5, 11);
  const plain::Patch patch(mesh);
  double largest = 0.0, sum = 0.0, squares = 0.0, count = 0.0;
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    if (!patch.inner[v]) continue;
    const double d = std::abs(patch.defect(v));
    largest = std::max(largest, d);
    sum += d;
    squares += d * d;
    ++count;
  }
  const Flattenability figures = figures_of(mesh);
  EXPECT_NEAR(figures.e_max, largest, 1e-13);
  EXPECT_NEAR(figures.e_avg, sum / count, 1e-13);
  EXPECT_NEAR(figures.energy, squares, 1e-12);
  EXPECT_NEAR(figures.sum_abs_defect, sum, 1e-12);
}

TEST(Measure, WithoutInnerVerticesIsZeroAndNotNaN) {
  const Flattenability figures = figures_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  EXPECT_EQ(figures.e_max, 0.0);
  EXPECT_EQ(figures.e_avg, 0.0);
  EXPECT_EQ(figures.roughness, 0.0);
  EXPECT_NEAR(figures.min_angle, 0.25 * pi, 1e-15);
}

TEST(Measure, RoughnessIsTheRmsAngleBetweenNeighbouringTriangles) {
  // Two triangles folded by 30 degrees along their one inner edge.
  const double fold = pi / 6.0;
  const TriMesh book{{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -std::cos(fold), std::sin(fold)}},
                     {{0, 1, 2}, {1, 0, 3}}};
  EXPECT_NEAR(figures_of(book).roughness, 30.0, 1e-12);
  EXPECT_EQ(figures_of(meshes::flat_grid(5, 5)).roughness, 0.0);
}

TEST(Measure, TellsTheSmallestAngleOfANeedle) {
  TriMesh needle{{{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}}, {{0, 1, 2}}};
  EXPECT_NEAR(figures_of(needle).min_angle, 2e-9, 1e-22);
  needle.positions[2].y = 0.0;
  EXPECT_EQ(figures_of(needle).min_angle, 0.0);
}

TEST(Measure, DoesNotDependOnSize) {
  TriMesh mesh = meshes::rough_grid(8, 8, 5);
  const Flattenability figures = figures_of(mesh);
  for (const double size : {0x1p-600, 0x1p+600, 0x1p-100}) {
    TriMesh scaled = mesh;
    for (Vec3& p : scaled.positions)
      p = size * p;
    EXPECT_EQ(figures_of(scaled).energy, figures.energy) << size;
    EXPECT_EQ(figures_of(scaled).roughness, figures.roughness) << size;
  }
  for (Vec3& p : mesh.positions)
    p = 1e-30 * p;
  EXPECT_NEAR(figures_of(mesh).energy, figures.energy, 1e-12 * figures.energy);
}

TEST(Measure, FlattenableMeansADiskWithNextToNoCurvature) {
  const auto flattenable = [](const TriMesh& mesh) {
    return is_flattenable(figures_of(mesh), inspect(mesh));
  };
  EXPECT_TRUE(flattenable(make_shape("cylinder", 400)));
  EXPECT_TRUE(flattenable(meshes::flat_grid(4, 4)));
  EXPECT_FALSE(flattenable(make_shape("dome", 400)));
  EXPECT_FALSE(flattenable(meshes::tube(8, 4))) << "a tube has to be cut open";
  // On a fine mesh every single defect is small; the surface is as curved as before.
  const TriMesh fine = make_shape("saddle", 60'000);
  EXPECT_LT(figures_of(fine).e_max, k_flattenable_e_max);
  EXPECT_FALSE(flattenable(fine));
}

TEST(MeasureDeviation, IsTheDistanceOfInnerVertices) {
  const TriMesh mesh = meshes::flat_grid(3, 2);  // two inner vertices: 5 and 6
  std::vector<Vec3> after = mesh.positions;
  after[5] += {0.0, 0.3, 0.4};
  const Deviation deviation = measure_deviation(Patch(mesh), after);
  EXPECT_NEAR(deviation.max, 0.5, 1e-15);
  EXPECT_NEAR(deviation.rms, 0.5 / std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(deviation.rms_over_diagonal, deviation.rms / std::sqrt(13.0), 1e-15);
}

TEST(Measure, ShowsANaNInsteadOfHidingIt) {
  const std::vector<double> defects{0.1, std::nan(""), 0.2};
  EXPECT_TRUE(std::isnan(summarise_defects(defects, 3).e_max));
}

TEST(Measure, ScalesASmallPatchFarOutWithoutLosingItsPlace) {
  TriMesh mesh = meshes::flat_grid(3, 3);
  for (Vec3& p : mesh.positions)
    p = {1e-100 * p.x, 1e-100 * p.y, 1e300};
  EXPECT_TRUE(std::isfinite(unit_scale(mesh) * 1e300));
  EXPECT_TRUE(std::isfinite(figures_of(mesh).energy));
}

}  // namespace
}  // namespace planish
