#include "evolve/state/visit_plan.h"

#include <algorithm>
#include <utility>

namespace planish {

namespace {

/// Vertices of a piece at most: their sites, rings and marks, some 80 bytes each, fit into the
/// second-level cache of a core.
constexpr std::size_t k_largest_piece = 8192;

/// Enough pieces for a few threads, but none so small that lanes stay empty at the ends of runs.
/// Must not depend on the number of threads.
std::size_t piece_size(std::size_t count, std::size_t pieces, std::size_t smallest) {
  return std::clamp(count / pieces, smallest, k_largest_piece);
}

Pieces cut_numbers(std::size_t count, ThreadPool& pool) {
  const std::size_t size = piece_size(count, 4, 2048);
  Pieces pieces;
  for (std::size_t begin = 0; begin < count; begin += size)
    pieces.start.push_back(begin);
  pieces.start.push_back(count);
  pieces.vertices = Buffer<Index>(count);
  pieces.piece_of = Buffer<Index>(count);
  pool.for_ranges(pieces.count(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) {
      for (std::size_t v = pieces.start[p]; v < pieces.start[p + 1]; ++v) {
        pieces.vertices[v] = static_cast<Index>(v);
        pieces.piece_of[v] = static_cast<Index>(p);
      }
    }
  });
  return pieces;
}

/// Cuts these and what is around them.
Pieces cut_seams(const std::vector<Index>& seams, const InnerRings& rings,
                 const OtherOrder& other_order) {
  constexpr Index seam = 0, near = 1;
  Pieces pieces;
  pieces.piece_of = Buffer<Index>(rings.count());
  std::fill(pieces.piece_of.begin(), pieces.piece_of.end(), k_none);
  for (const Index v : seams)
    pieces.piece_of[v] = seam;
  std::vector<Index> around = seams;
  for (const Index v : seams) {
    for (const Index w : rings.of(v)) {
      if (w >= rings.count() || pieces.piece_of[w] != k_none) continue;
      pieces.piece_of[w] = near;
      around.push_back(w);
    }
  }
  const std::size_t size = piece_size(around.size(), 16, 1024);
  const std::vector<Index> order = other_order(std::move(around));
  pieces.vertices = Buffer<Index>(seams.size());
  std::size_t placed = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % size == 0) pieces.start.push_back(placed);
    Index& piece = pieces.piece_of[order[i]];
    if (piece == seam) pieces.vertices[placed++] = order[i];
    piece = static_cast<Index>(i / size);
  }
  pieces.start.push_back(placed);
  return pieces;
}

/// All as one.
Pieces uncut(const std::vector<Index>& vertices) {
  Pieces pieces;
  pieces.start = {0, vertices.size()};
  pieces.vertices = Buffer<Index>(vertices.size());
  std::copy(vertices.begin(), vertices.end(), pieces.vertices.begin());
  return pieces;
}

/// Puts what has one key together, keys ascending, and keeps the order within.
template <class KeyOf>
void sort_by(std::vector<Index>& order, const KeyOf& key_of) {
  std::vector<Index> next(1, 0);
  for (const Index v : order) {
    const std::size_t key = key_of(v);
    if (key + 2 > next.size()) next.resize(key + 2, 0);
    ++next[key + 1];
  }
  for (std::size_t key = 1; key < next.size(); ++key)
    next[key] += next[key - 1];
  std::vector<Index> sorted(order.size());
  for (const Index v : order)
    sorted[next[key_of(v)]++] = v;
  order = std::move(sorted);
}

/// Adds stages to a plan.
class Planner {
 public:
  Planner(const InnerRings& rings, const Colorer& colorer, ThreadPool& pool)
      : rings_(rings), colorer_(colorer), pool_(pool) {
    plan_.visits.resize(rings.count());
    plan_.piece_start.push_back(0);
    plan_.stage_start.push_back(0);
    plan_.rings = Buffer<Index>(rings.vertices.size());
  }

  /// @param first_color those of the pieces' vertices that have this colour or one above are in it
  void add_stage(const Pieces& pieces, Index first_color) {
    std::vector<std::vector<Index>> vertices(pieces.count());
    std::vector<std::size_t> ring_sizes(pieces.count(), 0);
    for_pieces(pieces, [&](std::size_t p) {
      std::vector<Index> chosen;
      std::size_t ring_size = 0;
      chosen.reserve(pieces.of(p).size());
      for (const Index v : pieces.of(p)) {
        if (colorer_.colors()[v] == k_none || colorer_.colors()[v] < first_color) continue;
        chosen.push_back(v);
        ring_size += rings_.of(v).size();
      }
      vertices[p] = std::move(chosen);
      ring_sizes[p] = ring_size;
    });
    const std::size_t first_piece = plan_.piece_start.size() - 1;
    std::vector<std::size_t> ring_start{ring_places_};
    for (std::size_t p = 0; p < pieces.count(); ++p) {
      plan_.piece_start.push_back(plan_.piece_start.back() + vertices[p].size());
      ring_start.push_back(ring_start.back() + ring_sizes[p]);
    }
    std::vector<std::vector<Run>> runs(pieces.count());
    for_pieces(pieces, [&](std::size_t p) {
      runs[p] = place(std::move(vertices[p]), plan_.piece_start[first_piece + p], ring_start[p]);
    });
    for (const auto& of_piece : runs)
      plan_.runs.insert(plan_.runs.end(), of_piece.begin(), of_piece.end());
    ring_places_ = ring_start.back();
    plan_.stage_start.push_back(plan_.piece_start.size() - 1);
  }

  VisitPlan finish() {
    plan_.color_count = colorer_.count();
    return std::move(plan_);
  }

 private:
  template <class Body>
  void for_pieces(const Pieces& pieces, const Body& body) {
    pool_.for_ranges(pieces.count(), 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t p = first; p < last; ++p)
        body(p);
    });
  }

  /// Sorts vertices by colour and valence and puts them into the plan; returns their runs.
  std::vector<Run> place(std::vector<Index> vertices, std::size_t first_visit,
                         std::size_t first_ring) {
    const auto valence = [&](Index v) { return static_cast<Index>(rings_.of(v).size()); };
    sort_by(vertices, valence);
    sort_by(vertices, [&](Index v) { return colorer_.colors()[v]; });
    std::vector<Run> runs;
    auto visit = static_cast<Index>(first_visit);
    for (const Index v : vertices) {
      const auto ring = rings_.of(v);
      const Index color = colorer_.colors()[v];
      if (runs.empty() || runs.back().color != color || runs.back().valence != ring.size())
        runs.push_back({visit, visit, color, static_cast<Index>(ring.size()), first_ring});
      std::copy(ring.begin(), ring.end(), plan_.rings.data() + first_ring);
      first_ring += ring.size();
      plan_.visits[visit] = v;
      runs.back().end = ++visit;
    }
    return runs;
  }

  const InnerRings& rings_;
  const Colorer& colorer_;
  ThreadPool& pool_;
  VisitPlan plan_;
  std::size_t ring_places_ = 0;
};

}  // namespace

const Run* VisitPlan::run_of(std::size_t i) const {
  const auto ends_after = [](std::size_t visit, const Run& run) { return visit < run.end; };
  return runs.data() + (std::upper_bound(runs.begin(), runs.end(), i, ends_after) - runs.begin());
}

std::vector<std::span<const Index>> rings_by_vertex(const VisitPlan& plan) {
  std::vector<std::span<const Index>> rings(plan.visits.size());
  plan.for_runs(0, plan.visits.size(), [&](const Run& run, std::size_t i, std::size_t end) {
    for (; i < end; ++i)
      rings[plan.visits[i]] = plan.ring(run, i);
  });
  return rings;
}

VisitPlan plan_visits(const InnerRings& rings, const OtherOrder& other_order, ThreadPool& pool) {
  Colorer colorer(rings);
  Planner planner(rings, colorer, pool);
  std::vector<Index> left;
  const auto add_insides = [&](const Pieces& pieces) {
    const Index first_color = colorer.count();
    left = colorer.color_insides(pieces, pool);
    planner.add_stage(pieces, first_color);
  };
  add_insides(cut_numbers(rings.count(), pool));
  if (!left.empty()) add_insides(cut_seams(left, rings, other_order));
  if (!left.empty()) {
    const Index first_color = colorer.count();
    std::sort(left.begin(), left.end());
    colorer.color_rest(left);
    planner.add_stage(uncut(left), first_color);
  }
  return planner.finish();
}

}  // namespace planish
