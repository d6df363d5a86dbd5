#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <planish/mesh/imprint.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>

#include "mesh/half_edges.h"

namespace planish {

/// Vertices of a mesh and points of lines on its edges and in its triangles. The vertices of the
/// mesh have their own numbers, the others follow.
class LineNodes {
 public:
  /// @param patch must outlive it
  LineNodes(const Patch& patch, const ImprintOptions& options);

  /// What holds a node beside itself.
  enum class On { vertex, edge, face };
  struct Node {
    On on = On::vertex;
    Index element = 0;  ///< vertex, edge (the lower number of its half-edges) or triangle
    /// On an edge x: cells from the start of that half-edge. In a triangle: as the
    /// ConstrainedDelaunay has it.
    Vec2 grid = {};
  };

  std::size_t vertex_count() const { return vertex_count_; }
  std::size_t count() const { return vertex_count_ + nodes_.size(); }
  Node node(Index number) const;
  /// Of the mesh as it is scaled to be about 1 large.
  Vec3 position(Index number) const;
  /// On the mesh.
  SurfacePoint place(Index number) const;
  const HalfEdges& half_edges() const { return half_edges_; }
  const TriMesh& scaled() const { return mesh_; }

  /// The node for a point of a line, on a vertex or edge where it is near enough.
  /// @return nothing where there is no such triangle or the shares are no numbers >= 0
  std::optional<Index> add(const SurfacePoint& point);
  /// A node in a triangle, by its place in the ConstrainedDelaunay; one that is near enough, if
  /// there is one.
  Index add_in_face(Index triangle, Vec2 grid);
  /// The same, a new one always.
  Index new_in_face(Index triangle, Vec2 grid);
  /// A node on an edge; one that is near enough, if there is one.
  /// @param cells from the start of a half-edge, which may be either of the edge
  /// @param apart how far what it stands for is from the edge, scaled
  Index add_on_edge(Index half, double cells, double apart = 0.0);

  /// The same, a share of the way between two nodes on it.
  Index add_between(Index half, Index from, Index to, double share);

  /// The nodes on the edge of a half-edge, its ends not among them, in its direction.
  std::vector<Index> on_edge(Index half) const;
  /// Nodes in its direction between two that lie on one edge, both among them.
  std::vector<Index> along(Index half, Index from, Index to) const;

  /// Where a straight line from one node to another runs.
  struct Way {
    On on = On::face;   ///< along an edge or in a triangle
    Index element = 0;  ///< a half-edge or a triangle
  };
  /// Nothing where no triangle holds both.
  std::optional<Way> way(Index from, Index to) const;

  /// Where a node of a triangle is in its ConstrainedDelaunay.
  Vec2 grid_in(Index triangle, Index number) const;

  std::size_t snapped() const { return snapped_; }
  double farthest_snap() const { return farthest_; }  ///< scaled

 private:
  SurfacePoint place_of(const Node& node) const;
  Index edge_of(Index half) const;
  double snap_at(Index vertex) const;
  std::optional<Index> half_of(const SurfacePoint& point) const;
  void note(double moved);
  Index new_node(const Node& node);
  template <class Visit>
  void for_each_face(Index number, Visit visit) const;
  double cells_along(Index half, Index number) const;

  std::size_t vertex_count_;
  double scale_;
  TriMesh mesh_;
  HalfEdges half_edges_;
  double share_, most_;
  std::vector<Node> nodes_;
  std::map<Index, std::map<double, Index>> on_edges_;  // edge -> cells -> node
  std::map<Index, std::vector<Index>> in_faces_;       // triangle -> nodes
  std::size_t snapped_ = 0;
  double farthest_ = 0.0;
};

}  // namespace planish
