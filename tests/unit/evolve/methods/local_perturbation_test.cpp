#include <algorithm>
#include <cmath>
#include <vector>

#include <planish/core/error.h>
#include <planish/evolve/evolve.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "mesh/search/signed_distance.h"
#include "oracle/plain.h"
#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

double e_max_of(const TriMesh& mesh) {
  return measure(Patch(mesh)).e_max;
}

/// A flattenable patch, its inner vertices a little out of place.
TriMesh disturbed(std::string_view shape, std::size_t vertices = 500, double by = 0.3) {
  TriMesh mesh = make_shape(shape, vertices);
  const Patch surface(mesh);
  meshes::Random random(1);
  for (const Index v : surface.inner_vertices())
    mesh.positions[v] += by * Vec3{random.number(), random.number(), random.number()};
  return mesh;
}

/// A patch that hangs over the cube of the tests, on its upper face and around two of its edges.
TriMesh draped(double above) {
  TriMesh mesh = meshes::flat_grid(16, 10);
  meshes::Random random(4);
  for (Vec3& p : mesh.positions) {
    const double along = 0.2 * p.x - 1.6, across = 0.16 * p.y - 0.8;
    const double over = std::max(0.0, std::abs(along) - 1.0);
    p = {along, across, 1.0 + above - 0.3 * over * over + 0.04 * std::abs(random.number())};
  }
  return mesh;
}

double least_distance(const TriMesh& mesh, const SignedDistance& obstacle) {
  const Patch patch(mesh);
  double least = std::numeric_limits<double>::infinity();
  for (const Index v : patch.inner_vertices())
    least = std::min(least, obstacle.at(mesh.positions[v]).value);
  return least;
}

TEST(LocalPerturbation, MakesNearlyFlattenablePatchesFlattenable) {
  for (const char* shape : {"cylinder", "cone", "tangent"}) {
    const TriMesh mesh = disturbed(shape);
    EXPECT_GT(e_max_of(mesh), 5e-3) << shape;
    const auto result =
        evolve(Patch(mesh), LocalPerturbation{}, usual_stopping(LocalPerturbation{}));
    EXPECT_EQ(result.stop, StopReason::converged) << shape;
    EXPECT_LE(e_max_of({result.positions, mesh.triangles}), 1e-3) << shape;
    EXPECT_EQ(result.history.back().status, SweepStatus::converged);
  }
}

TEST(LocalPerturbation, LeavesTheBestStateAndTellsItTruly) {
  const TriMesh mesh = make_shape("panel", 190);
  double best = e_max_of(mesh);
  int idle = 0, better_after_idle = 0;
  TriMesh now = mesh;
  const Patch patch(mesh);
  Evolver evolver(patch, LocalPerturbation{});
  for (int sweep = 0; sweep < 10 && better_after_idle == 0; ++sweep) {
    const SweepRecord record = evolver.step();
    now.positions = evolver.positions();
    EXPECT_LE(record.e_max, best);
    EXPECT_NEAR(record.e_max, e_max_of(now), 1e-14);
    idle += record.e_max == best && record.moved > 0;
    better_after_idle += record.e_max < best && idle > 0;
    best = record.e_max;
  }
  // Some sweeps ended worse, and those after went on from there: else this would tell nothing.
  EXPECT_GT(idle, 0);
  EXPECT_GT(better_after_idle, 0);
}

TEST(LocalPerturbation, EndsWhereNothingBetterIsFound) {
  // Steps as long as they may be, on what is far from flattenable.
  for (const char* shape : {"dome", "saddle"}) {
    const TriMesh mesh = make_shape(shape, 100);
    const auto result = evolve(Patch(mesh), LocalPerturbation{.tau = 1.0}, {.max_sweeps = 500});
    EXPECT_TRUE(result.stop == StopReason::converged || result.stop == StopReason::stalled);
    EXPECT_LE(e_max_of({result.positions, mesh.triangles}), e_max_of(mesh));
  }
}

TEST(LocalPerturbation, IsDoneAtOnceWhereLittleIsWrong) {
  const TriMesh mesh = disturbed("cone", 300, 0.001);
  const auto result = evolve(Patch(mesh), LocalPerturbation{.enough = 2.0 * e_max_of(mesh)});
  EXPECT_EQ(result.stop, StopReason::converged);
  EXPECT_EQ(result.positions, mesh.positions);
  EXPECT_EQ(result.history.size(), 1U);
}

TEST(LocalPerturbation, KeepsEveryTriangleAnArea) {
  // So rough that triangles lie on their neighbours.
  const TriMesh mesh = meshes::rough_grid(12, 12, 7, 0.6, 1.5);
  const auto smallest_height = [](const TriMesh& m) {
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle& t : m.triangles) {
      const Vec3 a = m.positions[t[1]] - m.positions[t[0]],
                 b = m.positions[t[2]] - m.positions[t[0]];
      least = std::min(least, norm(cross(a, b)) / std::max({norm(a), norm(b), norm(b - a)}));
    }
    return least;
  };
  const auto result = evolve(Patch(mesh), LocalPerturbation{.tau = 1.0}, {.max_sweeps = 5});
  EXPECT_NE(result.positions, mesh.positions);
  EXPECT_GT(smallest_height({result.positions, mesh.triangles}), 0.0);
  for (const Vec3 p : result.positions)
    EXPECT_TRUE(std::isfinite(norm(p)));
}

TEST(LocalPerturbation, StaysWithinTheDeviation) {
  const TriMesh mesh = disturbed("cylinder", 200);
  const auto result =
      evolve(Patch(mesh), LocalPerturbation{.max_deviation = 0.05}, {.max_sweeps = 10});
  double farthest = 0.0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    farthest = std::max(farthest, norm(result.positions[v] - mesh.positions[v]));
  EXPECT_LE(farthest, 0.05);
  EXPECT_GT(farthest, 0.04);
}

TEST(LocalPerturbation, MovesTheDearLess) {
  const TriMesh mesh = disturbed("cone", 350);
  const auto moved_by = [&](double weight) {
    Constraints constraints{.weights = std::vector<double>(mesh.positions.size(), 1.0)};
    for (std::size_t v = 0; v < mesh.positions.size(); v += 2)
      constraints.weights[v] = weight;
    const auto result = evolve(Patch(mesh), LocalPerturbation{}, {.max_sweeps = 5}, constraints);
    double dear = 0.0;
    for (std::size_t v = 0; v < mesh.positions.size(); v += 2)
      dear += norm(result.positions[v] - mesh.positions[v]);
    return dear;
  };
  EXPECT_LT(moved_by(3.0), 0.6 * moved_by(1.0));
  EXPECT_GT(moved_by(0.3), moved_by(1.0));
}

TEST(LocalPerturbation, OfEqualWeightsDoesNotDependOnTheirSize) {
  const TriMesh mesh = disturbed("cone", 150);
  const auto with = [&](double weight) {
    const Constraints constraints{.weights = std::vector(mesh.positions.size(), weight)};
    return evolve(Patch(mesh), LocalPerturbation{}, {.max_sweeps = 3}, constraints).positions;
  };
  EXPECT_EQ(with(1.0), evolve(Patch(mesh), LocalPerturbation{}, {.max_sweeps = 3}).positions);
  EXPECT_EQ(with(4.0), with(1.0));
}

TEST(LocalPerturbation, GivesTheSameBitsAlways) {
  const TriMesh mesh = draped(0.01);
  const Constraints constraints{.obstacle = solids::cube()};
  const auto run = [&](unsigned threads) {
    return evolve(Patch(mesh), LocalPerturbation{}, {.max_sweeps = 4}, constraints,
                  {.threads = threads})
        .positions;
  };
  const auto once = run(1);
  EXPECT_NE(once, mesh.positions);
  for (const unsigned threads : {1U, 2U, 4U})
    EXPECT_EQ(run(threads), once) << threads;
}

TEST(LocalPerturbation, DoesTheSameToAPatchOfAnotherSize) {
  TriMesh mesh = draped(0.01), larger = mesh;
  Constraints constraints{.obstacle = solids::cube()};
  const auto small =
      evolve(Patch(mesh), LocalPerturbation{.clearance = 0.005}, {.max_sweeps = 3}, constraints);
  for (Vec3& p : larger.positions)
    p = 1024.0 * p;
  for (Vec3& p : constraints.obstacle.positions)
    p = 1024.0 * p;
  const auto large =
      evolve(Patch(larger), LocalPerturbation{.clearance = 5.12}, {.max_sweeps = 3}, constraints);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    EXPECT_EQ(large.positions[v], 1024.0 * small.positions[v]);
}

class Obstacles : public testing::TestWithParam<const char*> {
 protected:
  TriMesh obstacle() const {
    return GetParam() == std::string("cube") ? solids::cube() : solids::sphere(1.0, 8);
  }
  /// Rests on the obstacle.
  TriMesh patch(double above) const {
    if (GetParam() == std::string("cube")) return draped(above);
    TriMesh mesh = meshes::flat_grid(5, 5);
    meshes::Random random(6);
    for (Vec3& p : mesh.positions) {
      const double x = 0.24 * p.x - 0.6, y = 0.24 * p.y - 0.6;
      const double r = 1.0 + above + 0.02 * std::abs(random.number());
      p = r / std::sqrt(x * x + y * y + 1.0) * Vec3{x, y, 1.0};
    }
    return mesh;
  }
};

TEST_P(Obstacles, AreNotEntered) {
  const TriMesh mesh = patch(0.0);
  const SignedDistance distance(obstacle());
  ASSERT_GE(least_distance(mesh, distance), 0.0);
  const auto free = evolve(Patch(mesh), LocalPerturbation{}, {.max_sweeps = 8});
  EXPECT_LT(least_distance({free.positions, mesh.triangles}, distance), -1e-4);
  const auto kept =
      evolve(Patch(mesh), LocalPerturbation{}, {.max_sweeps = 8}, {.obstacle = obstacle()});
  EXPECT_GE(least_distance({kept.positions, mesh.triangles}, distance), 0.0);
  // It still does something for the patch.
  EXPECT_LT(kept.history.back().e_max, 0.8 * e_max_of(mesh));
}

TEST_P(Obstacles, KeepTheirClearance) {
  const TriMesh mesh = patch(0.02);
  const SignedDistance distance(obstacle());
  ASSERT_GE(least_distance(mesh, distance), 0.015);
  const auto kept = evolve(Patch(mesh), LocalPerturbation{.clearance = 0.015}, {.max_sweeps = 8},
                           {.obstacle = obstacle()});
  EXPECT_NE(kept.positions, mesh.positions);
  // But for rounding, as the method computes in another unit.
  EXPECT_GE(least_distance({kept.positions, mesh.triangles}, distance), 0.015 - 1e-14);
}

TEST_P(Obstacles, PushOutWhatBeginsInside) {
  const TriMesh mesh = patch(-0.03);
  const SignedDistance distance(obstacle());
  ASSERT_LT(least_distance(mesh, distance), -0.02);
  TriMesh now = mesh;
  const Patch surface(mesh);
  const Constraints constraints{.obstacle = obstacle()};
  Evolver evolver(surface, LocalPerturbation{}, constraints);
  for (int sweep = 0; sweep < 5; ++sweep) {
    const std::vector<Vec3> before = evolver.positions();
    evolver.step();
    now.positions = evolver.positions();
    for (const Index v : surface.inner_vertices()) {
      const double was = distance.at(before[v]).value, is = distance.at(now.positions[v]).value;
      EXPECT_GE(is, std::min(was, 0.0) - 1e-15);
    }
  }
  EXPECT_GE(least_distance(now, distance), 0.0);
}

TEST_P(Obstacles, LeaveFixedVerticesWhereTheyAre) {
  const TriMesh mesh = patch(-0.03);
  const Patch surface(mesh);
  Constraints constraints{.obstacle = obstacle()};
  for (const Index v : surface.inner_vertices()) {
    if (v % 2 == 0) constraints.fixed.push_back(v);
  }
  const auto result = evolve(surface, LocalPerturbation{}, {.max_sweeps = 5}, constraints);
  EXPECT_NE(result.positions, mesh.positions);
  for (const Index v : constraints.fixed)
    EXPECT_EQ(result.positions[v], mesh.positions[v]);
}

INSTANTIATE_TEST_SUITE_P(LocalPerturbation, Obstacles, testing::Values("cube", "sphere"),
                         [](const auto& test) { return std::string(test.param); });

TEST(LocalPerturbation, RefusesAnObstacleWithoutAnInside) {
  const TriMesh mesh = draped(0.1);
  try {
    evolve(Patch(mesh), LocalPerturbation{}, {}, {.obstacle = meshes::flat_grid(4, 4)});
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::open_surface);
    EXPECT_EQ(error.message().rfind("the obstacle: ", 0), 0U) << error.message();
  }
}

}  // namespace
}  // namespace planish
