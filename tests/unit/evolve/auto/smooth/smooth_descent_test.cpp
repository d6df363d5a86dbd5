#include "evolve/auto/smooth/smooth_descent.h"

#include <cmath>
#include <optional>

#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

constexpr SmoothWeights k_weights{.delta = 0.01, .sigma = 0.005};

/// @param height over that of the panel
TriMesh panel(double height = 1.0) {
  TriMesh mesh = make_shape("panel", 400);
  for (Vec3& p : mesh.positions)
    p.z *= height;
  return mesh;
}

class PanelDescent {
 public:
  explicit PanelDescent(SmoothMoves moves, const TriMesh& design = panel(),
                        const BorderFreedom& border = {})
      : state_(Patch(design), pool_),
        descent_(state_, pool_, Patch(mesh_at_first(state_)), {.border = border}, moves) {}

  /// Each of the border's vertices goes so far another way in the plane of x and y.
  /// @return how many they are
  std::size_t disturb_border(double distance) {
    Positions positions = descent_.positions();
    for (std::size_t v = state_.inner_count(); v < positions.size(); ++v) {
      const auto angle = static_cast<double>(v);
      positions[v] += distance * Vec3{std::cos(angle), std::sin(angle), 0.0};
    }
    descent_.go_to(positions);
    return positions.size() - state_.inner_count();
  }
  void shift(Vec3 way) {
    Positions positions = descent_.positions();
    for (Vec3& p : positions)
      p += way;
    descent_.go_to(positions);
  }
  std::size_t movable_count() const { return descent_.positions().size(); }
  std::optional<double> border_reach() const { return descent_.border_reach(); }

  /// Each of the inner vertices goes so many edges another way in the plane of x and y.
  void disturb(double edges) {
    const double distance = edges * mean_edge(descent_.jacobian(), state_);
    Positions positions = descent_.positions();
    for (std::size_t v = 0; v < positions.size(); ++v) {
      const auto angle = static_cast<double>(v);
      positions[v] += distance * Vec3{std::cos(angle), std::sin(angle), 0.0};
    }
    descent_.go_to(positions);
  }

  SmoothDescent::Step step(const SmoothWeights& weights = k_weights) {
    return descent_.step(weights);
  }
  double bending() const { return descent_.bending(); }
  double deviation() const { return descent_.deviation(); }

  SmoothDescent::Step last_of(int steps) {
    for (int k = 1; k < steps; ++k)
      step();
    return step();
  }

 private:
  ThreadPool pool_{1};
  PatchState state_;
  SmoothDescent descent_;
};

TEST(SmoothDescent, LowersTheMeritWithEachStep) {
  PanelDescent free(SmoothMoves::free), along_lines(SmoothMoves::along_lines);
  for (int k = 0; k < 4; ++k) {
    const auto freely = free.step(), lines = along_lines.step();
    EXPECT_LT(freely.merit, freely.merit_before) << k;
    EXPECT_LT(lines.merit, lines.merit_before) << k;
    EXPECT_EQ(freely.parts, 1);
    EXPECT_EQ(lines.parts, 3);
  }
}

TEST(SmoothDescent, LowersTheMeritWithEachStepWhereTheBorderMoves) {
  for (const BorderFreedom& border : {BorderFreedom{BorderFreedom::Rule::slide, 0.0},
                                      BorderFreedom{BorderFreedom::Rule::within, 1.0}}) {
    for (const SmoothMoves moves : {SmoothMoves::free, SmoothMoves::along_lines}) {
      PanelDescent descent(moves, panel(), border);
      for (int k = 0; k < 4; ++k) {
        const auto step = descent.step();
        EXPECT_LT(step.merit, step.merit_before) << k;
      }
    }
  }
}

TEST(SmoothDescent, MovesInAPlaneAlongLinesToo) {
  PanelDescent descent(SmoothMoves::along_lines, panel(0.0));
  descent.disturb(0.1);
  const double before = descent.deviation();
  descent.last_of(10);
  EXPECT_LT(descent.deviation(), 0.01 * before);
}

TEST(SmoothDescent, CountsTheMovesOfTheBorder) {
  constexpr double reach = 1.0, distance = 0.1, much = 1e6;  // so that strain does not count
  const BorderFreedom border = {BorderFreedom::Rule::within, reach};
  PanelDescent near(SmoothMoves::free, panel(), border), far(SmoothMoves::free, panel(), border);
  const double diagonal = reach / near.border_reach().value();
  const auto moved = static_cast<double>(near.disturb_border(distance));
  far.disturb_border(distance);
  const double share = moved / static_cast<double>(near.movable_count());
  EXPECT_NEAR(near.deviation(), std::sqrt(share) * distance / diagonal, 1e-12);
  const double close = near.step({.delta = 0.01, .sigma = much}).merit_before,
               loose = far.step({.delta = 0.02, .sigma = much}).merit_before;
  EXPECT_NEAR(close - loose, share * std::pow(distance / diagonal, 2) * (1e4 - 2.5e3),
              1e-9 * close);
}

TEST(SmoothDescent, BringsBackAPlaneAndItsBorder) {
  PanelDescent descent(SmoothMoves::free, panel(0.0), {BorderFreedom::Rule::within, 1.0});
  descent.shift({0.1, 0.05, 0.0});
  const double before = descent.deviation();
  descent.last_of(20);
  EXPECT_LT(descent.deviation(), 1e-3 * before);
}

TEST(SmoothDescent, SaysHowFarTheBorderMayMove) {
  using Rule = BorderFreedom::Rule;
  const auto reach = [](Rule rule, double distance) {
    return PanelDescent(SmoothMoves::free, panel(), {rule, distance}).border_reach();
  };
  EXPECT_FALSE(reach(Rule::fixed, 0.0));
  EXPECT_EQ(reach(Rule::slide, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(reach(Rule::within, 2.0).value(), 2.0 * reach(Rule::within, 1.0).value());
}

TEST(SmoothDescent, KeepsTheFormWhereStrainMayStay) {
  constexpr double much = 1e6;  // so that strain does not count
  PanelDescent as_designed(SmoothMoves::free), halfway(SmoothMoves::free);
  const double before = as_designed.bending();
  for (int k = 0; k < 10; ++k) {
    as_designed.step({.delta = 1.0, .sigma = much, .form = 1.0});
    halfway.step({.delta = 1.0, .sigma = much, .form = 0.5});
  }
  EXPECT_LT(as_designed.deviation(), 1e-9);
  EXPECT_NEAR(as_designed.bending(), before, 1e-9);
  EXPECT_GT(halfway.bending(), 0.2 * before);
  EXPECT_LT(halfway.bending(), 0.9 * before);
}

TEST(SmoothDescent, ComesAsFarAlongLinesAsFreely) {
  PanelDescent free(SmoothMoves::free), along_lines(SmoothMoves::along_lines);
  const double least = free.last_of(30).merit;
  EXPECT_LT(along_lines.last_of(10).merit, 1.02 * least);
  EXPECT_NEAR(along_lines.bending(), free.bending(), 0.02);
  EXPECT_NEAR(along_lines.deviation(), free.deviation(), 0.02 * free.deviation());
}

}  // namespace
}  // namespace planish
