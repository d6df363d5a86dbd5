#include "support/twins.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "mesh/match/twins.h"
#include "support/meshes.h"

namespace planish {
namespace {

using meshes::in_floats;
using meshes::mirrored;
using meshes::renumbered;
using meshes::turned;

std::optional<MeshTwin> twin(const TriMesh& first, const TriMesh& second,
                             double tolerance = k_twin_tolerance) {
  const std::vector<const TriMesh*> both = {&first, &second};
  auto found = find_twins(both, tolerance);
  EXPECT_EQ(found.size(), 2U);
  EXPECT_FALSE(found[0]);
  return found[1];
}

/// A triangle by its corners from the smallest on.
Triangle from_smallest(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// Every vertex has a partner of its own, triangles correspond, and the motion brings them
/// together.
void expect_match(const MeshMatch& match, const TriMesh& first, const TriMesh& second,
                  double tolerance) {
  ASSERT_EQ(match.vertex.size(), first.positions.size());
  std::vector<Index> sorted = match.vertex;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t v = 0; v < sorted.size(); ++v)
    ASSERT_EQ(sorted[v], v);
  std::vector<Triangle> expected, found;
  for (const Triangle& t : first.triangles) {
    Triangle image = {match.vertex[t[0]], match.vertex[t[1]], match.vertex[t[2]]};
    if (match.mirrored) std::swap(image[1], image[2]);
    expected.push_back(from_smallest(image));
  }
  for (const Triangle& t : second.triangles)
    found.push_back(from_smallest(t));
  std::sort(expected.begin(), expected.end());
  std::sort(found.begin(), found.end());
  EXPECT_EQ(expected, found);
  for (std::size_t v = 0; v < first.positions.size(); ++v) {
    EXPECT_LE(norm(match.motion(first.positions[v]) - second.positions[match.vertex[v]]), tolerance)
        << v;
  }
}

TEST(Twins, AreFoundWhereverTheyLieAndHoweverTheyAreNumbered) {
  const TriMesh rough = meshes::rough_grid(9, 7, 3);
  const TriMesh mirror = in_floats(renumbered(turned(mirrored(rough))));
  const auto found = twin(rough, mirror);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->of, 0U);
  EXPECT_TRUE(found->match.mirrored);
  expect_match(found->match, rough, mirror, 2e-6);
  const TriMesh copy = in_floats(renumbered(turned(rough)));
  const auto equal = twin(rough, copy);
  ASSERT_TRUE(equal);
  EXPECT_FALSE(equal->match.mirrored);
  expect_match(equal->match, rough, copy, 2e-6);
}

TEST(Twins, OfTheTwoSidesOfAModelHaveAnExactMotion) {
  const TriMesh rough = meshes::rough_grid(6, 5, 4);
  TriMesh mirror = renumbered(mirrored(rough));
  for (Vec3& p : mirror.positions)
    p.x += 0.25;
  const auto found = twin(rough, mirror);
  ASSERT_TRUE(found);
  const RigidMotion& motion = found->match.motion;
  EXPECT_EQ(motion.rows[0], (Vec3{-1.0, 0.0, 0.0}));
  EXPECT_EQ(motion.rows[1], (Vec3{0.0, 1.0, 0.0}));
  EXPECT_EQ(motion.rows[2], (Vec3{0.0, 0.0, 1.0}));
  EXPECT_NEAR(motion.shift.x, 0.25, 1e-15);
}

TEST(Twins, AreAlikeAtAnySize) {
  const TriMesh rough = meshes::rough_grid(5, 4, 5);
  for (const double size : {std::ldexp(1.0, -400), 1.0, std::ldexp(1.0, 400)}) {
    TriMesh first = rough, second = renumbered(turned(mirrored(rough)));
    for (Vec3& p : first.positions)
      p = size * p;
    for (Vec3& p : second.positions)
      p = size * p;
    const auto found = twin(first, second);
    ASSERT_TRUE(found) << size;
    expect_match(found->match, first, second, 1e-12 * size);
    EXPECT_FALSE(twin(first, rough).has_value() && size != 1.0);
  }
}

TEST(Twins, AreNotWhatDiffersInOnePlace) {
  const TriMesh rough = meshes::rough_grid(9, 7, 3);
  const double diagonal = bounding_box_diagonal(rough);
  for (const Index v : {Index{0}, Index{34}}) {  // of the border, and inside
    TriMesh other = mirrored(rough);
    other.positions[v].z += 4e-5 * diagonal;
    EXPECT_FALSE(twin(rough, other)) << v;
    other.positions[v].z -= 3.8e-5 * diagonal;
    EXPECT_TRUE(twin(rough, other)) << v;
  }
}

TEST(Twins, HaveTheSameTriangles) {
  const TriMesh rough = meshes::rough_grid(4, 4, 6);
  TriMesh other = mirrored(rough);
  // The other diagonal of a cell.
  const auto [a, b, c] = rough.triangles[10];
  const Index d = rough.triangles[11][2];
  ASSERT_EQ(rough.triangles[11][0], a);
  other.triangles[10] = {a, d, b};
  other.triangles[11] = {b, d, c};
  EXPECT_FALSE(twin(rough, other));
}

TEST(Twins, AreNotWhatIsBentTheOtherWay) {
  // The same lengths of all edges, in the same order; a dome and a bowl.
  const TriMesh dome = meshes::height_field(6, 5, [](double x, double y) {
    return 0.05 * (x - 2.0) * (x - 2.0) + 0.03 * (y - 3.0) * (y - 3.0) + 0.01 * x * y;
  });
  TriMesh bowl = dome;
  for (Vec3& p : bowl.positions)
    p.z = -p.z;
  EXPECT_FALSE(twin(dome, bowl));
  TriMesh turned_over = bowl;  // the mirror image of the dome in the ground
  for (Triangle& t : turned_over.triangles)
    std::swap(t[1], t[2]);
  const auto found = twin(dome, turned_over);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->match.mirrored);
}

TEST(Twins, OfSymmetricalPatchesAreEqualRatherThanMirrored) {
  const TriMesh fan = meshes::fan(8, 0.4);
  for (const TriMesh& other : {fan, mirrored(fan), renumbered(turned(fan))}) {
    const auto found = twin(fan, other);
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->match.mirrored);
    expect_match(found->match, fan, other, 1e-12);
    EXPECT_EQ(twin(fan, other)->match.vertex, found->match.vertex);
  }
}

TEST(Twins, MayHaveOneTriangleOrNone) {
  const TriMesh one{{{0, 0, 0}, {3, 0, 0}, {1, 1, 2.5}}, {{0, 1, 2}}};
  const auto found = twin(one, renumbered(turned(mirrored(one))));
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->match.mirrored);
  ASSERT_TRUE(twin(one, turned(one)));
  EXPECT_FALSE(twin(one, turned(one))->match.mirrored);
  EXPECT_FALSE(twin({}, {}));
  const TriMesh needle{{{0, 0, 0}, {3, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}};
  ASSERT_TRUE(twin(needle, turned(needle)));
}

TEST(Twins, MayHaveHoles) {
  TriMesh mesh = make_shape("saddle", 300);
  for (const std::size_t t : {300U, 120U})
    mesh.triangles.erase(mesh.triangles.begin() + t);
  for (const bool is_mirrored : {false, true}) {
    const TriMesh other = renumbered(turned(is_mirrored ? mirrored(mesh) : mesh));
    const auto found = twin(mesh, other);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->match.mirrored, is_mirrored);
    expect_match(found->match, mesh, other, 1e-9);
  }
}

TEST(Twins, AreNotLookedForInWhatIsNoPatch) {
  const TriMesh closed = meshes::tetrahedron();
  EXPECT_FALSE(twin(closed, closed));
  TriMesh wrong = meshes::flat_grid(2, 2);
  wrong.triangles[0][0] = 99;
  EXPECT_FALSE(twin(wrong, wrong));
  TriMesh nowhere = meshes::flat_grid(2, 2);
  nowhere.positions[4].x = std::nan("");
  EXPECT_FALSE(twin(nowhere, nowhere));
}

TEST(Twins, AreOfTheFirstOfTheirKind) {
  const TriMesh a = meshes::rough_grid(5, 5, 1), b = meshes::rough_grid(5, 5, 2);
  const TriMesh a2 = mirrored(a), b2 = turned(mirrored(b)), a3 = turned(a);
  const std::vector<const TriMesh*> all = {&a, &b, &a2, &b2, &a3};
  const auto twins = find_twins(all);
  EXPECT_FALSE(twins[0]);
  EXPECT_FALSE(twins[1]);
  EXPECT_EQ(twins[2].value().of, 0U);
  EXPECT_EQ(twins[3].value().of, 1U);
  EXPECT_EQ(twins[4].value().of, 0U);
  EXPECT_FALSE(twins[4]->match.mirrored);
}

TEST(Twins, SearchCanBeCancelled) {
  const TriMesh a = meshes::rough_grid(5, 5, 1);
  const std::vector<const TriMesh*> all = {&a, &a, &a};
  int asked = 0;
  EXPECT_THROW(find_twins(all, k_twin_tolerance, {.is_cancelled = [&] { return ++asked > 2; }}),
               Cancelled);
  EXPECT_EQ(asked, 3);
}

TEST(Twins, OfMeshesThatLookAlikeEverywhereTakeNoSquareOfTheirSize) {
  // A strip of equal triangles, and the same with one place in the middle of its border moved:
  // every start along the border goes far.
  const TriMesh strip = meshes::flat_grid(60'000, 1);
  TriMesh other = strip;
  other.positions[30'000].y -= 0.4 * 60.0;
  other.positions[30'001].y -= 0.4 * 60.0;
  EXPECT_FALSE(twin(strip, other));
}

}  // namespace
}  // namespace planish
