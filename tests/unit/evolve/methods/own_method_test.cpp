#include <limits>
#include <set>
#include <stdexcept>

#include <planish/core/error.h>
#include <planish/evolve/evolve.h>
#include <planish/evolve/own_method.h>
#include <planish/flatten/compare.h>
#include <planish/mesh/shapes.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/laplacian.h"
#include "support/meshes.h"

namespace planish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// What `classical` does with simultaneous moves, from outside.
OwnMethod classical_from_outside(double lambda) {
  return {.name = "mine", .sweep = [lambda](const SweepInput& input) {
            std::vector<Vec3> after = input.positions;
            for (const Index v : input.movable) {
              const auto ring = input.design.ring(v);
              const Vec3 x = input.positions[v];
              after[v] = x + lambda * edge_weighted_laplacian(x, ring.size(), [&](std::size_t j) {
                               return input.positions[ring[j]];
                             });
            }
            return after;
          }};
}

OwnMethod lifting(double by) {
  return {.name = "lift", .sweep = [by](const SweepInput& input) {
            std::vector<Vec3> after = input.positions;
            for (Vec3& p : after)
              p.z += by;
            return after;
          }};
}

ErrorCode error_of(const OwnMethod& method) {
  try {
    evolve(Patch(make_shape("dome", 100)), method);
  } catch (const Error& error) {
    EXPECT_FALSE(error.message().empty());
    return error.code();
  }
  ADD_FAILURE() << "no error";
  return {};
}

TEST(OwnMethod, GivesTheBitsOfAMethodOfTheLibraryThatDoesTheSame) {
  const Patch patch(make_shape("panel", 1500));
  const ClassicalLaplacian theirs{.lambda = 0.4, .order = SweepOrder::simultaneous};
  const Stopping stopping{.max_sweeps = 6};
  const EvolveResult expected = evolve(patch, theirs, stopping);
  for (const unsigned threads : {1U, 2U}) {
    const EvolveResult own =
        evolve(patch, classical_from_outside(0.4), stopping, {}, {.threads = threads});
    EXPECT_EQ(own.positions, expected.positions);
    ASSERT_EQ(own.history.size(), expected.history.size());
    for (std::size_t k = 0; k < own.history.size(); ++k) {
      EXPECT_EQ(own.history[k].energy, expected.history[k].energy);
      EXPECT_EQ(own.history[k].e_max, expected.history[k].e_max);
      EXPECT_EQ(own.history[k].moved, expected.history[k].moved);
    }
  }
}

TEST(OwnMethod, EndsAtTheTargetAtTheLimitAndWhereNothingMoves) {
  const Patch patch(make_shape("panel", 1000));
  const double first =
      evolve(patch, classical_from_outside(0.4), {.max_sweeps = 1}).history[0].e_max;
  const EvolveResult met =
      evolve(patch, classical_from_outside(0.4), {.max_sweeps = 50, .target_e_max = 0.9 * first});
  EXPECT_EQ(met.stop, StopReason::reached_target);
  EXPECT_GT(met.history.size(), 1U);
  const EvolveResult limited = evolve(patch, classical_from_outside(0.4));
  EXPECT_EQ(limited.stop, StopReason::sweep_limit);
  EXPECT_EQ(limited.history.size(), 10U);
  const EvolveResult still = evolve(patch, lifting(0.0));
  EXPECT_EQ(still.stop, StopReason::stalled);
  EXPECT_EQ(still.history.size(), 1U);
  EXPECT_EQ(still.positions, patch.positions());
}

TEST(OwnMethod, IsGivenEachSweepWhereTheLastOneEnded) {
  const Patch patch(make_shape("dome", 200));
  std::vector<int> sweeps;
  std::vector<Vec3> last = patch.positions();
  OwnMethod method = lifting(0.1);
  method.sweep = [&, lift = method.sweep](const SweepInput& input) {
    sweeps.push_back(input.sweep);
    EXPECT_EQ(input.positions, last);
    EXPECT_EQ(input.design.positions(), patch.positions());
    last = lift(input);
    for (Index v = 0; v < patch.vertex_count(); ++v) {
      if (patch.is_border(v)) last[v] = input.positions[v];
    }
    return last;
  };
  const EvolveResult result = evolve(patch, method, {.max_sweeps = 3});
  EXPECT_THAT(sweeps, ElementsAre(1, 2, 3));
  EXPECT_EQ(result.positions, last);
}

TEST(OwnMethod, MovesNeitherTheBorderNorFixedVerticesUnlessItMayMoveTheBorder) {
  const Patch patch(make_shape("dome", 200));
  const Index fixed = patch.inner_vertices()[3];
  for (const bool moves_border : {false, true}) {
    OwnMethod method = lifting(0.5);
    method.moves_border = moves_border;
    const EvolveResult result = evolve(patch, method, {.max_sweeps = 1}, {.fixed = {fixed}});
    for (Index v = 0; v < patch.vertex_count(); ++v) {
      const bool moves = v != fixed && (moves_border || patch.is_inner(v));
      EXPECT_EQ(result.positions[v] != patch.positions()[v], moves) << v;
    }
  }
}

TEST(OwnMethod, NamesTheVerticesThatMayMoveInOrder) {
  const Patch patch(make_shape("dome", 200));
  const Index fixed = patch.inner_vertices()[3];
  std::vector<Index> expected(patch.inner_vertices().begin(), patch.inner_vertices().end());
  expected.erase(expected.begin() + 3);
  std::vector<Index> movable;
  const OwnMethod method{.sweep = [&](const SweepInput& input) {
    movable = input.movable;
    return input.positions;
  }};
  evolve(patch, method, {}, {.fixed = {fixed}});
  EXPECT_EQ(movable, expected);
}

TEST(OwnMethod, IsRefusedWhereItGivesBackWhatIsNoSurface) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_of({.sweep = [](const SweepInput&) { return std::vector<Vec3>(3); }}),
            ErrorCode::method_failed);
  EXPECT_EQ(error_of(lifting(nan)), ErrorCode::method_failed);
  EXPECT_EQ(error_of(lifting(1e300)), ErrorCode::method_failed);
  EXPECT_EQ(error_of({.name = "none"}), ErrorCode::option_out_of_range);
  OwnMethod nameless = lifting(1.0);
  nameless.name = "";
  EXPECT_EQ(error_of(nameless), ErrorCode::option_out_of_range);
}

TEST(OwnMethod, NamesTheVertexWhosePositionIsNoNumber) {
  const Patch patch(make_shape("dome", 100));
  const Index bad = patch.inner_vertices()[7];
  const OwnMethod method{.sweep = [&](const SweepInput& input) {
    std::vector<Vec3> after = input.positions;
    after[bad].y = std::numeric_limits<double>::infinity();
    return after;
  }};
  try {
    evolve(patch, method);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.place().first, std::size_t{bad});
    EXPECT_THAT(error.message(), HasSubstr("method own gave a position that is no number"));
  }
}

TEST(OwnMethod, PassesOnWhatItThrows) {
  const OwnMethod method{
      .sweep = [](const SweepInput&) -> std::vector<Vec3> { throw std::logic_error("of my own"); }};
  EXPECT_THROW(evolve(Patch(make_shape("dome", 100)), method), std::logic_error);
}

TEST(OwnMethod, CanBeCancelled) {
  int calls = 0;
  OwnMethod method = lifting(0.1);
  method.sweep = [&, lift = method.sweep](const SweepInput& input) {
    ++calls;
    return lift(input);
  };
  EXPECT_THROW(evolve(Patch(make_shape("dome", 100)), method, {.max_sweeps = 9}, {},
                      {.is_cancelled = [&] { return calls == 2; }}),
               Cancelled);
  EXPECT_EQ(calls, 2);
}

TEST(OwnMethod, HonoursNoWeightsAndNoObstacle) {
  const Patch patch(make_shape("dome", 100));
  const std::vector<double> weights(patch.vertex_count(), 2.0);
  EXPECT_THROW(evolve(patch, lifting(0.1), {}, {.weights = weights}), Error);
}

TEST(OwnMethod, IsComparedAndMeasuredAsOthersAre) {
  const Patch patch(make_shape("panel", 400));
  const ClassicalLaplacian theirs{.lambda = 0.4, .order = SweepOrder::simultaneous};
  const OwnMethod own = classical_from_outside(0.4);
  const OwnMethod fails{.name = "fails", .sweep = [](const SweepInput&) -> std::vector<Vec3> {
                          throw std::runtime_error("no licence");
                        }};
  const OwnMethod result = result_as_method("result", evolve(patch, theirs).positions);
  const CompareReport report = compare(
      patch, "panel", {{theirs, {}}, {own, {}}, {fails, {}}, {result, usual_stopping(result)}});
  ASSERT_EQ(report.runs.size(), 4U);
  EXPECT_EQ(name_of(report.runs[1].run.method), "mine");
  ASSERT_TRUE(report.runs[2].failure);
  EXPECT_EQ(report.runs[2].failure->code, "method_failed");
  EXPECT_THAT(report.runs[2].failure->message, HasSubstr("no licence"));
  const ComparedMethod& expected = report.runs[0];
  for (const std::size_t k : {1U, 3U}) {
    const ComparedMethod& run = report.runs[k];
    ASSERT_TRUE(run.evolve && run.unfold) << k;
    EXPECT_EQ(run.evolve->result.positions, expected.evolve->result.positions);
    EXPECT_EQ(run.evolve->deviation.rms, expected.evolve->deviation.rms);
    EXPECT_EQ(run.evolve->fairness.bending_ratio, expected.evolve->fairness.bending_ratio);
    EXPECT_EQ(run.unfold->strain.rms, expected.unfold->strain.rms);
    EXPECT_EQ(verdict_text(report, run), verdict_text(report, expected));
  }
}

TEST(OwnMethod, AResultKeepsItsBorder) {
  const Patch patch(make_shape("panel", 300));
  std::vector<Vec3> moved = patch.positions();
  for (Vec3& p : moved)
    p.x += 1.0;
  EXPECT_EQ(evolve(patch, result_as_method("moved", moved)).positions, moved);
}

}  // namespace
}  // namespace planish
