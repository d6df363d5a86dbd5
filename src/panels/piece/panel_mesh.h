#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>

namespace planish {

/// Of each edge of a PanelMesh: 1 where the mesh is cut open.
using OpenEdges = std::vector<unsigned char>;

/// An edge with its triangles.
struct PanelEdge {
  /// No triangle, or no edge.
  static constexpr Index none = static_cast<Index>(-1);

  std::array<Index, 2> ends = {none, none};       ///< the smaller number first
  std::array<Index, 2> triangles = {none, none};  ///< the second is none at the border
  double length = 0.0;                            ///< of the root of the mesh's area

  bool is_border() const { return triangles[1] == none; }
  Index other(Index triangle) const { return triangles[triangles[0] == triangle ? 1 : 0]; }
};

/// What the search for panels asks of a mesh again and again. Lengths are shares of the root of the
/// area of the mesh, areas of the area. Immutable.
class PanelMesh {
 public:
  explicit PanelMesh(Patch patch);
  /// A half and its mirror image: the vertices and the triangles of the half come first, those on
  /// the plane are in both.
  /// @param half on one side of the plane; some of its border is on it
  PanelMesh(const Patch& half, const Plane& plane);

  const Patch& patch() const { return patch_; }
  const std::vector<Triangle>& triangles() const { return patch_.triangles(); }
  const std::vector<PanelEdge>& edges() const { return edges_; }
  /// Side i of a triangle goes from its corner i to the next one.
  Index edge_of(Index triangle, std::size_t side) const { return sides_[triangle][side]; }
  /// The angle at each corner, and its cotangent.
  const std::array<double, 3>& angles(Index triangle) const { return angles_[triangle]; }
  const std::array<double, 3>& cotangents(Index triangle) const { return cotangents_[triangle]; }
  double area(Index triangle) const { return areas_[triangle]; }
  /// Model units times this are shares of the root of the area.
  double scale() const { return scale_; }
  double mean_edge() const { return mean_edge_; }
  /// Of each vertex its place in an order of elimination that keeps factors small, for systems that
  /// join vertices up to two edges apart, those of any part too.
  Index rank(Index vertex) const { return rank_[vertex]; }

  /// Whether it was made of a half and its mirror image.
  bool is_mirrored() const { return !image_.empty(); }
  /// @pre it is mirrored
  const Plane& plane() const { return plane_; }
  /// The edge at the mirror image of one: on the plane itself. @pre it is mirrored
  Index image_of_edge(Index edge) const { return image_[edge]; }
  /// @pre it is mirrored
  Index image_of_triangle(Index triangle) const {
    const auto half = static_cast<Index>(triangles().size() / 2);
    return triangle < half ? triangle + half : triangle - half;
  }
  /// Whether a triangle is of the image, not of the half; never where nothing is mirrored.
  bool is_image(Index triangle) const {
    return is_mirrored() && triangle >= triangles().size() / 2;
  }

 private:
  void pair_sides();
  void rank_vertices();

  Patch patch_;
  std::vector<PanelEdge> edges_;
  std::vector<std::array<Index, 3>> sides_;
  std::vector<std::array<double, 3>> angles_, cotangents_;
  std::vector<double> areas_;
  std::vector<Index> rank_;
  std::vector<Index> image_;  // of each edge
  Plane plane_;
  double scale_ = 1.0, mean_edge_ = 0.0;
};

/// Which vertices of a half are on the plane: those at the ends of edges of its border that are.
std::vector<bool> fold_vertices(const Patch& half, const Plane& plane);

/// The sum of the lengths of some edges.
double length_of(const PanelMesh& mesh, std::span<const Index> edges);

/// Whether the surface bends by 30 degrees or more at an edge.
bool is_crease(const PanelMesh& mesh, const PanelEdge& edge);

/// The sum of the lengths of edges that are open.
double open_length(const PanelMesh& mesh, const OpenEdges& open);

/// How many open edges begin or end at each vertex.
std::vector<int> open_edges_at(const PanelMesh& mesh, const OpenEdges& open);

/// Where an open run ends inside.
/// @param open_at open_edges_at()
std::size_t tips_of(const PanelMesh& mesh, std::span<const int> open_at);

/// The triangles of each part of a mesh that open edges leave together, parts in the order of their
/// smallest triangles, triangles increasing.
std::vector<std::vector<Index>> open_parts(const PanelMesh& mesh, const OpenEdges& open);
/// The same of some of the triangles.
std::vector<std::vector<Index>> open_parts(const PanelMesh& mesh, const OpenEdges& open,
                                           std::span<const Index> triangles);

}  // namespace planish
