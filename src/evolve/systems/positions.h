#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/core/vec.h>

#include <Eigen/Core>

#include "energy/angle_jacobian.h"
#include "evolve/state/patch_state.h"
#include "mesh/symmetry/mirror_orbits.h"

namespace planish {

/// Positions, or moves, of all inner vertices: what methods with global solves work on. Those of
/// the border follow where it may move.
using Positions = std::vector<Vec3>;

/// a + s b
Positions sum_of(Positions a, double s, const Positions& b);

double norm_of(const Positions& a);

/// Where the vertices before number `count` are.
Positions first_positions(const PatchState& state, std::size_t count);

/// Where all vertices are.
Positions all_positions(const PatchState& state);

/// Where the vertices before number `count` were at first.
Positions first_origins(const PatchState& state, std::size_t count);

/// Where the inner vertices are.
Positions inner_positions(const PatchState& state);

/// The patch as it was at first, in model units and the numbers of the state.
TriMesh mesh_at_first(const PatchState& state);

/// The Jacobian of the angle sums. Vertices that are fixed are held, and those of many hundred
/// neighbours: each would tie all its neighbours' rows to one another.
/// @param state must outlive it
/// @param border_movable by vertex of the border whether it may move; empty: none may
/// @param holes as from hole_borders_of(), if they are to close
AngleJacobian angle_jacobian_of(const PatchState& state,
                                std::span<const unsigned char> border_movable = {},
                                std::vector<HoleBorder> holes = {});

/// The borders of the holes that stay in the pattern: none of what has to be cut open to be laid
/// flat.
std::vector<HoleBorder> hole_borders_of(const PatchState& state);

/// Whether the holes of a patch whose vertices are at these positions close in the plane, as
/// is_flattenable() asks for: true where there are none.
/// @param share of what that allows
bool holes_close(const Patch& patch, std::vector<Vec3> positions, double share = 1.0);

/// The defects of the inner vertices, as of the last measure().
Eigen::VectorXd inner_defects(const PatchState& state);

/// Puts the movable vertices there, if all positions are numbers.
/// @return how many were elsewhere before
std::size_t set_positions(const Positions& positions, const AngleJacobian& jacobian,
                          PatchState& state);

/// The nearest of the positions of all vertices that may move that are within a distance of their
/// origins, infinite for none.
/// @param inner_count how many of them are inner vertices: only these are limited
Positions within_distance(Positions positions, const Positions& origin, std::size_t inner_count,
                          double distance);

/// Positions whose moves from an origin are the means of these and of their mirror images; the same
/// where the patch is not symmetric.
Positions symmetric_about(const Positions& origin, const MirrorOrbits& orbits, Positions positions);

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
