#include <array>
#include <cmath>
#include <vector>

#include <planish/mesh/symmetry.h>
#include <planish/unfold/unfold.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

const Plane k_plane_between{{1.0, 0.0, 0.0}, 0.0};

void expect_symmetric(const SymmetricMesh& whole, const Plane& plane) {
  const Patch patch(whole.mesh);  // which is an oriented manifold
  for (std::size_t v = 0; v < whole.image.size(); ++v) {
    const Vec3 there = mirrored(plane, whole.mesh.positions[v]);
    EXPECT_LE(norm(there - whole.mesh.positions[whole.image[v]]), 1e-14);
  }
  EXPECT_EQ(symmetry_in(patch, plane).image, whole.image);
}

TEST(SymmetricMesh, OfASolidThatThePlaneCutsIsClosed) {
  for (const double offset : {0.0, 0.3}) {
    const Plane plane{{1.0, 0.2, 0.1}, offset};
    for (const MirrorSide side : {MirrorSide::above, MirrorSide::below}) {
      const SymmetricMesh whole = symmetric_mesh(Patch(solids::sphere(1.0, 9)), plane, side);
      expect_symmetric(whole, plane);
      EXPECT_TRUE(Patch(whole.mesh).border_loops().empty());
    }
  }
}

TEST(SymmetricMesh, KeepsTheBitsOfItsHalf) {
  TriMesh skew = meshes::height_field(6, 4, [](double x, double y) { return 0.1 * x * x + y; });
  for (Vec3& p : skew.positions)
    p.x -= 3.0;
  const SymmetricMesh whole = symmetric_mesh(Patch(skew), k_plane_between, MirrorSide::above);
  expect_symmetric(whole, k_plane_between);
  EXPECT_EQ(whole.mesh.positions.size(), skew.positions.size());
  EXPECT_EQ(whole.mesh.positions[0], skew.positions[3]);
  EXPECT_EQ(whole.mesh.positions[1], skew.positions[4]);
  EXPECT_EQ(whole.mesh.triangles.size(), skew.triangles.size());
}

TEST(SymmetricMesh, NeedsSomethingOnItsSide) {
  try {
    symmetric_mesh(Patch(meshes::flat_grid(3, 3)), k_plane_between, MirrorSide::below);
    FAIL() << "made of nothing";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::misplaced_cut);
  }
}

TEST(SymmetricMesh, HasAPatternThatIsItsOwnMirrorImage) {
  TriMesh bump = meshes::height_field(
      9, 7, [](double x, double y) { return 0.03 * x * x - 0.05 * y * y + 0.004 * x * y; });
  const Plane plane{{1.0, 0.3, 0.0}, 4.0};
  const SymmetricMesh whole = symmetric_mesh(Patch(bump), plane, MirrorSide::above);
  const Patch patch(whole.mesh);
  for (const bool match_seams : {false, true}) {
    const Pattern pattern = unfold(
        patch, {.match_seams = match_seams, .match_if_possible = true, .symmetric_in = plane},
        {.threads = 1});
    EXPECT_EQ(pattern.flipped_triangles, 0U);
    // A mirror image keeps all distances.
    const std::vector<Vec2>& flat = pattern.positions;
    for (std::size_t v = 0; v < flat.size(); ++v) {
      for (std::size_t w = 0; w < v; w += 3) {
        EXPECT_NEAR(norm(flat[v] - flat[w]), norm(flat[whole.image[v]] - flat[whole.image[w]]),
                    1e-12);
      }
    }
  }
}

using Kind = MirrorPiece::Kind;

/// A strip from x = 1 to 3, its mirror image in other triangles and with noise, one across.
std::vector<TriMesh> pieces(double noise) {
  TriMesh right = meshes::height_field(4, 6, [](double x, double y) { return 0.1 * x * y; });
  TriMesh left = meshes::height_field(5, 7, [](double x, double y) { return x + 0.0 * y; });
  TriMesh across = meshes::flat_grid(3, 3);
  for (Vec3& p : right.positions)
    p = {1.0 + 0.5 * p.x, p.y, p.z};
  meshes::Random random(1);
  for (Vec3& p : left.positions) {
    const double x = 4.0 / 5.0 * p.x, y = 6.0 / 7.0 * p.y;
    p = {-1.0 - 0.5 * x, y, 0.1 * x * y + noise * random.number()};
  }
  for (Triangle& t : left.triangles)
    std::swap(t[1], t[2]);
  for (Vec3& p : across.positions)
    p = {p.x - 1.5, p.y, 1.0 + (p.x > 2.0 ? noise : 0.0)};
  return {left, across, right};
}

TEST(MirrorPieces, AreFoundByTheirPlacesWhateverTheirTriangles) {
  const std::vector<TriMesh> all = pieces(0.01);
  const auto found = mirror_pieces(all, k_plane_between, MirrorSide::above, 0.08);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].kind, Kind::image);
  EXPECT_EQ(found[0].of, 2U);
  EXPECT_EQ(found[2].kind, Kind::original);
  EXPECT_EQ(found[1].kind, Kind::across);
  EXPECT_GT(found[0].distance, 0.005);
  const auto other = mirror_pieces(all, k_plane_between, MirrorSide::below, 0.08);
  EXPECT_EQ(other[0].kind, Kind::original);
  EXPECT_EQ(other[2].of, 0U);
  const auto none = mirror_pieces(all, k_plane_between, MirrorSide::above, 1e-4);
  for (const MirrorPiece& piece : none)
    EXPECT_EQ(piece.kind, Kind::alone);
}

TEST(MirrorPieces, BecomeExactMirrorImages) {
  const std::vector<TriMesh> all = pieces(0.01);
  const auto found = mirror_pieces(all, k_plane_between, MirrorSide::above, 0.08);
  const auto exact = symmetric_pieces(all, found, k_plane_between, MirrorSide::above);
  EXPECT_EQ(exact[2].positions, all[2].positions);
  EXPECT_EQ(exact[0].positions, mirrored(k_plane_between, all[2]).positions);
  EXPECT_FALSE(symmetry_in(Patch(exact[1]), k_plane_between).image.empty());
  // What is exact stays as it is.
  const auto again = mirror_pieces(exact, k_plane_between, MirrorSide::below, 0.08);
  const auto same = symmetric_pieces(exact, again, k_plane_between, MirrorSide::below);
  for (std::size_t p = 0; p < 3; ++p) {
    EXPECT_EQ(same[p].positions, exact[p].positions);
    EXPECT_EQ(same[p].triangles, exact[p].triangles);
  }
}

}  // namespace
}  // namespace planish
