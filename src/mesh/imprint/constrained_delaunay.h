#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// Cells along a side of a triangle in its ConstrainedDelaunay.
inline constexpr double k_cells = 1125899906842624.0;  // 2^50

/// The constrained Delaunay triangulation of nodes and segments inside one triangle. Nodes lie on a
/// grid of barycentric coordinates, the corners at (0, 0), (k_cells, 0) and (0, k_cells), so that
/// which side of a line a node is on is decided exactly; angles are those of the triangle itself.
class ConstrainedDelaunay {
 public:
  /// @param sides lengths of the triangle's sides from corner to next corner
  /// @param reach a node that is nearer to a segment than this is on it, as long as all nodes
  ///   together lead no segment more than twice this aside; at most 1/100 of the height of the
  ///   triangle counts
  explicit ConstrainedDelaunay(const std::array<double, 3>& sides, double reach = 0.0);

  /// The node at a place, which is new where there was none. A segment through it is divided.
  /// @param grid whole numbers inside the triangle
  Index add(Vec2 grid);

  /// Makes the segment between two nodes an edge, or several: those nodes are on it that it meets,
  /// and where it crosses another segment there is a new node.
  void connect(Index a, Index b);

  /// Puts a node onto a segment, rounded to the grid.
  /// @param share of the way from a to b, between 0 and 1
  /// @pre a and b are joined by an edge that is a segment
  void divide(Index a, Index b, double share);

  /// The nodes along the segment that was connected, both ends among them.
  std::vector<Index> path(Index a, Index b) const;

  /// Nodes 0 to 2 are the corners.
  const std::vector<Vec2>& nodes() const { return grid_; }
  /// In the plane of the triangle.
  Vec2 place(Index node) const { return places_[node]; }
  /// Whether an edge is one of a segment.
  bool is_segment(Index a, Index b) const { return segments_.contains(key(a, b)); }

  /// Counter-clockwise, by numbers of nodes.
  std::vector<Triangle> triangles() const;

  struct Part {
    Triangle corners;
    std::array<Index, 3> across;  ///< the part beyond the side from this corner to the next
  };
  const std::vector<Part>& parts() const { return parts_; }
  /// Whether the side from this corner of a part to the next is one of the triangle or a segment.
  bool is_fixed(Index part, std::size_t slot) const;
  /// The inverse of place(), rounded to the grid.
  Vec2 grid_at(Vec2 place) const;
  /// How far the nearest corner of the part that holds a place, and of those beside it, is from it.
  double distance_to_corner(Vec2 place) const;
  /// How far the farthest segment was led to a node beside it.
  double farthest() const { return farthest_; }

 private:
  using Key = std::array<Index, 2>;
  /// A side of a part.
  struct Side {
    Index part;
    std::size_t slot;
  };

  static Key key(Index a, Index b) { return a < b ? Key{a, b} : Key{b, a}; }

  Index new_node(Vec2 grid);
  Index locate(Vec2 grid) const;
  int side(Index a, Index b, Index c) const;
  double distance_to(Index a, Index b, Vec2 p) const;
  int side_of_segment(Index a, Index b, Index c, double reach) const;
  std::optional<Side> edge(Index a, Index b) const;
  std::size_t slot_of(Index part, Index corner) const;
  void replace_across(Index part, Index before, Index now);
  void divide_part(Index part, Index node);
  void divide_side(Side side, Index node);
  bool is_convex(Side side) const;
  void flip(Side side);
  void settle(std::vector<Key> open);
  /// How a segment leaves the parts around its beginning.
  struct Leaving {
    std::optional<Side> side = {};
    std::optional<Index> node = {};
  };
  Leaving leaving(Index a, Index b, double reach) const;
  /// A part of a segment: how far nodes beside it have led it aside, at most, and in how many
  /// steps.
  struct Led {
    double aside = 0.0;
    int depth = 0;
  };
  double reach_of(const Led& led) const;
  void keep(Index a, Index b, double aside);
  void connect(Index a, Index b, const Led& led);
  void connect_over(Index node, Index a, Index b, const Led& led);
  void lead_over(Index node, Index a, Index b, const Led& led);
  void flip_across(Index a, Index b, std::vector<Key> crossed);
  void cross(Key segment, Index a, Index b, const Led& led);
  Vec2 crossing(Key segment, Index a, Index b) const;

  double reach_, farthest_ = 0.0;
  Vec2 right_, up_;  // the sides from the first corner
  std::vector<Vec2> grid_, places_;
  std::vector<Part> parts_;
  std::vector<Index> part_of_;       // a part at each node
  std::map<Key, double> segments_;   // edges that are kept: how far they were led aside
  std::map<Key, Index> divided_at_;  // segments that are edges no more: a node on each
};

}  // namespace planish
