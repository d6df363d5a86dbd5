#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// Whether v and its neighbour w are joined by an edge of the border.
bool is_border_edge(const Connectivity& connectivity, Index v, Index w);

/// Finds shortest paths that a mesh can be cut along (Dijkstra 1959): along edges that have a
/// triangle on either side, and touching the border with their ends only.
class InsidePaths {
 public:
  /// @param weights of vertices: an edge counts for its length times the mean of those at its ends;
  ///   empty: 1 everywhere
  explicit InsidePaths(const Patch& patch, std::span<const double> weights = {});

  /// The vertices of a shortest path from one of the first ones to one that is wanted, ends
  /// included; nothing where there is none. Of several paths always the same. Looks no further
  /// than the path is long.
  std::optional<std::vector<Index>> from(std::span<const Index> first,
                                         const std::function<bool(Index)>& is_wanted);

  /// The vertex that is farthest along such paths, of those that are wanted and can be reached.
  std::optional<Index> farthest(Index first, const std::function<bool(Index)>& is_wanted);

  /// Shortest paths from the first vertices to all others.
  struct Tree {
    std::vector<double> distance;  ///< infinite where no path leads
    std::vector<Index> previous;   ///< of a first vertex itself; of no meaning where none leads
  };
  Tree tree(std::span<const Index> first);

  /// Vertices looked at so far.
  std::size_t looks() const { return looks_; }

 private:
  /// Spreads until a vertex makes `at_vertex` say true, and returns that; distances grow.
  std::optional<Index> spread(std::span<const Index> first,
                              const std::function<bool(Index)>& at_vertex);
  void forget();
  double length_of(Index v, Index w) const;

  Patch patch_;
  double scale_;
  std::vector<double> weights_;
  std::vector<double> distance_;  ///< infinite where nothing was reached yet
  std::vector<Index> previous_;   ///< of a first vertex itself
  std::size_t looks_ = 0;
  std::vector<Index> reached_;  ///< what has to be forgotten before the next path
};

}  // namespace planish
