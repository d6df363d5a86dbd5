#pragma once

#include <cstddef>
#include <vector>

#include <planish/flatten/product.h>

namespace planish {

/// A piece as a picture of the whole product shows it.
struct DrawnPiece {
  std::size_t patch = 0;     ///< its number in the report
  std::size_t vertices = 0;  ///< how many of the picture's, behind those of the pieces before
  Vec3 middle;               ///< centroid of its area
};

/// One side of a seam in that picture.
struct DrawnSeam {
  std::size_t number = 1;       ///< from 1, as everywhere
  std::size_t patch = 0;        ///< the side's, a number in the report
  std::vector<Index> vertices;  ///< of the picture, along the seam; an end within an edge is moved
                                ///< to the nearer vertex
};

/// The pieces of a product in their places, with fewer vertices where there are many.
struct DrawnProduct {
  std::vector<DrawnPiece> pieces;
  std::vector<DrawnSeam> seams;
  TriMesh mesh;              ///< the results of all pieces, one after another
  std::vector<Vec3> design;  ///< where these vertices are in the design; empty: none moved
  Vec3 middle;               ///< centroid of the whole area
};

/// The finished pieces of the group that most of them are in: nothing says where the others lie.
/// Nothing where that is less than two.
/// @param most vertices in all, about
DrawnProduct drawn_product(const ProductReport& report, std::size_t most);

}  // namespace planish
