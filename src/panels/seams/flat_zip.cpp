#include "panels/seams/flat_zip.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

#include "geometry/crosses_itself.h"
#include "mesh/disjoint_sets.h"
#include "panels/seams/zip.h"

namespace planish {

namespace {

constexpr std::size_t k_crossings = 1000;  // that are looked at
constexpr double k_least_part = 0.01;      // of the area that a run divides off
constexpr int k_repairs = 8;

/// Pairs of triangles whose border edges cross in the pattern.
std::vector<std::array<Index, 2>> crossing_triangles(const LaidFlat& flat,
                                                     std::span<const Index> triangles) {
  std::map<std::array<Index, 2>, Index> triangle_at;
  for (Index k = 0; k < triangles.size(); ++k) {
    const Triangle& t = flat.patch.triangles()[k];
    for (std::size_t i = 0; i < 3; ++i)
      triangle_at[{t[i], t[(i + 1) % 3]}] = triangles[k];
  }
  std::vector<Vec2> places;
  std::vector<std::size_t> sizes;
  std::vector<Index> beside;
  for (const std::vector<Index>& loop : flat.patch.border_loops()) {
    sizes.push_back(loop.size());
    for (std::size_t k = 0; k < loop.size(); ++k) {
      places.push_back(flat.pattern.positions[loop[k]]);
      beside.push_back(triangle_at.at({loop[k], loop[(k + 1) % loop.size()]}));
    }
  }
  std::vector<std::array<Index, 2>> pairs;
  for (const auto& [a, b] : crossing_sides(places, LoopOrder(sizes), k_crossings))
    pairs.push_back({beside[a], beside[b]});
  return pairs;
}

/// A piece as the parts that it would be in if all runs were open. Those are few, so what a run
/// divides it into is found soon.
class PieceOfParts {
 public:
  /// @param walls edges of the runs inside the piece
  PieceOfParts(const SeamState& state, std::size_t piece, std::span<const Index> walls)
      : part_(state.mesh().triangles().size(), PanelEdge::none) {
    OpenEdges open = state.open();
    for (const Index e : walls)
      open[e] = 1;
    for (const std::vector<Index>& part :
         open_parts(state.mesh(), open, state.pieces()[piece].triangles)) {
      double area = 0.0;
      for (const Index t : part) {
        part_[t] = static_cast<Index>(areas_.size());
        area += state.mesh().area(t);
      }
      areas_.push_back(area);
    }
    for (const Index e : walls)
      walls_.emplace_back(e, state.mesh().edges()[e].triangles);
    std::sort(walls_.begin(), walls_.end());
    walls_.erase(std::unique(walls_.begin(), walls_.end()), walls_.end());
  }

  /// What is left together once a run is open.
  class Divided {
   public:
    /// @param run increasing
    Divided(const PieceOfParts& piece, std::span<const Index> run)
        : piece_(piece), sets_(piece.areas_.size()) {
      for (const auto& [e, sides] : piece.walls_) {
        if (!std::binary_search(run.begin(), run.end(), e))
          sets_.join(piece.part_[sides[0]], piece.part_[sides[1]]);
      }
      for (Index p = 0; p < piece.areas_.size(); ++p)
        areas_[sets_.first_of(p)] += piece.areas_[p];
    }
    bool is_divided() const { return areas_.size() > 1; }
    double least_area() const {
      double least = std::numeric_limits<double>::infinity();
      for (const auto& [first, area] : areas_)
        least = std::min(least, area);
      return least;
    }
    bool parts(const std::array<Index, 2>& pair) {
      return sets_.first_of(piece_.part_[pair[0]]) != sets_.first_of(piece_.part_[pair[1]]);
    }

   private:
    const PieceOfParts& piece_;
    DisjointSets<Index> sets_;
    std::map<Index, double> areas_;
  };

 private:
  std::vector<Index> part_;  // by triangle of the mesh
  std::vector<double> areas_;
  std::vector<std::pair<Index, std::array<Index, 2>>> walls_;  // edges with their triangles
};

/// Whether an end of an edge of one run is one of the other.
bool meet(const PanelMesh& mesh, const std::vector<Index>& one, const std::vector<Index>& other) {
  for (const Index e : {one.front(), one.back()}) {
    for (const Index f : {other.front(), other.back()}) {
      for (const Index v : mesh.edges()[e].ends) {
        if (v == mesh.edges()[f].ends[0] || v == mesh.edges()[f].ends[1]) return true;
      }
    }
  }
  return false;
}

/// Looks for what divides a piece best.
class DividingRun {
 public:
  DividingRun(const SeamState& state, const std::vector<SeamChain>& chains, std::size_t piece,
              double piece_price, std::span<const std::array<Index, 2>> crossings)
      : state_(state),
        piece_(piece),
        runs_(closed_runs(state, chains, piece)),
        plane_(closed_on_plane()),
        parts_(state, piece, walls()),
        piece_price_(piece_price),
        crossings_(crossings) {}

  std::vector<Index> find() {
    std::vector<std::vector<Index>> others;  // that do not divide it alone
    for (const std::vector<Index>& run : runs_) {
      if (!divides(run)) others.push_back(run);
    }
    // As around a place where three cells meet and nothing is open.
    for (std::size_t i = 0; i < others.size(); ++i) {
      for (std::size_t j = i + 1; j < others.size(); ++j) {
        if (!meet(state_.mesh(), others[i], others[j])) continue;
        std::vector<Index> both = others[i];
        both.insert(both.end(), others[j].begin(), others[j].end());
        divides(both);
      }
    }
    // A piece across the plane may lie on its own mirror image.
    if (!plane_.empty()) divides(plane_);
    return std::move(best_);
  }

 private:
  std::vector<Index> closed_on_plane() const {
    const PanelMesh& mesh = state_.mesh();
    std::vector<Index> found;
    for (Index e = 0; mesh.is_mirrored() && e < mesh.edges().size(); ++e) {
      const bool is_inside = !mesh.edges()[e].is_border() && state_.open()[e] == 0 &&
                             state_.piece_of(mesh.edges()[e].triangles[0]) == piece_;
      if (is_inside && mesh.image_of_edge(e) == e) found.push_back(e);
    }
    return found;
  }

  /// Edges inside the piece of everything that may be opened.
  std::vector<Index> walls() const {
    std::vector<Index> walls = plane_;
    for (const std::vector<Index>& run : runs_) {
      const std::vector<Index> edges = state_.run_of(run).edges;
      walls.insert(walls.end(), edges.begin(), edges.end());
    }
    return walls;
  }

  bool divides(const std::vector<Index>& edges) {
    const std::vector<Index> run = state_.run_of(edges).edges;
    std::vector<Index> sorted = run;
    std::sort(sorted.begin(), sorted.end());
    PieceOfParts::Divided divided(parts_, sorted);
    if (!divided.is_divided()) return false;
    if (divided.least_area() < k_least_part) return true;
    std::size_t undone = crossings_.empty() ? 1 : 0;
    for (const auto& pair : crossings_)
      undone += divided.parts(pair) ? 1 : 0;
    const double cost = piece_price_ + length_of(state_.mesh(), run);
    if (undone > 0 && cost / static_cast<double>(undone) < least_) {
      least_ = cost / static_cast<double>(undone);
      best_ = run;
    }
    return true;
  }

  const SeamState& state_;
  std::size_t piece_;
  std::vector<std::vector<Index>> runs_;
  std::vector<Index> plane_;
  PieceOfParts parts_;
  double piece_price_;
  std::span<const std::array<Index, 2>> crossings_;
  double least_ = std::numeric_limits<double>::infinity();
  std::vector<Index> best_;
};

}  // namespace

std::vector<Index> dividing_run(const SeamState& state, const std::vector<SeamChain>& chains,
                                std::size_t piece, double piece_price,
                                const std::optional<LaidFlat>& flat) {
  std::vector<std::array<Index, 2>> crossings;
  if (flat) crossings = crossing_triangles(*flat, state.pieces()[piece].triangles);
  return DividingRun(state, chains, piece, piece_price, crossings).find();
}

namespace {

/// Nothing where it has no pattern.
std::optional<LaidFlat> flat_piece(const PanelMesh& mesh, const OpenEdges& open,
                                   std::span<const Index> triangles,
                                   const PieceLimits& limits = {}) {
  return laid_flat(mesh, PieceCorners(mesh, open, triangles), limits, {.threads = 1});
}

/// Whether the piece that closing the run makes lies flat, by a conformal map of it.
bool joins_flat(const SeamState& state, const SeamRun& run) {
  OpenEdges open = state.open();
  for (const Index e : run.edges)
    open[e] = 0;
  std::vector<Index> triangles;
  for (const Index p : run.pieces) {
    const std::vector<Index>& more = state.pieces()[p].triangles;
    triangles.insert(triangles.end(), more.begin(), more.end());
  }
  std::sort(triangles.begin(), triangles.end());
  const auto flat = flat_piece(state.mesh(), open, triangles, {.max_iterations = 0});
  return flat && !flat->pattern.overlaps;
}

/// Closes seams with a zip. If a pattern then overlaps itself, opens a run that divides the piece,
/// holds it open, and closes seams again: at most k_repairs times.
FlatState zipped(Zip zip, SeamState state, const std::vector<SeamChain>& chains, double piece_price,
                 OpenEdges held, ThreadPool& pool) {
  for (int round = 0;; ++round) {
    zip.run(state, held);
    OpenEdges open = state.open();
    bool laps = false, is_stuck = true;
    for (std::size_t p = 0; p < state.pieces().size(); ++p) {
      if (state.pieces()[p].triangles.empty() || state.is_image(p)) continue;
      const auto flat = flat_piece(state.mesh(), state.open(), state.pieces()[p].triangles);
      if (flat && !flat->pattern.overlaps) continue;
      laps = true;
      for (const Index e : dividing_run(state, chains, p, piece_price, flat)) {
        open[e] = held[e] = 1;
        if (state.mesh().is_mirrored()) open[state.mesh().image_of_edge(e)] = 1;
        is_stuck = false;
      }
    }
    if (is_stuck || round == k_repairs) return {std::move(state), !laps};
    state = SeamState(state.mesh(), std::move(open), pool);
  }
}

}  // namespace

FlatState zipped_flat(const SeamState& state, const std::vector<SeamChain>& chains, double limit,
                      const SeamPrices& prices, const std::vector<double>& favour,
                      const OpenEdges& held, ThreadPool& pool) {
  FlatState found =
      zipped(Zip(chains, limit, prices, favour), state, chains, prices.piece, held, pool);
  if (found.lies_flat) return found;
  return zipped(Zip(chains, limit, prices, favour, joins_flat), state, chains, prices.piece, held,
                pool);
}

}  // namespace planish
