#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <planish/evolve/evolve.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/shapes.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

#include <gtest/gtest.h>

#include "geometry/box.h"
#include "support/evolved.h"
#include "support/meshes.h"

namespace planish {
namespace {

/// A panel whose border allows flatness, with round holes along its middle.
TriMesh panel_with_holes(std::size_t vertices, int holes) {
  TriMesh mesh = make_shape("panel", vertices);
  Box box;
  for (const Vec3 p : mesh.positions)
    box.add(p);
  const Vec3 side = box.high - box.low;
  const double radius = 0.12 * std::min(side.x, side.y);
  for (int k = 0; k < holes; ++k) {
    const double share = (2.0 * k + 1.0) / (2.0 * holes);
    const Vec3 middle = box.low + Vec3{share * side.x, 0.45 * side.y, 0.0};
    std::erase_if(mesh.triangles, [&](const Triangle& t) {
      return std::all_of(t.begin(), t.end(), [&](Index v) {
        const Vec3 away = mesh.positions[v] - middle;
        return std::hypot(away.x, away.y) < radius;
      });
    });
  }
  return mesh;
}

/// A cone whose apex is in a hole, of plane strips: only the hole does not lie flat.
TriMesh cone_with_hole() {
  TriMesh mesh = meshes::tube(48, 8);
  for (Vec3& p : mesh.positions) {
    const double radius = 6.0 + p.z;
    p = {radius * p.x, radius * p.y, 0.25 * radius};
  }
  return mesh;
}

EvolveResult evolved(const TriMesh& mesh, const Auto& method, unsigned threads = 1) {
  return evolve(Patch(mesh), method, usual_stopping(method), {}, {.threads = threads});
}

double pattern_strain(const TriMesh& mesh, const std::vector<Vec3>& positions) {
  const Patch patch(TriMesh{positions, mesh.triangles});
  return edge_strain(patch, unfold(patch, {.least_stretch = true}).positions).rms;
}

void expect_each_step_to_lower_the_merit(const EvolveResult& result) {
  for (const SweepRecord& record : result.history) {
    if (record.level && record.moved > 0) {
      EXPECT_LT(record.level->merit, record.level->merit_before) << record.sweep;
    }
  }
}

TEST(AutoWithHoles, KeepsALimitOfStrain) {
  for (const TriMesh& mesh : {panel_with_holes(900, 1), panel_with_holes(1200, 3)}) {
    const double before = pattern_strain(mesh, mesh.positions);
    for (const Prefer prefer : {Prefer::smooth, Prefer::near}) {
      for (const double limit : {0.3 * before, 0.001}) {
        const EvolveResult result = evolved(mesh, {.limits = {.rms = limit}, .prefer = prefer});
        const double left = pattern_strain(mesh, result.positions);
        EXPECT_EQ(result.stop, StopReason::strain_met);
        EXPECT_LE(left, 1.1 * limit);
        EXPECT_GE(left, 0.5 * limit);
        expect_each_step_to_lower_the_merit(result);
      }
    }
  }
}

void expect_closed_by(const TriMesh& mesh, const Auto& method) {
  const Flattenability before = figures_of(mesh, mesh.positions);
  EXPECT_GT(std::max(before.hole_turning, before.hole_gap), 3.0 * k_flattenable_sum);
  const EvolveResult result = evolved(mesh, method);
  EXPECT_EQ(result.stop, StopReason::converged);
  const Patch patch(TriMesh{result.positions, mesh.triangles});
  EXPECT_TRUE(is_flattenable(measure(patch), patch.inspection()));
  EXPECT_LE(pattern_strain(mesh, result.positions), 3e-4);
  expect_each_step_to_lower_the_merit(result);
}

TEST(AutoWithHoles, ClosesThem) {
  expect_closed_by(panel_with_holes(900, 2), {.prefer = Prefer::flat});
}

// All angle sums are 2 pi from the start.
TEST(AutoWithHoles, ClosesThoseOfSurfacesWithoutCurvature) {
  const TriMesh mesh = cone_with_hole();
  EXPECT_LE(figures_of(mesh, mesh.positions).e_max, 1e-12);
  for (const Prefer prefer : {Prefer::flat, Prefer::near})
    expect_closed_by(mesh, {.prefer = prefer, .border = {BorderFreedom::Rule::within, 2.0}});
}

TEST(AutoWithHoles, GoesFromCoarseToFineWithTheSameBitsOnAnyNumberOfThreads) {
  const TriMesh mesh = panel_with_holes(6000, 2);
  const EvolveResult result = evolved(mesh, {}, 1);
  EXPECT_LT(result.history.front().level->inner_vertices,
            result.history.back().level->inner_vertices);
  EXPECT_LE(pattern_strain(mesh, result.positions), 1.1e-3);
  EXPECT_EQ(evolved(mesh, {}, 3).positions, result.positions);
}

}  // namespace
}  // namespace planish
