#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <planish/core/vec.h>

#include "core/buffer.h"
#include "core/thread_pool.h"

namespace planish {

/// The rings of the inner vertices, which are numbered first; higher numbers are border.
struct InnerRings {
  std::span<const std::size_t> start;  ///< one more than inner vertices
  std::span<const Index> vertices;

  std::size_t count() const { return start.size() - 1; }
  std::span<const Index> of(std::size_t v) const {
    return vertices.subspan(start[v], start[v + 1] - start[v]);
  }
};

constexpr Index k_none = static_cast<Index>(-1);

/// Inner vertices cut into pieces.
struct Pieces {
  Buffer<Index> vertices;          ///< those to be coloured, piece by piece
  std::vector<std::size_t> start;  ///< where each piece begins, and the end of the last
  Buffer<Index> piece_of;          ///< of each inner vertex; k_none: far from all that matters

  std::size_t count() const { return start.size() - 1; }
  std::span<const Index> of(std::size_t piece) const {
    return {vertices.data() + start[piece], start[piece + 1] - start[piece]};
  }
};

/// Gives colours to inner vertices such that two of one colour share no inner vertex in their
/// closed one-rings: then neither sees what the other changes, and they may move at the same time
/// with the result of moving one after the other. Greedy; colours are few, about 14 on ordinary
/// meshes. Time is linear for bounded valence and stays near it around vertices of any valence. The
/// same on any number of threads.
class Colorer {
 public:
  /// The rings must outlive it.
  explicit Colorer(const InnerRings& rings) : rings_(rings), colors_(rings.count(), k_none) {}

  /// Of each inner vertex; k_none: not coloured yet.
  const std::vector<Index>& colors() const { return colors_; }
  /// Colours in use are below.
  Index count() const { return count_; }

  /// Colours vertices that are inside a piece, with all their inner neighbours, by new colours:
  /// those inside one piece share no inner vertex with those inside another, whatever their
  /// colours. Returns the others, among which is also what is near a vertex of very high valence.
  std::vector<Index> color_insides(const Pieces& pieces, ThreadPool& pool);

  /// Colours these by new colours.
  void color_rest(std::span<const Index> vertices);

 private:
  bool is_inner(Index v) const { return v < colors_.size(); }
  /// Gives v a new colour if it is inside the piece and one is free.
  void color_inside(Index v, Index piece, const Pieces& pieces, std::vector<std::uint64_t>& seen);

  const InnerRings rings_;
  std::vector<Index> colors_;
  Index count_ = 0;
};

}  // namespace planish
