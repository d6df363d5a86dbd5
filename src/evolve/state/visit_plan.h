#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <planish/core/vec.h>

#include "core/buffer.h"
#include "core/simd/stars.h"
#include "core/thread_pool.h"
#include "evolve/state/vertex_coloring.h"

namespace planish {

/// Visits of one colour and valence, one after another in the plan.
struct Run {
  Index begin, end;   ///< the visits from begin to end - 1
  Index color;        ///< see Colorer
  Index valence;      ///< neighbours of each
  std::size_t rings;  ///< where the ring of the first begins among all rings
};

/// The order in which a sweep visits the inner vertices, so that a core works in its cache and
/// seldom waits for others. First what is inside the pieces that the numbers are cut into, piece
/// by piece; then what is left at their seams, in pieces cut another way; then the little that is
/// on seams again, as one piece. Pieces of one stage may be visited at the same time. A piece is
/// visited colour by colour, a colour by valence, what is left by number.
struct VisitPlan {
  std::vector<Index> visits;             ///< the inner vertices
  Buffer<Index> rings;                   ///< their neighbours, in the same order
  std::vector<Run> runs;                 ///< all visits, in their order
  std::vector<std::size_t> piece_start;  ///< first visit of each piece, and the end of the last
  std::vector<std::size_t> stage_start;  ///< first piece of each stage, and the end of the last
  Index color_count = 0;

  /// The run that the i-th visit is in.
  const Run* run_of(std::size_t i) const;
  /// The vertex that is the i-th to be visited, in the run, and its ring.
  Star star(const Run& run, std::size_t i) const {
    return {rings.data() + run.rings + (i - run.begin) * run.valence, visits[i]};
  }
  std::span<const Index> ring(const Run& run, std::size_t i) const {
    return {star(run, i).ring, run.valence};
  }
  /// Calls body(run, begin, end) for the runs that the visits from begin to end - 1 are in, with
  /// the part of them that each holds.
  template <class Body>
  void for_runs(std::size_t begin, std::size_t end, const Body& body) const {
    for (const Run* run = run_of(begin); begin < end; begin = run->end, ++run)
      body(*run, begin, end < run->end ? end : run->end);
  }
};

/// The rings of the inner vertices, by vertex.
std::vector<std::span<const Index>> rings_by_vertex(const VisitPlan& plan);

/// Sorts inner vertices along a space-filling curve that turns elsewhere than the one by which they
/// are numbered.
using OtherOrder = std::function<std::vector<Index>(std::vector<Index> vertices)>;

/// The same on any number of threads.
VisitPlan plan_visits(const InnerRings& rings, const OtherOrder& other_order, ThreadPool& pool);

}  // namespace planish
