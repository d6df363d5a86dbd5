#include <cmath>
#include <functional>

#include <planish/core/error.h>
#include <planish/evolve/evolve.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

TriMesh patch() {
  return make_shape("panel", 900);
}

/// Every other of the vertices that the method moves.
std::vector<Index> every_other_moved(const TriMesh& mesh, const Method& method) {
  const auto free = evolve(Patch(mesh), method, {.max_sweeps = 3});
  std::vector<Index> moved, some;
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    if (free.positions[v] != mesh.positions[v]) moved.push_back(v);
  }
  for (std::size_t i = 0; i < moved.size(); i += 2)
    some.push_back(moved[i]);
  return some;
}

class FixedVertices : public testing::TestWithParam<Method> {};

TEST_P(FixedVertices, StayWhereTheyAreWhileOthersMove) {
  const TriMesh mesh = patch();
  const Constraints constraints{.fixed = every_other_moved(mesh, GetParam())};
  EXPECT_GT(constraints.fixed.size(), 10U);
  const auto held = evolve(Patch(mesh), GetParam(), {.max_sweeps = 3}, constraints);
  for (const Index v : constraints.fixed)
    EXPECT_EQ(held.positions[v], mesh.positions[v]);
  EXPECT_NE(held.positions, mesh.positions);
}

TEST(FixedVerticesOfControllable, StayWithTheOtherSolverToo) {
  const TriMesh mesh = patch();
  const ControllableLaplacian options{.solver = LineSolver::trust_region};
  const Constraints constraints{.fixed = every_other_moved(mesh, options)};
  const auto held = evolve(Patch(mesh), options, {.max_sweeps = 3}, constraints);
  for (const Index v : constraints.fixed)
    EXPECT_EQ(held.positions[v], mesh.positions[v]);
  EXPECT_NE(held.positions, mesh.positions);
}

TEST_P(FixedVertices, MayBeAll) {
  const TriMesh mesh = patch();
  Constraints constraints;
  for (Index v = 0; v < mesh.positions.size(); ++v)
    constraints.fixed.push_back(v);
  const auto result = evolve(Patch(mesh), GetParam(), {.max_sweeps = 3}, constraints);
  EXPECT_EQ(result.positions, mesh.positions);
  EXPECT_NE(result.stop, StopReason::reached_target);
}

template <std::size_t... I>
std::vector<Method> all_methods(std::index_sequence<I...>) {
  return {Method(std::variant_alternative_t<I, Method>{})...};
}

INSTANTIATE_TEST_SUITE_P(
    AllMethods, FixedVertices,
    testing::ValuesIn(all_methods(std::make_index_sequence<k_named_methods>())),
    [](const auto& test) { return std::string(name_of(test.param)); });

ErrorCode error_of(const Constraints& constraints, const Method& method = {}) {
  try {
    evolve(Patch(patch()), method, {}, constraints);
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "no error";
  return {};
}

TEST(Constraints, MustNameVerticesThatThereAre) {
  EXPECT_EQ(error_of({.fixed = {0, 1'000'000}}), ErrorCode::index_out_of_range);
}

TEST(Constraints, MustWeighEveryVertexAboveZero) {
  const std::size_t count = patch().positions.size();
  std::vector<double> weights(count, 1.0);
  weights.pop_back();
  EXPECT_EQ(error_of({.weights = weights}), ErrorCode::option_out_of_range);
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    weights.assign(count, 1.0);
    weights[5] = bad;
    EXPECT_EQ(error_of({.weights = weights}), ErrorCode::option_out_of_range) << bad;
  }
}

TEST(Constraints, ThatAMethodCannotHonourAreRefused) {
  const TriMesh mesh = patch();
  const std::vector<double> weights(mesh.positions.size(), 1.0);
  EXPECT_EQ(error_of({.weights = weights}, ControllableLaplacian{}),
            ErrorCode::unsupported_constraint);
  EXPECT_EQ(error_of({.obstacle = mesh}, ControllableLaplacian{}),
            ErrorCode::unsupported_constraint);
}

}  // namespace
}  // namespace planish
