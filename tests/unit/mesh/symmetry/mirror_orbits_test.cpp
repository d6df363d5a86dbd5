#include <algorithm>
#include <set>

#include <planish/mesh/inspect.h>
#include <planish/mesh/shapes.h>
#include <planish/mesh/symmetry.h>

#include <gtest/gtest.h>

#include "mesh/symmetry/coarsen_mirrored.h"
#include "support/meshes.h"

namespace planish {
namespace {

const Plane k_skew{{0.9, 0.2, -0.1}, 3.0};

struct Mirrored {
  SymmetricMesh made = symmetric_mesh(Patch(make_shape("panel", 1200)), k_skew, MirrorSide::above);
  Patch patch{made.mesh};
  MirrorOrbits orbits = mirror_orbits(made.mesh, symmetry_in(patch, k_skew));
};

TEST(MirrorOrbits, HaveEachVertexWithItsImage) {
  const Mirrored mirrored;
  const MirrorOrbits& orbits = mirrored.orbits;
  ASSERT_TRUE(orbits.is_symmetric());
  std::size_t on_plane = 0;
  for (Index v = 0; v < mirrored.patch.vertex_count(); ++v) {
    const Index w = mirrored.made.image[v];
    EXPECT_EQ(orbits.image(v), w);
    EXPECT_EQ(orbits.orbit_of(v), orbits.orbit_of(w));
    EXPECT_EQ(orbits.first_of(orbits.orbit_of(v)), orbits.is_below(v) ? w : v);
    EXPECT_EQ(orbits.is_on_plane(v), v == w);
    on_plane += v == w ? 1 : 0;
    const Vec3 a = {0.3, -2.0, 0.7}, b = orbits.carried(v, a);
    EXPECT_LT(norm(orbits.carried(v, b) - (v == w ? b : a)), 1e-15);
  }
  EXPECT_EQ(2 * orbits.count(mirrored.patch.vertex_count()),
            mirrored.patch.vertex_count() + on_plane);
}

TEST(MirrorOrbits, NeedImagesOfTriangles) {
  // Squares with a diagonal each, all in one direction: vertices alone have images.
  const TriMesh grid = meshes::flat_grid(4, 4);
  const Symmetry symmetry = symmetry_in(Patch(grid), Plane{{1.0, 0.0, 0.0}, 2.0});
  ASSERT_FALSE(symmetry.image.empty());
  EXPECT_FALSE(mirror_orbits(grid, symmetry).is_symmetric());
  EXPECT_EQ(MirrorOrbits().orbit_of(7), 7U);
}

TEST(MirrorOrbits, HaveTheSidesOfASlitAlongThePlane) {
  const Mirrored whole;
  const std::vector<Vec3>& places = whole.made.mesh.positions;
  double low = 0.0, high = 0.0;
  for (Index v = 0; v < places.size(); ++v) {
    if (!whole.orbits.is_on_plane(v)) continue;
    low = std::min(low, places[v].y);
    high = std::max(high, places[v].y);
  }
  TriMesh slit = whole.made.mesh;
  std::vector<Index> copy_of(places.size());
  for (Index v = 0; v < places.size(); ++v) {
    copy_of[v] = v;
    if (!whole.orbits.is_on_plane(v) || !(places[v].y < 0.5 * (low + high))) continue;
    copy_of[v] = static_cast<Index>(slit.positions.size());
    slit.positions.push_back(places[v]);
  }
  ASSERT_GT(slit.positions.size(), places.size() + 5);
  for (Triangle& t : slit.triangles) {
    if (std::none_of(t.begin(), t.end(), [&](Index v) { return whole.orbits.is_below(v); }))
      continue;
    for (Index& v : t)
      v = copy_of[v];
  }
  const MirrorOrbits orbits = mirror_orbits(slit, symmetry_in(Patch(slit), k_skew));
  ASSERT_TRUE(orbits.is_symmetric());
  for (Index v = 0; v < places.size(); ++v) {
    if (copy_of[v] == v) continue;
    EXPECT_EQ(orbits.image(v), copy_of[v]);
    EXPECT_TRUE(orbits.is_below(copy_of[v]));
    EXPECT_FALSE(orbits.is_below(v));
  }
}

TEST(MirrorOrbits, MakeMovesSymmetric) {
  const Mirrored mirrored;
  meshes::Random random(3);
  std::vector<Vec3> moves;
  for (std::size_t v = 0; v < mirrored.patch.vertex_count(); ++v)
    moves.push_back(meshes::random_point(random, 1.0));
  const std::vector<Vec3> means = mirrored.orbits.symmetric(moves),
                          again = mirrored.orbits.symmetric(means);
  for (Index v = 0; v < means.size(); ++v) {
    const Vec3 image = mirrored.orbits.is_on_plane(v)
                           ? mirrored.orbits.carried(v, means[v])
                           : planish::mirrored(Plane{mirrored.orbits.normal(), 0.0},
                                               means[mirrored.orbits.image(v)]);
    EXPECT_LT(norm(means[v] - image), 1e-15);
    EXPECT_LT(norm(means[v] - again[v]), 1e-15);
  }
}

TEST(MirrorOrbits, MakeTwoMovesMirrorImagesToTheBit) {
  const Plane upright{{1.0, 0.0, 0.0}, 0.0};
  meshes::Random random(5);
  for (int k = 0; k < 1000; ++k) {
    const Vec3 own = meshes::random_point(random, 1.0), other = meshes::random_point(random, 1e-3);
    EXPECT_EQ(symmetric_move(own, other, upright.normal),
              mirrored(upright, symmetric_move(other, own, upright.normal)));
  }
}

TEST(CoarsenMirrored, MakesPatchesThatAreTheirOwnMirrorImages) {
  const Mirrored fine;
  std::vector<unsigned char> keep(fine.patch.vertex_count(), 0);
  const Index kept = fine.patch.inner_vertices()[20];
  keep[kept] = keep[fine.made.image[kept]] = 1;
  const std::size_t wanted = fine.patch.vertex_count() / 4;
  const auto coarse =
      coarsen_mirrored(fine.patch, fine.orbits, wanted, CoarseBorder::thinned, keep);
  ASSERT_TRUE(coarse.has_value());
  EXPECT_NEAR(static_cast<double>(coarse->source.size()), static_cast<double>(wanted),
              0.15 * static_cast<double>(wanted));
  EXPECT_TRUE(std::is_sorted(coarse->source.begin(), coarse->source.end()));
  EXPECT_TRUE(std::binary_search(coarse->source.begin(), coarse->source.end(), kept));
  const Patch patch(coarse->mesh);
  EXPECT_FALSE(blocking_problem(patch.inspection(), Purpose::unfold));
  const MirrorOrbits orbits = mirror_orbits(coarse->mesh, symmetry_in(patch, k_skew));
  ASSERT_TRUE(orbits.is_symmetric());
  const MirrorOrbits part = fine.orbits.of_part(coarse->source);
  for (Index v = 0; v < patch.vertex_count(); ++v) {
    EXPECT_EQ(part.image(v), orbits.image(v));
    EXPECT_EQ(part.orbit_of(v), orbits.orbit_of(v));
  }
}

TEST(CoarsenMirrored, LeavesOthersAlone) {
  const Patch panel(make_shape("panel", 300));
  EXPECT_FALSE(coarsen_mirrored(panel, {}, 100, CoarseBorder::thinned).has_value());
}

}  // namespace
}  // namespace planish
