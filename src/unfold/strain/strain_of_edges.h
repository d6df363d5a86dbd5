#pragma once

#include <array>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/unfold/strain.h>

namespace planish {

/// The strain of one edge, and how much of the patch it stands for.
struct StrainOfEdge {
  double strain = 0.0;
  double area = 0.0;               ///< a third of that of its triangles on the patch
  std::array<Index, 2> edge = {};  ///< its vertices, the smaller number first
};

/// Of all edges, by their vertices. Areas are in units of unit_scale(); on a patch without any area
/// all edges count alike.
/// @param pattern one position per vertex of the mesh
std::vector<StrainOfEdge> strain_of_edges(const Patch& patch, std::span<const Vec2> pattern);

/// The smallest s so that edges with |strain| up to s make up this share of the area; 0 of none.
double strain_at_share(std::vector<StrainOfEdge> edges, double share);

/// The figures of these edges.
EdgeStrain figures_of(const std::vector<StrainOfEdge>& edges);

/// The part of a strain that this limit is for, above 0 where there is any: the stretch,
/// the compression, or the size of the strain.
double part_of(double strain, Criterion what);

}  // namespace planish
