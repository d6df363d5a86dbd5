#pragma once

#include <vector>

#include "energy/flat_edge.h"
#include "unfold/disk/disk.h"
#include "unfold/strain/strain_of_edges.h"

namespace planish {

/// All edges of a disk, each once, by their ends, in its units. Lengths are those of the mesh, also
/// of needles, to whose rest triangles a little height was given.
std::vector<FlatEdge> flat_edges(const TriMesh& mesh, const Disk& disk);

/// The strain of each edge: its length in the plane over that on the patch, minus 1.
std::vector<double> strains_of(std::span<const FlatEdge> edges, const std::vector<Vec2>& flat);

/// With the areas that the edges stand for.
std::vector<StrainOfEdge> with_areas(std::span<const FlatEdge> edges,
                                     std::span<const double> strains);

}  // namespace planish
