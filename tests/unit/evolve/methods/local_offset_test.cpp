#include <algorithm>
#include <cmath>
#include <limits>

#include <planish/evolve/evolve.h>
#include <planish/measure/fairness.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "support/bent_sheets.h"
#include "support/evolved.h"
#include "support/meshes.h"

namespace planish {
namespace {

constexpr Stopping k_to_the_end{.max_sweeps = 100'000};

/// A cylinder with dents: what is left when they are out is flattenable.
TriMesh dented_cylinder(double dent) {
  TriMesh mesh = make_shape("cylinder", 900);
  meshes::Random random(11);
  const Patch patch(mesh);
  const std::vector<Vec3> smooth = mesh.positions;
  for (const Index v : patch.inner_vertices()) {
    const auto ring = patch.ring(v);
    const Vec3 normal = cross(smooth[ring[0]] - smooth[v], smooth[ring[1]] - smooth[v]);
    mesh.positions[v] += (dent * random.number() / norm(normal)) * normal;
  }
  return mesh;
}

double e_max_of(const TriMesh& mesh, const std::vector<Vec3>& positions) {
  return figures_of(mesh, positions).e_max;
}

/// Exactly |a - b|^2, as near as extended precision has it.
long double squared_distance(Vec3 a, Vec3 b) {
  const auto square = [](double s, double t) {
    const long double d = static_cast<long double>(s) - static_cast<long double>(t);
    return d * d;
  };
  return square(a.x, b.x) + square(a.y, b.y) + square(a.z, b.z);
}

TEST(LocalOffset, KeepsTheBandToTheLastBit) {
  for (const Vec3 place : {Vec3{}, Vec3{1e5, -3e5, 7e4}}) {
    TriMesh mesh = meshes::rough_grid(12, 12, 6, 0.2, 0.6);
    for (Vec3& p : mesh.positions)
      p += place;
    for (const double band : {1e-9, 0.01, 0.1, 1.0 / 3.0}) {
      const auto result = evolve(Patch(mesh), LocalOffset{.band = band}, {.max_sweeps = 30});
      const auto largest = static_cast<long double>(band);
      std::size_t on_band = 0;
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const long double squared = squared_distance(result.positions[v], mesh.positions[v]);
        EXPECT_LE(squared, largest * largest) << band;
        EXPECT_LE(norm(result.positions[v] - mesh.positions[v]), band) << band;
        on_band += squared > 0.81L * largest * largest ? 1 : 0;
      }
      EXPECT_GT(on_band, 5U) << band;
    }
  }
}

TEST(LocalOffset, MovesAlongTheNormalsOfTheInput) {
  // Of a pyramid over a regular ring the normal is the axis, and the apex ends in the plane.
  for (const std::size_t valence : {3U, 5U, 8U}) {
    const TriMesh mesh = meshes::fan(valence, 0.5);
    const auto result = evolve(Patch(mesh), LocalOffset{.band = 1.0, .enough = 1e-6}, k_to_the_end);
    EXPECT_EQ(result.stop, StopReason::converged);
    EXPECT_NEAR(result.positions[0].x, 0.0, 1e-12);
    EXPECT_NEAR(result.positions[0].y, 0.0, 1e-12);
    EXPECT_NEAR(result.positions[0].z, 0.0, 1e-2);
  }
}

TEST(LocalOffset, BeginsWithTheLargestDefect) {
  const TriMesh mesh = make_shape("panel", 900);
  const auto defects = angle_defects(Patch(mesh));
  const auto is_smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto worst = std::max_element(defects.begin(), defects.end(), is_smaller);
  const auto result = evolve(Patch(mesh), LocalOffset{.enough = 0.0, .max_updates = 1});
  for (std::size_t v = 0; v < defects.size(); ++v) {
    const bool is_worst = v == static_cast<std::size_t>(worst - defects.begin());
    EXPECT_EQ(result.positions[v] != mesh.positions[v], is_worst) << v;
  }
}

TEST(LocalOffset, EnergyNeverRisesInASweep) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const TriMesh mesh = meshes::rough_grid(12, 12, seed, 0.3, 0.6);
    for (const double band : {0.0, 0.1, 5.0}) {
      double energy = figures_of(mesh, mesh.positions).energy;
      const auto result =
          evolve(Patch(mesh), LocalOffset{.band = band, .enough = 0.0}, {.max_sweeps = 40});
      for (const SweepRecord& record : result.history) {
        EXPECT_LE(record.energy, energy);
        energy = record.energy;
      }
    }
  }
}

TEST(LocalOffset, EndsWithVerticesOnTheBandWhereThatIsSmall) {
  // As printed the first vertex on the band would be tried for ever.
  const TriMesh mesh = dented_cylinder(4.0);
  for (const double band : {1e-3, 0.3, 1.0}) {
    const auto result = evolve(Patch(mesh), LocalOffset{.band = band}, k_to_the_end);
    EXPECT_EQ(result.stop, StopReason::stalled) << band;
    EXPECT_GT(e_max_of(mesh, result.positions), 1e-2) << band;
    std::size_t on_band = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      on_band += norm(result.positions[v] - mesh.positions[v]) > 0.999 * band;
    EXPECT_GT(on_band, 10U) << band;
  }
}

TEST(LocalOffset, BringsEveryDefectToAHundredthWhereTheBandHasRoom) {
  for (const double dent : {0.5, 1.0, 2.0}) {
    const TriMesh mesh = dented_cylinder(dent);
    ASSERT_GT(e_max_of(mesh, mesh.positions), 0.03);
    const auto result = evolve(Patch(mesh), LocalOffset{}, k_to_the_end);
    EXPECT_EQ(result.stop, StopReason::converged);
    EXPECT_LE(e_max_of(mesh, result.positions), 1e-2);
  }
}

constexpr LocalOffset published(double band) {
  return {.band = band, .step = OffsetStep::published};
}

TEST(LocalOffset, WithPublishedStepsGetsFlatterAndRougherTheWiderTheBand) {
  // Fig. 9 of the paper: a shoe with four bands. Here 0.2, 0.4 and 0.8 of the mean edge.
  const TriMesh mesh = meshes::shoe_upper(24);
  struct Figures {
    double e_max, strain, bending;
  };
  const auto figures = [&](const std::vector<Vec3>& positions) {
    return Figures{e_max_of(mesh, positions), auto_runs::rms_strain(mesh, positions),
                   measure_bending(Patch({positions, mesh.triangles})).bending};
  };
  const auto after = [&](const LocalOffset& method) {
    return figures(evolve(Patch(mesh), method, k_to_the_end).positions);
  };
  EXPECT_GT(figures(mesh.positions).strain, 0.02);
  const Figures narrow = after(published(0.01)), middle = after(published(0.02));
  const Figures wide = after(published(0.04));
  EXPECT_LT(middle.e_max, 0.5 * narrow.e_max);
  EXPECT_LT(wide.e_max, 0.5 * narrow.e_max);
  EXPECT_LT(middle.strain, 0.75 * narrow.strain);
  EXPECT_LT(wide.strain, 0.9 * middle.strain);
  EXPECT_GT(middle.bending, narrow.bending);
  EXPECT_GT(wide.bending, middle.bending);
  // Guarded steps stall with most of the strain, whatever the band.
  EXPECT_GT(after({.band = 0.04}).strain, 0.8 * figures(mesh.positions).strain);
}

TEST(LocalOffset, TakesThePublishedStep) {
  // One step of Newton's method for a root of T along the normal, T by differences.
  const TriMesh mesh = meshes::fan(6, 0.3);
  const auto energy = [&](double offset) {
    std::vector<Vec3> positions = mesh.positions;
    positions[0].z += offset;
    return figures_of(mesh, positions).energy;
  };
  LocalOffset method = published(10.0);
  method.max_updates = 1;
  const auto after = evolve(Patch(mesh), method, {.max_sweeps = 1}).positions;
  const double slope = (energy(1e-5) - energy(-1e-5)) / 2e-5;
  EXPECT_NEAR(after[0].z - mesh.positions[0].z, -energy(0.0) / slope, 1e-8);
}

TEST(LocalOffset, WithPublishedStepsEndsWhereTheVisitsAreUsedUp) {
  const TriMesh mesh = meshes::rough_grid(12, 12, 6, 0.2, 0.6);
  for (const int visits : {1, 7}) {
    LocalOffset method = published(0.1);
    method.max_visits = visits;
    const auto result = evolve(Patch(mesh), method, k_to_the_end);
    EXPECT_EQ(result.stop, StopReason::stalled);
    const std::size_t inner = Patch(mesh).inner_vertices().size();
    EXPECT_LE(result.history.size(), static_cast<std::size_t>(visits) + 1);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      EXPECT_LE(norm(result.positions[v] - mesh.positions[v]), 0.1);
    std::size_t moved = 0;
    for (const SweepRecord& record : result.history)
      moved += record.moved;
    EXPECT_LE(moved, inner * static_cast<std::size_t>(visits));
  }
}

TEST(LocalOffset, LeavesADefectOfAtMostEnoughAlone) {
  const TriMesh mesh = make_shape("panel", 900);
  const double e_max = e_max_of(mesh, mesh.positions);
  const auto result = evolve(Patch(mesh), LocalOffset{.enough = 1.001 * e_max});
  EXPECT_EQ(result.positions, mesh.positions);
  EXPECT_EQ(result.stop, StopReason::converged);
}

TEST(LocalOffset, TriesNoMoreVerticesThanAllowed) {
  const TriMesh mesh = meshes::rough_grid(12, 12, 3);
  for (const int tries : {0, 20, 150}) {
    const auto result = evolve(Patch(mesh), LocalOffset{.max_updates = tries}, k_to_the_end);
    std::size_t moved = 0;
    for (const SweepRecord& record : result.history)
      moved += record.moved;
    EXPECT_LE(moved, static_cast<std::size_t>(tries));
    EXPECT_GE(moved, static_cast<std::size_t>(tries) / 3);
    EXPECT_EQ(result.stop, StopReason::stalled);
  }
}

TEST(LocalOffset, GivesTheSameBitsEveryTime) {
  const TriMesh mesh = make_shape("panel", 2000);
  const LocalOffset method{.enough = 1e-3};
  const auto one = evolve(Patch(mesh), method, {.max_sweeps = 5}, {}, {.threads = 1});
  for (const unsigned threads : {1U, 2U, 4U})
    EXPECT_EQ(evolve(Patch(mesh), method, {.max_sweeps = 5}, {}, {.threads = threads}).positions,
              one.positions);
}

TEST(LocalOffset, DoesNotDependOnTheSizeOfTheModel) {
  const TriMesh mesh = meshes::rough_grid(10, 10, 12);
  const auto after = evolve(Patch(mesh), LocalOffset{.band = 0.3}, {.max_sweeps = 5});
  for (const double size : {0x1p-400, 0x1p+40, 0x1p+700}) {
    TriMesh scaled = mesh;
    for (Vec3& p : scaled.positions)
      p = size * p;
    const auto scaled_after =
        evolve(Patch(scaled), LocalOffset{.band = 0.3 * size}, {.max_sweeps = 5});
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      ASSERT_EQ(scaled_after.positions[v], size * after.positions[v]) << size;
    }
  }
}

TEST(LocalOffset, SurvivesASpikeAMillionTimesTheSizeOfThePatch) {
  TriMesh mesh = meshes::rough_grid(8, 8, 2);
  mesh.positions[40] = {1e6, -2e6, 3e6};
  for (const double band : {0.0, 1e300, std::numeric_limits<double>::infinity()}) {
    const auto result = evolve(Patch(mesh), LocalOffset{.band = band}, {.max_sweeps = 20});
    for (const Vec3 p : result.positions)
      EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
    EXPECT_LT(figures_of(mesh, result.positions).energy, figures_of(mesh, mesh.positions).energy);
  }
}

}  // namespace
}  // namespace planish
