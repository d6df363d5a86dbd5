#pragma once

#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// A piece that lies on another one all over.
struct LyingPiece {
  Index piece, on;
};

/// How far apart pieces that lie on each other may be.
enum class Lying : unsigned char {
  closely,  ///< within default_weld_length(), and each of them on the other
  meshed,   ///< or also as far as facets of one surface meshed twice are: 5 % of their edges
};

/// Finds them by samples; of two that lie on each other the later one. What others lie on lies on
/// none itself. Of more than 1000 pieces none is looked at.
/// @param piece_of of each triangle, below `pieces`
std::vector<LyingPiece> find_lying_pieces(const TriMesh& mesh, std::span<const Index> piece_of,
                                          std::size_t pieces, Lying way);

}  // namespace planish
