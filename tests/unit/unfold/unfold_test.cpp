#include <algorithm>
#include <cmath>
#include <numbers>

#include <planish/core/error.h>
#include <planish/evolve/evolve.h>
#include <planish/mesh/shapes.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/watched_job.h"
#include "unfold/disk/disk.h"
#include "unfold/start/start.h"
#include "unfold/stretch/flat_steps.h"
#include "unfold/stretch/least_stretch.h"

namespace planish {
namespace {

Pattern unfolded(const TriMesh& mesh) {
  return unfold(Patch(mesh));
}

EdgeStrain strain_of(const TriMesh& mesh, const Pattern& pattern) {
  return edge_strain(Patch(mesh), pattern.positions);
}

/// Counted without the library's help.
std::size_t flips_in(const TriMesh& mesh, const Pattern& pattern) {
  return static_cast<std::size_t>(
      std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
        const Vec2 a = pattern.positions[t[0]];
        return !(cross(pattern.positions[t[1]] - a, pattern.positions[t[2]] - a) > 0.0);
      }));
}

TEST(Unfold, KeepsEdgeLengthsWhereThePatchIsFlattenable) {
  for (const Shape& shape : shapes()) {
    if (!shape.flattenable) continue;
    for (const std::size_t n : {100U, 5000U}) {
      const TriMesh mesh = make_shape(shape.name, n);
      const Pattern pattern = unfolded(mesh);
      EXPECT_LT(strain_of(mesh, pattern).max, 1e-10) << shape.name;
      EXPECT_NEAR(pattern.area_ratio, 1.0, 1e-10);
      EXPECT_EQ(pattern.flipped_triangles, 0U);
      EXPECT_FALSE(pattern.overlaps);
      EXPECT_TRUE(pattern.converged);
    }
  }
}

TEST(Unfold, GivesACylinderItsTrueSize) {
  const Pattern pattern = unfolded(make_shape("cylinder", 3000));
  // An arc of 150 degrees of radius 150, a little less for its straight strips, by 400.
  EXPECT_NEAR(pattern.width, 400.0, 1e-6);
  EXPECT_NEAR(pattern.height, 150.0 * 150.0 * std::numbers::pi / 180.0, 0.1);
}

TEST(Unfold, FlipsNoTriangleHoweverCurvedThePatch) {
  std::vector<TriMesh> meshes_to_try{meshes::fan(5, 10.0), meshes::ruffled_fan(12, 2.0),
                                     meshes::rough_grid(15, 15, 4, 0.3, 1.5)};
  for (const Shape& shape : shapes())
    meshes_to_try.push_back(make_shape(shape.name, 1000));
  // Almost a whole sphere: a torus-free closed surface with one small hole.
  TriMesh bottle = meshes::flat_grid(24, 24);
  for (Vec3& p : bottle.positions) {
    const double x = (p.x - 12.0) / 12.0, y = (p.y - 12.0) / 12.0;
    const double r = std::max(std::abs(x), std::abs(y));
    const double polar = 2.9 * r, around = std::atan2(y, x);
    p = {std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)};
  }
  meshes_to_try.push_back(bottle);
  for (const TriMesh& mesh : meshes_to_try) {
    const Pattern pattern = unfolded(mesh);
    EXPECT_EQ(flips_in(mesh, pattern), 0U);
    EXPECT_EQ(pattern.flipped_triangles, 0U);
    EXPECT_TRUE(pattern.converged);
  }
}

TEST(Unfold, FindsTheSameMinimumFromBothStarts) {
  const TriMesh mesh = make_shape("dome", 700);
  const Disk disk = make_disk(Patch(mesh));
  ThreadPool alone(1);
  const auto conformal = conformal_start(disk, alone), tutte = tutte_start(disk, alone);
  ASSERT_TRUE(all_upright(disk, conformal));
  ASSERT_TRUE(all_upright(disk, tutte));
  double apart = 0.0;
  for (std::size_t v = 0; v < tutte.size(); ++v)
    apart = std::max(apart, norm(tutte[v] - conformal[v]));
  EXPECT_GT(apart, 0.01) << "the starts are to differ";
  ThreadPool pool(1);
  const auto energy_from = [&](const std::vector<Vec2>& start) {
    StretchSystem system(disk, pool);
    const LeastStretch result = minimise_stretch(disk, system, start, 200, {});
    EXPECT_TRUE(result.converged);
    return total_energy(disk, result.flat);
  };
  const double energy = energy_from(conformal);
  EXPECT_NEAR(energy_from(tutte), energy, 1e-5 * energy);
}

TEST(Unfold, HasLessStretchThanTheConformalStart) {
  const TriMesh mesh = make_shape("dome", 1500);
  const Patch patch(mesh);
  const Disk disk = make_disk(patch);
  std::vector<Vec2> start(mesh.positions.size());
  ThreadPool alone(1);
  const auto flat = conformal_start(disk, alone);
  for (std::size_t v = 0; v < flat.size(); ++v)
    start[disk.vertex_of[v]] = (1.0 / (disk.box_scale * disk.area_scale)) * flat[v];
  EXPECT_LT(strain_of(mesh, unfolded(mesh)).rms, 0.9 * edge_strain(patch, start).rms);
}

TEST(Unfold, FacesUpAndFitsItsBox) {
  TriMesh mesh = make_shape("panel", 800);
  const Pattern pattern = unfolded(mesh);
  EXPECT_GE(pattern.width, pattern.height);
  double low_x = 1.0, low_y = 1.0, high_x = 0.0, high_y = 0.0;
  for (const Vec2 p : pattern.positions) {
    low_x = std::min(low_x, p.x), low_y = std::min(low_y, p.y);
    high_x = std::max(high_x, p.x), high_y = std::max(high_y, p.y);
  }
  EXPECT_NEAR(low_x, 0.0, 1e-9 * pattern.width);
  EXPECT_NEAR(low_y, 0.0, 1e-9 * pattern.width);
  EXPECT_EQ(high_x, pattern.width);
  EXPECT_EQ(high_y, pattern.height);
}

TEST(Unfold, DoesNotDependOnSize) {
  const TriMesh mesh = make_shape("panel", 500);
  const Pattern pattern = unfolded(mesh);
  for (const double size : {0x1p-300, 0x1p+300}) {
    TriMesh scaled = mesh;
    for (Vec3& p : scaled.positions)
      p = size * p;
    const Pattern other = unfolded(scaled);
    EXPECT_NEAR(other.width / size, pattern.width, 1e-9 * pattern.width) << size;
    EXPECT_NEAR(strain_of(scaled, other).rms, strain_of(mesh, pattern).rms, 1e-12);
  }
}

TEST(Unfold, PutsUnusedVerticesAtTheOrigin) {
  TriMesh mesh = make_shape("cone", 200);
  mesh.positions.insert(mesh.positions.begin() + 3, Vec3{1e7, 2, 3});
  for (Triangle& t : mesh.triangles) {
    for (Index& v : t)
      v = v >= 3 ? v + 1 : v;
  }
  const Pattern pattern = unfolded(mesh);
  ASSERT_EQ(pattern.positions.size(), mesh.positions.size());
  EXPECT_EQ(pattern.positions[3], (Vec2{0.0, 0.0}));
  EXPECT_LT(strain_of(mesh, pattern).max, 1e-9);
}

TEST(Unfold, SaysWhenThePatternLiesOverItself) {
  // A ramp that winds around more than once: flattenable, but not onto one sheet.
  TriMesh ramp = meshes::flat_grid(90, 3);
  for (Vec3& p : ramp.positions) {
    const double angle = 0.1 * p.x, radius = 3.0 + p.y;
    p = {radius * std::cos(angle), radius * std::sin(angle), 0.3 * angle};
  }
  const Pattern pattern = unfolded(ramp);
  EXPECT_TRUE(pattern.overlaps);
  EXPECT_EQ(pattern.flipped_triangles, 0U);
}

TEST(Unfold, LaysOneTriangleFlat) {
  const TriMesh mesh{{{0, 0, 0}, {3, 0, 0}, {0, 0, 4}}, {{0, 1, 2}}};
  const Pattern pattern = unfolded(mesh);
  EXPECT_LT(strain_of(mesh, pattern).max, 1e-12);
  EXPECT_NEAR(pattern.width * pattern.height, 12.0, 1e-9);
}

TEST(Unfold, SurvivesATriangleWithoutArea) {
  TriMesh mesh = meshes::flat_grid(4, 4);
  mesh.positions[6] = 0.5 * (mesh.positions[7] + mesh.positions[11]);  // onto an edge of a triangle
  const Pattern pattern = unfolded(mesh);
  for (const Vec2 p : pattern.positions)
    EXPECT_TRUE(std::isfinite(p.x + p.y));
  EXPECT_EQ(flips_in(mesh, pattern), pattern.flipped_triangles);
}

TEST(Unfold, ReportsEveryStepAndCanBeCancelledAfterAny) {
  const Patch dome(make_shape("dome", 600));
  WatchedJob job;
  const Pattern pattern = unfold(dome, {}, job.context());
  EXPECT_EQ(job.reports(), pattern.iterations);
  expect_cancellable([&](const Context& context) { unfold(dome, {}, context); });
}

TEST(Unfold, CanBeCancelledWithinAStep) {
  const Patch dome(make_shape("dome", 600));
  int asked = 0;
  const auto is_cancelled = [&] { return ++asked == 3; };
  EXPECT_THROW(unfold(dome, {}, {.threads = 1, .is_cancelled = is_cancelled}), Cancelled);
  EXPECT_EQ(asked, 3);
}

TEST(Unfold, RefusesWhatIsNotADisk) {
  const auto code_of = [](const TriMesh& mesh) {
    try {
      unfold(Patch(mesh));
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::unfold_failed;
  };
  EXPECT_EQ(code_of(meshes::tube(6, 3)), ErrorCode::several_border_loops);
  EXPECT_EQ(code_of(meshes::tetrahedron()), ErrorCode::closed_surface);
  EXPECT_EQ(code_of(meshes::side_by_side(meshes::fan(5), meshes::fan(5))),
            ErrorCode::several_components);
  TriMesh torus = meshes::torus(8, 8);
  torus.triangles.pop_back();
  EXPECT_EQ(code_of(torus), ErrorCode::handles);
}

TEST(Unfold, GivesTheSameBitsForEveryNumberOfThreads) {
  const TriMesh mesh = make_shape("panel", 6000);
  const Patch patch(mesh);
  for (const bool match_seams : {false, true}) {
    const auto on_threads = [&](unsigned threads) {
      return unfold(patch, {.match_seams = match_seams}, {.threads = threads}).positions;
    };
    const std::vector<Vec2> alone = on_threads(1);
    EXPECT_EQ(on_threads(2), alone);
    EXPECT_EQ(on_threads(5), alone);
  }
}

TEST(FlatMesh, HasTheSameTrianglesInThePlane) {
  const TriMesh mesh = make_shape("cone", 200);
  const Pattern pattern = unfolded(mesh);
  const TriMesh flat = flat_mesh(mesh, pattern);
  EXPECT_EQ(flat.triangles, mesh.triangles);
  for (std::size_t v = 0; v < flat.positions.size(); ++v) {
    EXPECT_EQ(flat.positions[v], (Vec3{pattern.positions[v].x, pattern.positions[v].y, 0.0}));
  }
}

TEST(Unfold, TakesAVertexOfHighValenceOnEitherSideOfTheMiddle) {
  // Were the hub's neighbours made separators, factoring would take cubic time.
  for (const double x : {-0.1, 0.1}) {
    TriMesh mesh = meshes::fan(20'000, 0.1);
    mesh.positions[0].x = x;
    EXPECT_EQ(unfolded(mesh).flipped_triangles, 0U);
    const auto n = static_cast<Index>(mesh.positions.size() - 1);
    for (Index j = 1; j <= n; ++j)
      mesh.positions.push_back(1.01 * mesh.positions[j]);
    for (Index j = 0; j < n; ++j) {
      const Index a = 1 + j, b = 1 + (j + 1) % n;
      mesh.triangles.push_back({a, a + n, b + n});
      mesh.triangles.push_back({a, b + n, b});
    }
    EXPECT_EQ(unfolded(mesh).flipped_triangles, 0U);
  }
}

TEST(Unfold, KeepsItsSizeWhereTheModelIsAsSmallAsNumbersGo) {
  TriMesh mesh = make_shape("saddle", 300);
  const double width = unfolded(mesh).width;
  for (Vec3& p : mesh.positions)
    p = 1e-308 * p;
  EXPECT_NEAR(unfolded(mesh).width / 1e-308, width, 1e-6 * width);
}

}  // namespace
}  // namespace planish
