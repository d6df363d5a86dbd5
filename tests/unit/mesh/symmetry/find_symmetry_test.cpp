#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <planish/mesh/cut.h>
#include <planish/mesh/imprint.h>
#include <planish/mesh/symmetry.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/solids.h"
#include "support/twins.h"

namespace planish {
namespace {

/// Symmetric in x = 6 alone, vertex by vertex, but not triangle by triangle.
TriMesh saddle_of(double skew = 0.0) {
  return meshes::height_field(12, 9, [skew](double x, double y) {
    return 0.05 * (x - 6.0) * (x - 6.0) + 0.02 * y * y + skew * (x - 6.0) * y;
  });
}

/// A gabled house whose walls have their vertices anywhere: the surface is symmetric in x = 0
/// alone, no vertex on its walls has an image.
TriMesh house() {
  const Vec3 a{-2, 0, 0}, b{2, 0, 0}, c{2, 3, 0}, d{-2, 3, 0};
  const Vec3 e{-2, 0, 1}, f{2, 0, 1}, g{2, 4, 1}, h{-2, 4, 1};
  const Vec3 front{0, 0, 2}, back{0, 4.5, 2.5}, on_wall{2, 1.3, 0.4}, on_other{-2, 0.7, 0.6};
  TriMesh mesh{{a, b, c, d, e, f, g, h, front, back, on_wall, on_other}, {}};
  mesh.triangles = {{0, 2, 1},  {0, 3, 2},  {0, 1, 4},  {1, 5, 4},  {4, 5, 8},
                    {3, 6, 2},  {3, 7, 6},  {7, 9, 6},  {5, 6, 9},  {5, 9, 8},
                    {4, 9, 7},  {4, 8, 9},  {1, 2, 10}, {2, 6, 10}, {6, 5, 10},
                    {5, 1, 10}, {0, 4, 11}, {4, 7, 11}, {7, 3, 11}, {3, 0, 11}};
  return mesh;
}

void expect_plane(const Symmetry& symmetry, Vec3 normal, Vec3 through, double tolerance) {
  const Vec3 found = symmetry.plane.normal;
  EXPECT_NEAR(norm(found), 1.0, 1e-12);
  EXPECT_LE(std::min(norm(found - normal), norm(found + normal)), tolerance);
  EXPECT_NEAR(height_over(symmetry.plane, through), 0.0, tolerance);
}

/// Where meshes::turned() brings a place, and a direction.
Vec3 turned(Vec3 p) {
  return meshes::turned({{p}, {}}).positions[0];
}
Vec3 direction(Vec3 d) {
  return turned(d) - turned({});
}

TEST(Symmetry, HasMirrorImagesThatAreExactAcrossAxes) {
  const Plane plane{{1.0, 0.0, 0.0}, 0.0};
  const Vec3 p{0.1, 0.7, -1.0 / 3.0};
  EXPECT_EQ(mirrored(plane, p), (Vec3{-0.1, 0.7, -1.0 / 3.0}));
  const Plane slanted{{3.0, 4.0, 0.0}, 10.0};
  EXPECT_NEAR(height_over(slanted, {6.0, 8.0, 5.0}), 8.0, 1e-12);
  EXPECT_NEAR(norm(foot_on(slanted, {6.0, 8.0, 5.0}) - Vec3{1.2, 1.6, 5.0}), 0.0, 1e-12);
  EXPECT_NEAR(norm(mirrored(slanted, {6.0, 8.0, 5.0}) - Vec3{-3.6, -4.8, 5.0}), 0.0, 1e-12);
}

TEST(Symmetry, IsFoundInTurnedMeshesWithVertexImages) {
  const TriMesh mesh = meshes::turned(saddle_of());
  const Symmetry symmetry = find_symmetry(Patch(mesh));
  expect_plane(symmetry, direction({1.0, 0.0, 0.0}), turned({6.0, 0.0, 0.0}), 1e-9);
  EXPECT_LE(symmetry.largest, 1e-9);
  ASSERT_EQ(symmetry.image.size(), mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_EQ(symmetry.image[symmetry.image[v]], v);
    EXPECT_LE(norm(mirrored(symmetry.plane, mesh.positions[v]) - mesh.positions[symmetry.image[v]]),
              1e-9);
  }
  EXPECT_EQ(symmetry.image[0], 12U);
  EXPECT_EQ(symmetry.image[6], 6U);
}

TEST(Symmetry, IsFoundWhereOnlyTheSurfaceHasIt) {
  const Symmetry symmetry = find_symmetry(Patch(meshes::turned(house())));
  expect_plane(symmetry, direction({1.0, 0.0, 0.0}), turned({}), 1e-9);
  EXPECT_LE(symmetry.largest, 1e-9);
  EXPECT_TRUE(symmetry.image.empty());
}

TEST(Symmetry, LiesAcrossAnAxisAndThroughTheOriginWhereItCan) {
  TriMesh mesh = house();
  const Symmetry symmetry = find_symmetry(Patch(mesh));
  EXPECT_EQ(symmetry.plane.normal, (Vec3{1.0, 0.0, 0.0}));
  EXPECT_EQ(symmetry.plane.offset, 0.0);
  const Symmetry cube = find_symmetry(Patch(solids::cube()));
  EXPECT_EQ(cube.plane.normal, (Vec3{1.0, 0.0, 0.0}));
  EXPECT_EQ(cube.largest, 0.0);
}

TEST(Symmetry, OfNoisyMeshesIsFoundWithinTheNoise) {
  constexpr double noise = 0.01;
  TriMesh mesh = saddle_of();
  meshes::Random random(5);
  for (Vec3& p : mesh.positions)
    p += meshes::random_point(random, noise);
  const Symmetry symmetry = find_symmetry(Patch(meshes::turned(mesh)));
  expect_plane(symmetry, direction({1.0, 0.0, 0.0}), turned({6.0, 4.0, 0.5}), noise);
  EXPECT_LE(symmetry.largest, 6.0 * noise);
  EXPECT_GT(symmetry.rms, 0.1 * noise);
  EXPECT_LT(symmetry.rms, symmetry.largest);
  EXPECT_NO_THROW(require_symmetric(Patch(mesh), symmetry));
}

TEST(Symmetry, OfTurnedSolidsWithSeveralPlanesIsOneOfThem) {
  const TriMesh cube = meshes::turned(solids::cube());
  EXPECT_LE(find_symmetry(Patch(cube)).largest, 1e-9);
  const TriMesh prism = meshes::turned(solids::star_prism());
  EXPECT_LE(find_symmetry(Patch(prism)).largest, 1e-9);
}

TEST(Symmetry, OfASphereIsAlwaysTheSame) {
  const Symmetry whole = find_symmetry(Patch(solids::sphere(3.0, 8)));
  expect_plane(whole, {1.0, 0.0, 0.0}, {}, 1e-12);
  TriMesh turned_sphere = meshes::turned(solids::sphere(3.0, 12));
  const Symmetry one = find_symmetry(Patch(turned_sphere));
  const Symmetry again = find_symmetry(Patch(meshes::renumbered(turned_sphere)));
  EXPECT_LE(one.largest, 0.1);  // of the chords of its triangles
  EXPECT_LE(norm(one.plane.normal - again.plane.normal), 0.1);
}

TEST(Symmetry, OfAFlatMeshIsNotItsOwnPlane) {
  const Symmetry symmetry = find_symmetry(Patch(meshes::turned(meshes::flat_grid(8, 5))));
  EXPECT_NEAR(dot(symmetry.plane.normal, direction({0.0, 0.0, 1.0})), 0.0, 1e-9);
  EXPECT_LE(symmetry.largest, 1e-9);
  EXPECT_FALSE(symmetry.image.empty());
}

TEST(Symmetry, ThatIsMissingIsToldWithItsDistance) {
  const Patch patch(saddle_of(0.1));
  const Symmetry symmetry = find_symmetry(patch);
  EXPECT_GT(symmetry.largest, symmetry_tolerance(patch.mesh()));
  try {
    require_symmetric(patch, symmetry);
    FAIL() << "taken for symmetric";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::not_symmetric);
    EXPECT_NE(error.message().find("of its diagonal"), std::string::npos) << error.message();
  }
}

TEST(Symmetry, InAGivenPlaneIsMeasuredThere) {
  const Patch patch(solids::cube());
  const Symmetry shifted = symmetry_in(patch, {{2.0, 0.0, 0.0}, 0.2});
  EXPECT_EQ(shifted.plane.normal, (Vec3{1.0, 0.0, 0.0}));
  EXPECT_NEAR(shifted.plane.offset, 0.1, 1e-15);
  EXPECT_NEAR(shifted.largest, 0.2, 1e-12);
  EXPECT_TRUE(shifted.image.empty());
  EXPECT_EQ(symmetry_in(patch, {{0.0, -1.0, 0.0}, 0.0}).image[0], 2U);
}

TEST(Symmetry, RefusesWhatIsNoPlaneAndNoMesh) {
  const Patch patch(solids::cube());
  for (const Plane plane : {Plane{{0.0, 0.0, 0.0}, 0.0}, Plane{{1.0, 0.0, 0.0}, std::nan("")},
                            Plane{{std::numeric_limits<double>::infinity(), 0.0, 0.0}, 0.0}}) {
    try {
      symmetry_in(patch, plane);
      FAIL() << "taken for a plane";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::option_out_of_range);
    }
  }
  TriMesh broken = solids::cube();
  broken.positions[3].y = std::nan("");
  EXPECT_THROW(find_symmetry(Patch(broken)), Error);
}

TEST(Symmetry, OfAMeshThatIsCutKnowsTheSidesOfTheCut) {
  const Patch whole(saddle_of());
  const std::vector<CutPath> dart = {{{6, 19, 32, 45}, {}}};
  const CutMesh cut = cut_open(whole, dart);
  const Symmetry symmetry = symmetry_in(Patch(cut.mesh), {{1.0, 0.0, 0.0}, 6.0});
  ASSERT_EQ(symmetry.image.size(), cut.mesh.positions.size());
  for (std::size_t v = whole.vertex_count(); v < cut.mesh.positions.size(); ++v)
    EXPECT_EQ(symmetry.image[v], cut.source[v]);
  EXPECT_EQ(symmetry.image[45], 45U);  // the tip
}

TEST(Symmetry, IsTheSameAtAllSizesAndFarAway) {
  TriMesh mesh = saddle_of();
  const Symmetry here = find_symmetry(Patch(mesh));
  const Symmetry small = find_symmetry(Patch(scaled(mesh, 0x1p-100)));
  EXPECT_EQ(small.plane.normal, here.plane.normal);
  EXPECT_EQ(small.plane.offset, 0x1p-100 * here.plane.offset);
  EXPECT_EQ(small.image, here.image);
  for (Vec3& p : mesh.positions)
    p.x += 4096.0;
  const Symmetry far = find_symmetry(Patch(mesh));
  EXPECT_EQ(far.image, here.image);
  EXPECT_NEAR(far.plane.offset, 4102.0, 1e-9);
}

}  // namespace
}  // namespace planish
