#include "evolve/vertex_step/ring_energy_on_line.h"

#include <cmath>

#include <gtest/gtest.h>

#include "evolve/state/patch_state.h"
#include "oracle/plain.h"
#include "support/meshes.h"
#include "support/random_fans.h"

namespace planish {
namespace {

/// The star of a vertex in a patch laid out for sweeping.
struct Placed {
  Star star;
  std::size_t valence;
};

Placed position_of(const PatchState& state, std::size_t visit) {
  const planish::Run& run = *state.plan().run_of(visit);
  return {state.plan().star(run, visit), run.valence};
}

/// Calls visit(line, plain patch, vertex, scale) for the rings of rough grids and the middles of
/// random fans.
template <class Visit>
void for_each_line(Visit visit) {
  std::vector<TriMesh> meshes;
  for (std::uint64_t seed = 0; seed < 4; ++seed)
    meshes.push_back(meshes::rough_grid(7, 6, seed));
  meshes::Random random(5);
  for (int i = 0; i < 150; ++i)
    meshes.push_back(meshes::RandomFan(random, static_cast<meshes::FanKind>(i % 3)).mesh());
  for (const TriMesh& mesh : meshes) {
    const plain::Patch patch(mesh);
    const Patch surface(mesh);
    ThreadPool pool(1);
    PatchState state(surface, pool);
    for (std::size_t i = 0; i < state.inner_count(); ++i) {
      const auto [star, valence] = position_of(state, i);
      const RingEnergyOnLine line(state.sites().data(), star, valence);
      visit(line, patch, state.vertex_of(star.center), state.scale());
    }
  }
}

/// Of a line: at the start, inside, at the ends and beyond.
constexpr double k_steps[] = {0.0, 0.13, 0.5, 1.0, -0.4, 1.7};

TEST(RingEnergyOnLine, IsTheRingEnergyAlongThePapersLaplacian) {
  for_each_line([](const RingEnergyOnLine& line, const plain::Patch& patch, Index v, double scale) {
    const Vec3 L = patch.laplacian(v), x = patch.mesh.positions[v];
    EXPECT_NEAR(norm(line.laplacian() - scale * L), 0.0, 1e-14);
    for (const double step : k_steps) {
      EXPECT_NEAR(line.at(line.place(step)).b.value, patch.ring_energy(v, x + step * L), 1e-11);
    }
  });
}

TEST(RingEnergyOnLine, HasTheDerivativesOfThePowerSeriesOfEveryAngle) {
  for_each_line([](const RingEnergyOnLine& line, const plain::Patch& patch, Index v, double) {
    const Vec3 L = patch.laplacian(v), x = patch.mesh.positions[v];
    for (const double step : k_steps) {
      plain::Patch moved = patch;
      moved.mesh.positions[v] = x + step * L;
      LineSample expected;
      double size = 0.0;  // of what the second derivative is the sum of
      for (const plain::Series& d : moved.defects_along(v, L)) {
        expected.slope += 2.0 * d.c[0] * d.c[1];
        expected.curvature += 2.0 * (d.c[1] * d.c[1] + 2.0 * d.c[0] * d.c[2]);
        size += d.c[1] * d.c[1] + std::abs(d.c[0] * d.c[1]) + std::abs(d.c[0] * d.c[2]);
      }
      const LineSample b = line.at(line.place(step)).b;
      EXPECT_NEAR(b.slope, expected.slope, 1e-11 * (1.0 + size)) << step;
      EXPECT_NEAR(b.curvature, expected.curvature, 1e-10 * (1.0 + size)) << step;
    }
  });
}

TEST(RingEnergyOnLine, HasTheSlopeOfThePapersEquations15To17Corrected) {
  for_each_line([](const RingEnergyOnLine& line, const plain::Patch& patch, Index v, double) {
    const Vec3 L = patch.laplacian(v);
    for (const double step : k_steps) {
      const LinePoint expected = patch.along(v, L, step);
      const LineSample b = line.at(line.place(step)).b;
      EXPECT_NEAR(b.slope, expected.slope, 1e-8 * (1.0 + expected.curvature)) << step;
    }
  });
}

TEST(RingEnergyOnLine, HasTheDerivativesOfDifferenceQuotients) {
  constexpr double h = 1e-5;
  std::size_t compared = 0;
  for_each_line([&](const RingEnergyOnLine& line, const plain::Patch&, Index, double) {
    for (const double step : k_steps) {
      const LineSample b = line.at(line.place(step)).b;
      const LineSample before = line.at(line.place(step - h)).b;
      const LineSample after = line.at(line.place(step + h)).b;
      // The quotients err by h^2 times derivatives that are large next to a kink.
      if (std::abs(after.curvature - before.curvature) > 1e-2 * (1.0 + std::abs(b.curvature)))
        continue;
      ++compared;
      const double slope = (after.value - before.value) / (2.0 * h);
      const double curvature = (after.slope - before.slope) / (2.0 * h);
      EXPECT_NEAR(b.slope, slope, 1e-6 * (1.0 + std::abs(b.slope) + std::abs(b.curvature)));
      EXPECT_NEAR(b.curvature, curvature, 1e-4 * (1.0 + std::abs(b.curvature)));
    }
  });
  EXPECT_GT(compared, 3000U);
}

TEST(RingEnergyOnLine, WritesTheDefectsThatMeasuringFinds) {
  const TriMesh mesh = meshes::rough_grid(9, 9, 4);
  const Patch patch(mesh);
  ThreadPool pool(1);
  PatchState state(patch, pool);
  for (std::size_t i = 0; i < state.inner_count(); ++i) {
    const auto [star, valence] = position_of(state, i);
    const RingEnergyOnLine line(state.sites().data(), star, valence);
    const Vec3 target = line.place(0.3);
    line.write(target, line.at(target), star, state.sites().data(), state.changes(0));
    EXPECT_EQ(state.position(star.center), target);
  }
  std::vector<double> written;
  for (std::size_t v = 0; v < state.inner_count(); ++v)
    written.push_back(state.defect(v));
  state.measure(pool);
  for (std::size_t v = 0; v < state.inner_count(); ++v)
    EXPECT_NEAR(written[v], state.defect(v), 1e-13);
}

TEST(RingEnergyOnLine, IsNoNumberOnANeighbourAndNotSoundBesideIt) {
  const TriMesh mesh = meshes::fan(6, 0.3);
  const Patch patch(mesh);
  ThreadPool pool(1);
  PatchState state(patch, pool);
  const auto [star, valence] = position_of(state, 0);
  const double max_cotangent = 1.0 / std::tan(0.1);
  const RingEnergyOnLine line(state.sites().data(), star, valence, max_cotangent);
  const Vec3 neighbour = state.position(star.ring[2]), start = line.start();
  EXPECT_TRUE(std::isnan(line.at(neighbour).b.value));
  EXPECT_FALSE(line.at(neighbour).sound);
  EXPECT_FALSE(line.at(start + 0.99 * (neighbour - start)).sound);
  EXPECT_TRUE(line.at(start).sound);
  EXPECT_TRUE(line.at(line.place(1.0)).sound);
}

}  // namespace
}  // namespace planish
