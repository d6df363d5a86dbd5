#include <limits>
#include <string>

#include <planish/core/error.h>
#include <planish/evolve/evolve.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

ErrorCode error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "no error";
  return {};
}

TEST(Evolve, StopsAtTheSweepLimit) {
  const auto result =
      evolve(Patch(make_shape("dome", 500)), ControllableLaplacian{}, {.max_sweeps = 4});
  EXPECT_EQ(result.stop, StopReason::sweep_limit);
  EXPECT_EQ(result.history.size(), 4U);
}

TEST(Evolve, StopsAtTheTarget) {
  const TriMesh mesh = make_shape("panel", 2000);
  const auto result =
      evolve(Patch(mesh), ControllableLaplacian{}, {.max_sweeps = 500, .target_e_max = 0.004});
  EXPECT_EQ(result.stop, StopReason::reached_target);
  ASSERT_GE(result.history.size(), 2U);
  EXPECT_LE(result.history.back().e_max, 0.004);
  EXPECT_GT(result.history[result.history.size() - 2].e_max, 0.004);
}

TEST(Evolve, DoesNothingWhereTheTargetIsMetAlready) {
  const TriMesh flat = meshes::flat_grid(8, 8);
  const auto result = evolve(Patch(flat));
  EXPECT_EQ(result.stop, StopReason::reached_target);
  EXPECT_TRUE(result.history.empty());
  EXPECT_EQ(result.positions, flat.positions);
}

TEST(Evolve, StopsWhenNothingMoves) {
  const auto result =
      evolve(Patch(meshes::ruffled_fan(6, 0.3)), ControllableLaplacian{}, {.max_sweeps = 9});
  EXPECT_EQ(result.stop, StopReason::stalled);
  EXPECT_EQ(result.history.size(), 1U);
  EXPECT_EQ(result.history[0].moved, 0U);
}

TEST(Evolve, ReportsProgressAfterEachSweepAndCanBeCancelledAfterAny) {
  std::vector<double> shares;
  const Context context{.on_progress =
                            [&](const Progress& progress) {
                              EXPECT_EQ(progress.stage, "evolving");
                              shares.push_back(progress.share);
                            },
                        .is_cancelled = [&] { return shares.size() == 3; }};
  EXPECT_THROW(evolve(Patch(make_shape("dome", 500)), ControllableLaplacian{}, {.max_sweeps = 50},
                      {}, context),
               Cancelled);
  EXPECT_THAT(shares, testing::ElementsAre(1.0 / 50, 2.0 / 50, 3.0 / 50));
}

TEST(Evolve, CanBeCancelledBeforeTheFirstSweep) {
  const Context context{.is_cancelled = [] { return true; }};
  EXPECT_THROW(evolve(Patch(make_shape("dome", 500)), Auto{}, {}, {}, context), Cancelled);
}

TEST(Evolve, WithoutSweepsReturnsTheInput) {
  const TriMesh mesh = make_shape("dome", 300);
  const auto result = evolve(Patch(mesh), ClassicalLaplacian{}, {.max_sweeps = 0});
  EXPECT_EQ(result.positions, mesh.positions);
  EXPECT_EQ(result.stop, StopReason::sweep_limit);
}

TEST(Evolve, IsTheLoopOverItsEvolver) {
  const TriMesh mesh = make_shape("panel", 900);
  const Patch patch(mesh);
  Evolver evolver(patch, ControllableLaplacian{});
  for (int sweep = 0; sweep < 5; ++sweep)
    evolver.step();
  EXPECT_EQ(evolver.positions(),
            evolve(patch, ControllableLaplacian{}, {.max_sweeps = 5}).positions);
}

TEST(Evolve, WorksOnTubesAndOnSeveralComponents) {
  TriMesh mesh = meshes::side_by_side(meshes::tube(9, 5), meshes::rough_grid(6, 6, 3));
  mesh.positions[20] = 1.3 * mesh.positions[20];
  const auto result = evolve(Patch(mesh));
  EXPECT_LT(result.history.back().energy, result.history.front().energy);
}

TEST(Evolve, LeavesASingleTriangleAlone) {
  const TriMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const auto result = evolve(Patch(mesh));
  EXPECT_EQ(result.positions, mesh.positions);
  EXPECT_EQ(result.stop, StopReason::reached_target);
}

TEST(Evolve, RefusesClosedSurfaces) {
  EXPECT_EQ(error_of([] { evolve(Patch(meshes::tetrahedron())); }), ErrorCode::closed_surface);
}

TEST(Evolve, RefusesOptionsOutOfRange) {
  const TriMesh mesh = meshes::flat_grid(3, 3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Method& method :
       {Method{ClassicalLaplacian{.lambda = 1.5}}, Method{ClassicalLaplacian{.lambda = nan}},
        Method{ControllableLaplacian{.lambda_min = 0.1}},
        Method{ControllableLaplacian{.lambda_max = -0.1}},
        Method{ControllableLaplacian{.min_angle = 61.0}},
        Method{ControllableLaplacian{.max_deviation = -1.0}}}) {
    EXPECT_EQ(error_of([&] { evolve(Patch(mesh), method); }), ErrorCode::option_out_of_range);
  }
  EXPECT_EQ(error_of([&] { evolve(Patch(mesh), ClassicalLaplacian{}, {.max_sweeps = -1}); }),
            ErrorCode::option_out_of_range);
  EXPECT_EQ(error_of([&] { evolve(Patch(mesh), ClassicalLaplacian{}, {.target_e_max = nan}); }),
            ErrorCode::option_out_of_range);
}

TEST(Method, IsFoundByItsName) {
  EXPECT_EQ(name_of(method_named("classical")), "classical");
  EXPECT_EQ(name_of(method_named("controllable")), "controllable");
  EXPECT_EQ(error_of([] { method_named("laplace"); }), ErrorCode::unknown_name);
}

struct OptionNames {
  std::string names;

  void operator()(std::string_view name, double, std::string_view doc, Range range) {
    names += std::string(name) + " ";
    EXPECT_FALSE(doc.empty());
    EXPECT_LE(range.min, range.max);
  }
  void operator()(std::string_view name, LineSolver, std::string_view doc) {
    names += std::string(name) + " ";
    EXPECT_FALSE(doc.empty());
  }
};

TEST(Method, DescribesEveryOptionOnce) {
  ControllableLaplacian options;
  OptionNames seen;
  describe(options, seen);
  EXPECT_EQ(seen.names, "lambda_min lambda_max min_angle max_deviation solver ");
}

}  // namespace
}  // namespace planish
