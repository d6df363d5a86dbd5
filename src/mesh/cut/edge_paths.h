#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// So many vertices may be looked at for all ways of a file together: some seconds. Each line of a
/// file can ask for a way across the whole mesh, and without a bound a small file could take hours.
inline constexpr std::size_t k_most_looks = 50'000'000;

/// Finds shortest paths along the edges of a mesh (Dijkstra 1959).
class EdgePaths {
 public:
  explicit EdgePaths(const Patch& patch);

  /// The vertices of a shortest path, ends included; nothing where the ends are on different parts
  /// of the mesh. Of several paths always the same. Looks no further than the path is long.
  std::optional<std::vector<Index>> between(Index from, Index to);

  /// Vertices looked at so far.
  std::size_t looks() const { return looks_; }

 private:
  void spread(Index from, Index to);

  Patch patch_;
  double scale_;
  std::vector<double> distance_;  ///< infinite where nothing was reached yet
  std::vector<Index> previous_;
  std::size_t looks_ = 0;
  std::vector<Index> reached_;  ///< what has to be forgotten before the next path
};

}  // namespace planish
