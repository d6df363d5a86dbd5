#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// Which vertices become one so that borders are joined.
struct Gluing {
  std::vector<Index> first;           ///< of each vertex the smallest that it is one with
  std::vector<unsigned char> turned;  ///< of each triangle: to be turned over
  std::size_t joined = 0;             ///< pairs of border edges that become one
  std::size_t left = 0;               ///< border edges at one place that cannot
  double length = 0.0;                ///< of those that are joined, each once
};

/// Pairs border edges whose ends are at the same places and joins as many of them as leave the mesh
/// sound: see weld().
/// @param mesh at the scale of unit_scale()
/// @param place of each vertex; the vertices at one place have the same
Gluing find_gluing(const TriMesh& mesh, std::span<const Index> place);

}  // namespace planish
