#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// A mesh with a border, as it is matched with others: lengths are those of the mesh times a
/// power of two.
struct WalkedMesh {
  double scale = 1.0;
  std::vector<Vec3> positions;
  Connectivity connectivity;
  std::size_t outer = 0;                    ///< number of the outer border loop
  std::vector<double> border_lengths = {};  ///< of the edges of that loop, by their first vertex
  double perimeter = 0.0;

  /// The outer loop.
  std::span<const Index> border() const { return connectivity.border_loops()[outer]; }
};

/// The mesh at the scale of unit_scale(); none where it has no border or is no oriented manifold.
std::optional<WalkedMesh> walked_mesh(const TriMesh& mesh);

/// The same at another scale.
/// @param scale a power of two
WalkedMesh rescaled(WalkedMesh mesh, double scale);

/// Steps that may be taken. Meshes that look alike everywhere could take very many.
struct WalkBudget {
  std::size_t left = 0;

  /// False where there are no more.
  bool take(std::size_t steps) {
    if (left < steps) return false;
    left -= steps;
    return true;
  }
};

/// Walks both meshes at once from the border edge of the first that begins its loop, in opposite
/// directions if mirrored, and pairs the vertices that are met.
/// @param start place in the second's loop of the vertex that is paired with the first's first one
/// @param tolerance of the lengths of edges
/// @return vertex of the first -> of the second; none where they do not correspond, or the budget
///   is used up
std::optional<std::vector<Index>> walk_both(const WalkedMesh& first, const WalkedMesh& second,
                                            bool mirrored, std::size_t start, double tolerance,
                                            WalkBudget& budget);

}  // namespace planish
