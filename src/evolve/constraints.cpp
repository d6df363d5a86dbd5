#include <algorithm>
#include <cmath>
#include <string>

#include <planish/core/error.h>
#include <planish/evolve/constraints.h>

#include "evolve/state/fixed_marks.h"
#include "mesh/search/signed_distance.h"

namespace planish {

bool honours_weights(const Method& method) {
  return std::visit([](const auto& options) { return options.honours_weights; }, method);
}

bool honours_obstacle(const Method& method) {
  return std::visit([](const auto& options) { return options.honours_obstacle; }, method);
}

std::vector<unsigned char> fixed_marks(const Constraints& constraints, std::size_t vertices) {
  std::vector<unsigned char> marks(constraints.fixed.empty() ? 0 : vertices, 0);
  for (const Index v : constraints.fixed)
    marks[v] = 1;
  return marks;
}

Constraints restricted_to(const Constraints& constraints, std::span<const Index> source) {
  Constraints some;
  some.obstacle = constraints.obstacle;
  some.symmetric_in = constraints.symmetric_in;
  const auto fixed = fixed_marks(constraints, source.empty() ? 0 : source.back() + std::size_t{1});
  for (Index v = 0; v < source.size(); ++v) {
    if (!fixed.empty() && fixed[source[v]] != 0) some.fixed.push_back(v);
    if (!constraints.weights.empty()) some.weights.push_back(constraints.weights[source[v]]);
  }
  return some;
}

namespace {

void check_fixed(const std::vector<Index>& fixed, std::size_t vertex_count) {
  const auto missing =
      std::find_if(fixed.begin(), fixed.end(), [&](Index v) { return v >= vertex_count; });
  if (missing == fixed.end()) return;
  throw Error(ErrorCode::index_out_of_range,
              "vertex " + std::to_string(*missing) + " is to be fixed, but the mesh has " +
                  std::to_string(vertex_count) + " vertices, numbered from 0");
}

void check_weights(const std::vector<double>& weights, std::size_t vertex_count) {
  if (weights.empty()) return;
  if (weights.size() != vertex_count) {
    throw Error(ErrorCode::option_out_of_range, "there are " + std::to_string(weights.size()) +
                                                    " weights for " + std::to_string(vertex_count) +
                                                    " vertices; there must be one for each");
  }
  const auto bad = std::find_if(weights.begin(), weights.end(),
                                [](double w) { return !(w >= 1e-6 && w <= 1e6); });
  if (bad == weights.end()) return;
  throw Error(ErrorCode::option_out_of_range, "the weight of vertex " +
                                                  std::to_string(bad - weights.begin()) +
                                                  " must be a number from 1e-6 to 1e6");
}

[[noreturn]] void refuse(const Method& method, const std::string& what) {
  throw Error(ErrorCode::unsupported_constraint, "method " + std::string(name_of(method)) +
                                                     " cannot honour " + what +
                                                     ": leave that out or take another method");
}

}  // namespace

void check_constraints(const Constraints& constraints, std::size_t vertex_count,
                       const Method& method) {
  check_fixed(constraints.fixed, vertex_count);
  check_weights(constraints.weights, vertex_count);
  if (!constraints.weights.empty() && !honours_weights(method)) refuse(method, "weights");
  if (!constraints.obstacle.triangles.empty() && !honours_obstacle(method))
    refuse(method, "an obstacle");
  if (!constraints.obstacle.triangles.empty()) require_closed(constraints.obstacle, "the obstacle");
}

}  // namespace planish
