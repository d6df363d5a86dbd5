#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// An edge of the border of a patch among those of several patches, which are in one row, loop
/// after loop.
struct BorderEdge {
  std::size_t patch;
  Index from, to;
  std::size_t next, previous;  ///< along the loop
};

/// A loop of the border of a patch, its edges numbered from `first` on.
struct BorderLoop {
  std::size_t patch = 0;
  std::size_t first = 0, count = 0;
  double length = 0.0;

  double mean_edge() const { return length / static_cast<double>(count); }
};

/// The borders of patches as curves. A place on a loop is the number of an edge in the loop plus
/// the share of that edge, as 3.25; it may go on over the loop's end: count + 3.25 is the same
/// place.
class BorderLines {
 public:
  /// @throws Error as Patch
  explicit BorderLines(std::span<const TriMesh> patches);

  const std::vector<BorderEdge>& edges() const { return edges_; }
  const std::vector<BorderLoop>& loops() const { return loops_; }
  const Patch& patch(std::size_t number) const { return patches_[number]; }

  const BorderLoop& loop_of(std::size_t edge) const { return loops_[loop_of_[edge]]; }
  std::size_t loop_number(std::size_t edge) const { return loop_of_[edge]; }
  /// The place at which an edge begins.
  double place_of(std::size_t edge) const {
    return static_cast<double>(edge - loop_of(edge).first);
  }

  Vec3 start(std::size_t edge) const { return position(edge, edges_[edge].from); }
  Vec3 end(std::size_t edge) const { return position(edge, edges_[edge].to); }
  double length(std::size_t edge) const { return lengths_[edge]; }
  /// The longest of an edge and its two neighbours.
  double length_around(std::size_t edge) const;

  /// The edge that a place is on, or begins.
  std::size_t edge_at(const BorderLoop& loop, double place) const;
  Vec3 point_at(const BorderLoop& loop, double place) const;
  /// Length along the loop from its first vertex to a place, with whole turns.
  double way_to(const BorderLoop& loop, double place) const;
  /// Whether the border turns by more than 30 degrees at the vertex where an edge begins.
  bool is_corner(std::size_t edge) const { return cosine_at(edge) < 0.866; }
  /// Cosine of the angle by which it turns there.
  double cosine_at(std::size_t edge) const;

 private:
  Vec3 position(std::size_t edge, Index vertex) const {
    return patches_[edges_[edge].patch].positions()[vertex];
  }

  std::vector<Patch> patches_;
  std::vector<BorderEdge> edges_;
  std::vector<BorderLoop> loops_;
  std::vector<std::size_t> loop_of_;      // of each edge
  std::vector<double> lengths_, before_;  // of each edge; on its loop, from the first vertex
};

}  // namespace planish
