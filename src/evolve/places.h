#pragma once

#include <cstddef>
#include <vector>

#include <planish/core/vec.h>

#include <Eigen/Core>

#include "evolve/angle_jacobian.h"
#include "evolve/patch_state.h"

namespace planish {

/// Places, or moves, of all inner vertices: what methods with global solves work on. Those of the
/// border follow where it may move.
using Places = std::vector<Vec3>;

/// a + s b
Places sum_of(Places a, double s, const Places& b);

double norm_of(const Places& a);

/// Where the vertices before number `count` are.
Places first_places(const PatchState& state, std::size_t count);

/// Where the inner vertices are.
Places inner_places(const PatchState& state);

/// Their defects, as of the last measure().
Eigen::VectorXd inner_defects(const PatchState& state);

/// Puts the movable vertices there, if all places are numbers.
/// @return how many were elsewhere before
std::size_t move_to(const Places& places, const AngleJacobian& jacobian, PatchState& state);

/// Mean and shortest length of the edges at a vertex.
struct EdgeLengths {
  double mean = 0.0, shortest = 0.0;
};
EdgeLengths edges_at(Index v, const AngleJacobian& jacobian, const PatchState& state);

/// The mean over the inner vertices of the mean length of their edges.
double mean_edge(const AngleJacobian& jacobian, const PatchState& state);

}  // namespace planish
