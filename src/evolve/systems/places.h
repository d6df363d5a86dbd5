#pragma once

#include <cstddef>
#include <vector>

#include <planish/core/vec.h>

#include <Eigen/Core>

#include "evolve/state/patch_state.h"
#include "evolve/systems/angle_jacobian.h"

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

/// The patch as it was at first, in model units and the numbers of the state.
TriMesh mesh_at_first(const PatchState& state);

/// Their defects, as of the last measure().
Eigen::VectorXd inner_defects(const PatchState& state);

/// Puts the movable vertices there, if all places are numbers.
/// @return how many were elsewhere before
std::size_t move_to(const Places& places, const AngleJacobian& jacobian, PatchState& state);

/// The nearest of the places of all vertices that may move that are within a distance of their
/// origins, infinite for none.
/// @param inner_count how many of them are inner vertices: only these are limited
Places within_distance(Places places, const Places& origin, std::size_t inner_count,
                       double distance);

/// The unit normal of an inner vertex, its triangles weighing as their areas; zero where they
/// cancel.
Vec3 normal_at(Index v, const AngleJacobian& jacobian, const PatchState& state);

/// Mean and shortest length of the edges at a vertex.
struct EdgeLengths {
  double mean = 0.0, shortest = 0.0;
};
EdgeLengths edges_at(Index v, const AngleJacobian& jacobian, const PatchState& state);

/// The mean over the inner vertices of the mean length of their edges.
double mean_edge(const AngleJacobian& jacobian, const PatchState& state);

}  // namespace planish
