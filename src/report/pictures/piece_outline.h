#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <planish/flatten/product.h>

namespace planish {

/// A side of a seam along the border of a piece.
struct OutlinedSeam {
  std::size_t number = 1;       ///< from 1, written at its middle
  std::vector<Index> vertices;  ///< of the piece, from end to end
};

/// The class that gives a seam its colour on a page, of eight in turn.
std::string seam_class(std::size_t number);

/// The outline of a pattern as SVG for a page, fitted into a window that is alike for all pieces:
/// the border, and over it each seam in its colour with its number.
/// @param mesh of the piece, a patch
/// @param pattern a position for each vertex
/// @param alt what it shows, plain text
std::string piece_outline(const TriMesh& mesh, std::span<const Vec2> pattern,
                          std::span<const OutlinedSeam> seams, const std::string& alt);

}  // namespace planish
