#include "evolve/ring_energy.h"

#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "oracle/plain.h"
#include "support/meshes.h"

namespace planish {
namespace {

/// Calls visit(ring, plain patch, vertex in the mesh) with ring looking at each inner vertex.
template <class Visit>
void for_each_ring(const TriMesh& mesh, Visit visit) {
  const plain::Patch patch(mesh);
  const Connectivity connectivity(mesh);
  const PatchState state(mesh, connectivity);
  RingEnergy ring;
  for (std::size_t v = 0; v < state.inner_count(); ++v) {
    ring.look_at(state, v);
    visit(ring, patch, state.vertex_of(v), state.scale());
  }
}

TEST(RingEnergy, AgreesWithThePlainOneToTwelveDigits) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for_each_ring(meshes::rough_grid(7, 6, seed), [](RingEnergy& ring, const plain::Patch& patch,
                                                     Index v, double scale) {
      const Vec3 x = patch.mesh.positions[v];
      EXPECT_NEAR(ring.energy(), patch.ring_energy(v, x), 1e-12);
      for (const Vec3 shift : {Vec3{0.1, 0.0, 0.2}, Vec3{-0.2, 0.3, -0.1}}) {
        EXPECT_NEAR(ring.evaluate_at(scale * (x + shift)), patch.ring_energy(v, x + shift), 1e-12);
      }
    });
  }
}

TEST(RingEnergy, HasThePapersLaplacian) {
  for_each_ring(meshes::rough_grid(6, 6, 4),
                [](RingEnergy& ring, const plain::Patch& patch, Index v, double scale) {
                  const Vec3 expected = scale * patch.laplacian(v);
                  EXPECT_NEAR(norm(ring.laplacian() - expected), 0.0, 1e-15);
                });
}

TEST(RingEnergy, AlongTheLineIsThePapersEquations15To17Corrected) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for_each_ring(meshes::rough_grid(7, 6, seed), [](RingEnergy& ring, const plain::Patch& patch,
                                                     Index v, double) {
      const Vec3 L = patch.laplacian(v);
      ring.set_line(ring.laplacian());
      for (const double lambda : {-0.5, 0.0, 0.2, 0.77, 1.0}) {
        const LinePoint ours = ring.along(lambda), expected = patch.along(v, L, lambda);
        EXPECT_NEAR(ours.value, expected.value, 1e-11);
        EXPECT_NEAR(ours.slope, expected.slope, 1e-9 * (1.0 + std::abs(expected.slope)));
        EXPECT_NEAR(ours.curvature, expected.curvature, 1e-9 * (1.0 + expected.curvature));
      }
    });
  }
}

TEST(RingEnergy, SlopeIsTheDifferenceQuotient) {
  constexpr double h = 1e-6;
  for (std::uint64_t seed = 20; seed < 30; ++seed) {
    for_each_ring(
        meshes::rough_grid(7, 6, seed), [](RingEnergy& ring, const plain::Patch&, Index, double) {
          ring.set_line(ring.laplacian());
          for (const double lambda : {-0.3, 0.0, 0.4, 0.9}) {
            const double difference =
                (ring.along(lambda + h).value - ring.along(lambda - h).value) / (2.0 * h);
            EXPECT_NEAR(ring.along(lambda).slope, difference, 1e-7 * (1.0 + std::abs(difference)));
          }
        });
  }
}

TEST(RingEnergy, LeavesBorderNeighboursOut) {
  // One inner vertex: its ring is all border, so only its own defect counts.
  for_each_ring(meshes::fan(6, 0.7),
                [](RingEnergy& ring, const plain::Patch& patch, Index v, double) {
                  EXPECT_NEAR(ring.energy(), patch.defect(v) * patch.defect(v), 1e-14);
                });
}

TEST(RingEnergy, HoldsEveryTermOfTheEnergyThatAMoveChanges) {
  const TriMesh mesh = meshes::rough_grid(6, 6, 8);
  for_each_ring(mesh, [](RingEnergy& ring, const plain::Patch& patch, Index v, double scale) {
    const Vec3 target = patch.mesh.positions[v] + Vec3{0.1, -0.2, 0.15};
    plain::Patch moved = patch;
    moved.mesh.positions[v] = target;
    const double before = ring.energy();
    EXPECT_NEAR(ring.evaluate_at(scale * target) - before, moved.energy() - patch.energy(), 1e-11);
  });
}

TEST(RingEnergy, WritesBackTheDefectsOfTheWholeRing) {
  const TriMesh mesh = meshes::rough_grid(6, 6, 9);
  const Connectivity connectivity(mesh);
  PatchState state(mesh, connectivity);
  RingEnergy ring;
  for (std::size_t v = 0; v < state.inner_count(); ++v) {
    ring.look_at(state, v);
    const Vec3 target = ring.start() + 0.3 * ring.laplacian();
    ring.evaluate_at(target);
    ring.move_to(target, state);
  }
  const plain::Patch moved({state.positions_in_mesh_order(), mesh.triangles});
  for (std::size_t v = 0; v < state.inner_count(); ++v) {
    EXPECT_NEAR(state.defect(v), moved.defect(state.vertex_of(v)), 1e-13);
  }
}

TEST(RingEnergy, KeepsAnglesAboveTheLimitOrWhatTheyAre) {
  const TriMesh mesh = meshes::fan(6);
  const Connectivity connectivity(mesh);
  const PatchState state(mesh, connectivity);
  RingEnergy ring;
  ring.look_at(state, 0);
  const double degree = std::numbers::pi / 180.0, scale = state.scale();
  const Vec3 near_a_corner{0.95 * scale, 0.0, 0.0};  // thin triangles of about 2.6 degrees
  EXPECT_TRUE(ring.keeps_angles(near_a_corner, 1.0 * degree));
  EXPECT_FALSE(ring.keeps_angles(near_a_corner, 10.0 * degree));
  EXPECT_TRUE(ring.keeps_angles(ring.start(), 90.0 * degree));
}

}  // namespace
}  // namespace planish
