#pragma once

#include <vector>

#include "unfold/disk/disk.h"
#include "unfold/strain/strain_of_edges.h"

namespace planish {

/// An edge of a disk as it is on the patch, in the disk's units.
struct FlatEdge {
  Index from, to;
  double length;
  double area;  ///< a third of that of its triangles; those of all edges add up to 1
};

/// The second derivative of a function of a vector in the plane: symmetric.
struct EdgeHessian {
  double xx, xy, yy;
};

/// All edges, each once, by their ends. Lengths are those of the mesh, also of needles, to whose
/// rest triangles a little height was given.
std::vector<FlatEdge> flat_edges(const TriMesh& mesh, const Disk& disk);

/// The strain of each edge: its length in the plane over that on the patch, minus 1.
std::vector<double> strains_of(std::span<const FlatEdge> edges, const std::vector<Vec2>& flat);

/// With the areas that the edges stand for.
std::vector<StrainOfEdge> with_areas(std::span<const FlatEdge> edges,
                                     std::span<const double> strains);

}  // namespace planish
