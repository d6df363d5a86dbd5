#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish::cli {

/// A line as edges of a mesh.
struct LinePath {
  std::vector<Index> vertices;
  std::size_t line = 0;  ///< its number among those that were asked for
};

/// A piece that is too small to sew, and what becomes of it.
struct SmallPiece {
  std::size_t piece = 0;                ///< its number in the order of split(), from 0
  double area = 0.0;                    ///< of all, 0 to 1
  std::size_t joined_to = 0;            ///< the piece that it has the longest seam with
  std::vector<std::size_t> lines = {};  ///< around it, by their numbers
};

/// What counts as too small.
struct SmallLimits {
  double area = 0.0;  ///< of all, 0 to 1
  /// Model units; of the rectangle with a piece's area and circumference, of pieces with less than
  /// `narrow_area` of all: on coarse meshes large ones are as narrow.
  double width = 0.0, narrow_area = 0.05;
};

/// What is left to be cut.
struct KeptPaths {
  std::vector<LinePath> paths;
  std::vector<SmallPiece> small = {};
  std::vector<std::size_t> inside = {};  ///< numbers of lines that have one piece on both sides
};

/// Finds pieces below the limits, and leaves out the cuts between each and the neighbour with which
/// it has the longest seam, smallest pieces first. What of a line runs along the border is no cut;
/// a line of which all does stays, to be refused.
KeptPaths without_small_pieces(const Patch& patch, std::span<const LinePath> paths,
                               const SmallLimits& limits);

}  // namespace planish::cli
