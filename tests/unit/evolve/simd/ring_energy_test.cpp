// Lanes of its own, so that nothing here is mixed up with what the library is made of.
#define PLANISH_ISA test_lanes
#define PLANISH_LANES 2
#include "evolve/simd/ring_energy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "evolve/state/patch_state.h"
#include "oracle/plain.h"
#include "support/meshes.h"

namespace planish {
namespace {

constexpr double k_no_limit = std::numeric_limits<double>::infinity();

Vec3 first_of(const test_lanes::Vector& v) {
  return {v.x[0], v.y[0], v.z[0]};
}

test_lanes::Vector in_all_lanes(Vec3 v) {
  return {test_lanes::broadcast(v.x), test_lanes::broadcast(v.y), test_lanes::broadcast(v.z)};
}

/// The kernel with one vertex in all its lanes.
class OneRing {
 public:
  /// @param visit which vertex, by its place in the plan
  OneRing(PatchState& state, std::size_t visit, double max_cotangent = k_no_limit)
      : star_(state.plan().star(*state.plan().run_of(visit), visit)),
        lanes_{&star_, &star_},
        ring_(state.sites().data(), lanes_, static_cast<int>(state.plan().run_of(visit)->valence)) {
    model_ = ring_.at_start(ring_.laplacian(), max_cotangent);
  }

  Vec3 start() const { return first_of(ring_.start()); }
  Vec3 laplacian() const { return first_of(ring_.laplacian()); }
  double energy() const { return model_.c[0][0]; }
  /// b by the model of the line.
  double model_at(double lambda) const { return model_.at(test_lanes::broadcast(lambda))[0]; }
  double coefficient(int power) const { return model_.c[power][0]; }
  double spread() const { return model_.spread[0]; }
  double evaluate_at(Vec3 x) { return ring_.at(in_all_lanes(x)).value[0]; }
  double evaluate_along(double lambda) { return evaluate_at(start() + lambda * laplacian()); }
  bool sound_at(Vec3 x) { return ring_.at(in_all_lanes(x)).sound[0] != 0; }
  void move_to(Vec3 x, PatchState& state) {
    evaluate_at(x);
    ring_.keep(test_lanes::Mask{} == test_lanes::Mask{});
    ring_.write(0, in_all_lanes(x), star_, state.sites().data(), state.changes(0));
  }

 private:
  Star star_;
  const Star* lanes_[test_lanes::k_lanes];
  test_lanes::RingEnergy<0> ring_;
  test_lanes::LineModel model_;
};

/// Calls visit(ring, plain patch, vertex in the mesh, scale) with ring looking at each inner
/// vertex.
template <class Visit>
void for_each_ring(const TriMesh& mesh, Visit visit) {
  const plain::Patch patch(mesh);
  const Patch surface(mesh);
  ThreadPool pool(1);
  PatchState state(surface, pool);
  for (std::size_t v = 0; v < state.inner_count(); ++v) {
    OneRing ring(state, v);
    visit(ring, patch, state.vertex_of(state.plan().visits[v]), state.scale());
  }
}

TEST(RingEnergy, AgreesWithThePlainOneToTwelveDigits) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for_each_ring(meshes::rough_grid(7, 6, seed), [](OneRing& ring, const plain::Patch& patch,
                                                     Index v, double scale) {
      const Vec3 x = patch.mesh.positions[v];
      EXPECT_NEAR(ring.energy(), patch.ring_energy(v, x), 1e-12);
      for (const Vec3 shift : {Vec3{0.1, 0.0, 0.2}, Vec3{-0.2, 0.3, -0.1}}) {
        EXPECT_NEAR(ring.evaluate_at(scale * (x + shift)), patch.ring_energy(v, x + shift), 1e-12);
      }
    });
  }
}

TEST(RingEnergy, KeepsItsDigitsWhereEdgesAreShortBesideThePatch) {
  TriMesh mesh = meshes::rough_grid(7, 6, 1);
  std::vector<int> triangles_at(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t)
      ++triangles_at[v];
  }
  const auto ear = std::find(triangles_at.begin(), triangles_at.end(), 1);
  ASSERT_NE(ear, triangles_at.end());
  for (const double far : {1e38, 1e60}) {
    mesh.positions[static_cast<std::size_t>(ear - triangles_at.begin())] = {far, 0.0, 0.0};
    for_each_ring(mesh, [](OneRing& ring, const plain::Patch& patch, Index v, double scale) {
      const Vec3 x = patch.mesh.positions[v] + Vec3{0.1, 0.0, 0.2};
      EXPECT_NEAR(ring.evaluate_at(scale * x), patch.ring_energy(v, x), 1e-12);
    });
  }
}

TEST(RingEnergy, HasThePapersLaplacian) {
  for_each_ring(meshes::rough_grid(6, 6, 4),
                [](OneRing& ring, const plain::Patch& patch, Index v, double scale) {
                  const Vec3 expected = scale * patch.laplacian(v);
                  EXPECT_NEAR(norm(ring.laplacian() - expected), 0.0, 1e-15);
                });
}

TEST(RingEnergy, BeginsOnTheLineAsThePapersEquations15To17Corrected) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for_each_ring(meshes::rough_grid(7, 6, seed), [](OneRing& ring, const plain::Patch& patch,
                                                     Index v, double) {
      const LinePoint expected = patch.along(v, patch.laplacian(v), 0.0);
      EXPECT_NEAR(ring.coefficient(0), expected.value, 1e-11);
      EXPECT_NEAR(ring.coefficient(1), expected.slope, 1e-9 * (1.0 + std::abs(expected.slope)));
      EXPECT_NEAR(2.0 * ring.spread(), expected.curvature, 1e-9 * (1.0 + expected.curvature));
    });
  }
}

TEST(RingEnergy, SlopeIsTheDifferenceQuotient) {
  constexpr double h = 1e-6;
  for (std::uint64_t seed = 20; seed < 30; ++seed) {
    for_each_ring(
        meshes::rough_grid(7, 6, seed), [](OneRing& ring, const plain::Patch&, Index, double) {
          const double difference = (ring.evaluate_along(h) - ring.evaluate_along(-h)) / (2.0 * h);
          EXPECT_NEAR(ring.coefficient(1), difference, 1e-7 * (1.0 + std::abs(difference)));
        });
  }
}

TEST(RingEnergy, OnTheLineIsTheSumOfTheSquaresOfTheDefectsTaylorSeries) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for_each_ring(meshes::rough_grid(7, 6, seed), [](OneRing& ring, const plain::Patch& patch,
                                                     Index v, double) {
      double expected[5] = {};
      double sizes[5] = {};
      for (const plain::Series& defect : patch.defects_along(v, patch.laplacian(v))) {
        for (std::size_t i = 0; i < 4; ++i) {
          for (std::size_t j = 0; j < 4 && i + j < 5; ++j) {
            expected[i + j] += defect.c[i] * defect.c[j];
            sizes[i + j] += std::abs(defect.c[i] * defect.c[j]);
          }
        }
      }
      for (int power = 0; power < 5; ++power)
        EXPECT_NEAR(ring.coefficient(power), expected[power], 1e-10 * (1.0 + sizes[power]))
            << power;
    });
  }
}

TEST(RingEnergy, DepartsFromItsModelByTheFourthPowerOfTheStep) {
  double small = 0.0, large = 0.0;
  for_each_ring(meshes::rough_grid(9, 9, 3),
                [&](OneRing& ring, const plain::Patch&, Index, double) {
                  small += std::abs(ring.evaluate_along(0.01) - ring.model_at(0.01));
                  large += std::abs(ring.evaluate_along(0.02) - ring.model_at(0.02));
                });
  EXPECT_GT(large, 14.0 * small);
}

TEST(RingEnergy, LeavesBorderNeighboursOut) {
  // One inner vertex: its ring is all border, so only its own defect counts.
  for_each_ring(meshes::fan(6, 0.7), [](OneRing& ring, const plain::Patch& patch, Index v, double) {
    EXPECT_NEAR(ring.energy(), patch.defect(v) * patch.defect(v), 1e-14);
  });
}

TEST(RingEnergy, HoldsEveryTermOfTheEnergyThatAMoveChanges) {
  const TriMesh mesh = meshes::rough_grid(6, 6, 8);
  for_each_ring(mesh, [](OneRing& ring, const plain::Patch& patch, Index v, double scale) {
    const Vec3 target = patch.mesh.positions[v] + Vec3{0.1, -0.2, 0.15};
    plain::Patch moved = patch;
    moved.mesh.positions[v] = target;
    const double before = ring.energy();
    EXPECT_NEAR(ring.evaluate_at(scale * target) - before, moved.energy() - patch.energy(), 1e-11);
  });
}

TEST(RingEnergy, FollowsDefectsThroughLargeTurns) {
  // Far positions: angles at the neighbours change by more than a quarter turn.
  for (std::uint64_t seed = 40; seed < 50; ++seed) {
    for_each_ring(meshes::rough_grid(6, 6, seed), [](OneRing& ring, const plain::Patch& patch,
                                                     Index v, double scale) {
      const Vec3 x = patch.mesh.positions[v];
      for (const Vec3 shift :
           {Vec3{3.0, 0.5, 0.0}, Vec3{0.0, 0.0, 9.0}, Vec3{-2.0, -2.0, 0.1}, Vec3{0.9, 0.9, 0.0}}) {
        EXPECT_NEAR(ring.evaluate_at(scale * (x + shift)), patch.ring_energy(v, x + shift), 1e-11);
      }
    });
  }
}

TEST(RingEnergy, WritesBackTheDefectsOfTheWholeRing) {
  const TriMesh mesh = meshes::rough_grid(6, 6, 9);
  const Patch patch(mesh);
  ThreadPool pool(1);
  PatchState state(patch, pool);
  for (std::size_t v = 0; v < state.inner_count(); ++v) {
    OneRing ring(state, v);
    ring.move_to(ring.start() + 0.3 * ring.laplacian(), state);
  }
  const plain::Patch moved({state.positions_in_mesh_order(), mesh.triangles});
  for (std::size_t v = 0; v < state.inner_count(); ++v) {
    EXPECT_NEAR(state.defect(v), moved.defect(state.vertex_of(v)), 1e-13);
  }
}

TEST(RingEnergy, KeepsAnglesAboveTheLimitOrWhatTheyAre) {
  const TriMesh mesh = meshes::fan(6);
  const Patch patch(mesh);
  ThreadPool pool(1);
  PatchState state(patch, pool);
  const auto cotangent = [](double degrees) {
    return 1.0 / std::tan(degrees * std::numbers::pi / 180.0);
  };
  const Vec3 near_a_corner{0.95 * state.scale(), 0.0, 0.0};  // triangles of about 2.6 degrees
  EXPECT_TRUE(OneRing(state, 0, cotangent(1.0)).sound_at(near_a_corner));
  EXPECT_FALSE(OneRing(state, 0, cotangent(10.0)).sound_at(near_a_corner));
  OneRing strict(state, 0, cotangent(80.0));
  EXPECT_TRUE(strict.sound_at(strict.start() + Vec3{0.0, 0.0, 0.0}));
}

TEST(RingEnergy, RefusesTheNeighboursPlaces) {
  const TriMesh mesh = meshes::fan(6);
  const Patch patch(mesh);
  ThreadPool pool(1);
  PatchState state(patch, pool);
  OneRing ring(state, 0);
  EXPECT_TRUE(ring.sound_at(0.5 * state.position(3)));
  EXPECT_FALSE(ring.sound_at(state.position(3)));
}

}  // namespace
}  // namespace planish
