#include <algorithm>

#include <planish/evolve/evolve.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/inspect.h>

#include <gtest/gtest.h>

#include "evolve/methods/controllable_laplacian.h"
#include "oracle/plain.h"
#include "property/property.h"
#include "support/meshes.h"

namespace planish {
namespace {

/// A rough grid of arbitrary size and roughness.
TriMesh arbitrary_grid() {
  const auto columns = *rc::gen::inRange<std::size_t>(2, 9);
  const auto rows = *rc::gen::inRange<std::size_t>(2, 9);
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  const double height = 0.01 * *rc::gen::inRange(0, 200);
  return meshes::rough_grid(columns, rows, seed, 0.35, height);
}

PLANISH_PROPERTY(EvolveProperty, EnergyNeverRisesWhenASingleVertexMoves, 2'000) {
  const TriMesh mesh = arbitrary_grid();
  const ControllableLaplacian options{.lambda_min = -0.5 * *rc::gen::inRange(0, 3)};
  const Patch patch(mesh);
  ThreadPool pool(1);
  PatchState state(patch, pool);
  ControllableMover mover(options, state);
  double energy = plain::Patch(mesh).energy();
  for (std::size_t v = 0; v < state.inner_count(); ++v) {
    const bool moved = mover.move(v, v + 1) > 0;
    const double next = plain::Patch({state.positions_in_mesh_order(), mesh.triangles}).energy();
    if (moved) RC_ASSERT(next < energy + 1e-13);
    if (!moved) RC_ASSERT(next == energy);
    energy = next;
  }
}

PLANISH_PROPERTY(EvolveProperty, EnergyNeverRisesInASweepAndTheBorderStays, 3'000) {
  const TriMesh mesh = arbitrary_grid();
  const ControllableLaplacian options{.lambda_min = -0.5 * *rc::gen::inRange(0, 3)};
  const Patch patch(mesh);
  double energy = measure(patch).energy;
  const auto result = evolve(patch, options, {.max_sweeps = 15});
  for (const SweepRecord& record : result.history) {
    RC_ASSERT(record.energy <= energy);
    energy = record.energy;
  }
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    if (!patch.is_inner(v)) RC_ASSERT(result.positions[v] == mesh.positions[v]);
  }
}

PLANISH_PROPERTY(EvolveProperty, NothingIsEverNotFinite, 3'000) {
  TriMesh mesh = arbitrary_grid();
  const auto v = *rc::gen::inRange<std::size_t>(0, mesh.positions.size());
  const auto power = *rc::gen::inRange(-12, 12);
  mesh.positions[v] += std::pow(10.0, power) * Vec3{1.0, -2.0, 0.5};
  const auto result =
      evolve(Patch(mesh), ControllableLaplacian{.lambda_min = -1.0}, {.max_sweeps = 10});
  for (const Vec3 p : result.positions)
    RC_ASSERT(std::isfinite(p.x + p.y + p.z));
}

PLANISH_PROPERTY(EvolveProperty, EnergyNeverRisesOnLatticesFullOfStraightAndZeroAngles, 2'000) {
  // Coordinates of few values: many triangles have no area, many corners are exactly 0 or pi.
  const auto columns = *rc::gen::inRange<std::size_t>(2, 6);
  const auto rows = *rc::gen::inRange<std::size_t>(2, 6);
  TriMesh mesh = meshes::flat_grid(columns, rows);
  for (Vec3& p : mesh.positions) {
    p.x += *rc::gen::inRange(-1, 2);
    p.y += *rc::gen::inRange(-1, 2);
    p.z += *rc::gen::inRange(0, 2);
  }
  const Inspection inspection = inspect(mesh);
  RC_PRE(!blocking_problem(inspection, Purpose::evolve));
  double energy = measure(Patch(mesh)).energy;
  const auto result = evolve(Patch(mesh), ControllableLaplacian{}, {.max_sweeps = 15});
  for (const SweepRecord& record : result.history) {
    RC_ASSERT(record.energy <= energy);
    energy = record.energy;
  }
  RC_ASSERT(!blocking_problem(inspect({result.positions, mesh.triangles}), Purpose::evolve));
}

}  // namespace
}  // namespace planish
