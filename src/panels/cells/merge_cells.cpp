#include "panels/cells/merge_cells.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "panels/piece/piece_strain.h"

namespace planish {

namespace {

using CellPair = std::pair<Index, Index>;

/// The border of two cells.
struct SharedBorder {
  double length = 0.0, weight = 0.0;

  SharedBorder& operator+=(const SharedBorder& more) {
    length += more.length;
    weight += more.weight;
    return *this;
  }
};

struct Cell {
  PanelPiece piece;
  double perimeter = 0.0;
  std::map<Index, SharedBorder> shared;  // with each neighbour
};

class Merging {
 public:
  Merging(const PanelMesh& mesh, std::span<const Index> cells, const MergeOptions& options,
          ThreadPool& pool)
      : mesh_(mesh), closed_(mesh.edges().size(), 0), options_(options), pool_(pool) {
    cells_.resize(1 + *std::max_element(cells.begin(), cells.end()));
    for (Index t = 0; t < cells.size(); ++t)
      cells_[cells[t]].piece.triangles.push_back(t);
    for (Cell& cell : cells_) {
      if (!cell.piece.triangles.empty())
        cell.piece = measured_piece(mesh, closed_, std::move(cell.piece.triangles));
    }
    for (const PanelEdge& edge : mesh.edges()) {
      const Index a = cells[edge.triangles[0]];
      const Index b = edge.is_border() ? PanelEdge::none : cells[edge.triangles[1]];
      if (a == b) continue;
      cells_[a].perimeter += edge.length;
      if (b == PanelEdge::none) continue;
      cells_[b].perimeter += edge.length;
      const double weight = is_crease(mesh, edge) ? options.on_creases : 1.0;
      const SharedBorder border{edge.length, weight * edge.length};
      cells_[a].shared[b] += border;
      cells_[b].shared[a] += border;
    }
  }

  std::vector<Index> run() {
    while (true) {
      measure_new_pairs();
      const auto best =
          std::max_element(merits_.begin(), merits_.end(),
                           [](const auto& a, const auto& b) { return a.second < b.second; });
      if (best == merits_.end() || !(best->second > k_never)) break;
      merge(best->first);
    }
    std::vector<Index> result(mesh_.triangles().size());
    Index number = 0;
    for (const Cell& cell : cells_) {
      for (const Index t : cell.piece.triangles)
        result[t] = number;
      if (!cell.piece.triangles.empty()) ++number;
    }
    return result;
  }

 private:
  static constexpr double k_never = -std::numeric_limits<double>::infinity();

  double share_of(CellPair pair) const {
    const Cell& a = cells_[pair.first];
    const Cell& b = cells_[pair.second];
    return a.shared.at(pair.second).weight / std::min(a.perimeter, b.perimeter);
  }

  PanelPiece together(CellPair pair) const {
    const auto& a = cells_[pair.first].piece.triangles;
    const auto& b = cells_[pair.second].piece.triangles;
    std::vector<Index> triangles;
    std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(triangles));
    return measured_piece(mesh_, closed_, std::move(triangles));
  }

  double merit_of(CellPair pair) const {
    const PanelPiece& a = cells_[pair.first].piece;
    const PanelPiece& b = cells_[pair.second].piece;
    if (share_of(pair) < options_.least_share) return k_never;
    // Cutting a piece never raises the least energy: that of both is at least the sum.
    const double most = options_.limit * options_.limit * (a.area + b.area);
    if (a.energy + b.energy > most) return k_never;
    const PanelPiece both = together(pair);
    // No cell becomes a ring around others; one that is may take them in.
    const std::size_t most_loops = std::max({std::size_t{1}, a.cut_loops, b.cut_loops});
    if (both.cut_loops > most_loops || both.energy > most) return k_never;
    return share_of(pair) - 0.3 * both.energy / most;
  }

  void measure_new_pairs() {
    std::vector<CellPair> pairs;
    for (Index a = 0; a < cells_.size(); ++a) {
      for (const auto& [b, border] : cells_[a].shared) {
        if (a < b && !merits_.contains({a, b})) pairs.emplace_back(a, b);
      }
    }
    std::vector<double> merits(pairs.size());
    pool_.for_ranges(pairs.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        merits[i] = merit_of(pairs[i]);
    });
    for (std::size_t i = 0; i < pairs.size(); ++i)
      merits_[pairs[i]] = merits[i];
  }

  void merge(CellPair pair) {
    const auto [a, b] = pair;
    cells_[a].piece = together(pair);
    cells_[a].perimeter += cells_[b].perimeter - 2.0 * cells_[a].shared.at(b).length;
    cells_[a].shared.erase(b);
    for (const auto& [c, border] : cells_[b].shared) {
      cells_[c].shared.erase(b);
      if (c == a) continue;
      cells_[a].shared[c] += border;
      cells_[c].shared[a] += border;
    }
    cells_[b] = {};
    std::erase_if(merits_, [&, a = a, b = b](const auto& entry) {
      const auto& [p, q] = entry.first;
      return p == a || q == a || p == b || q == b;
    });
  }

  const PanelMesh& mesh_;
  OpenEdges closed_;
  MergeOptions options_;
  ThreadPool& pool_;
  std::vector<Cell> cells_;
  std::map<CellPair, double> merits_;
};

}  // namespace

std::vector<Index> merge_cells(const PanelMesh& mesh, std::span<const Index> cells,
                               const MergeOptions& options, ThreadPool& pool) {
  if (cells.empty()) return {};
  return Merging(mesh, cells, options, pool).run();
}

OpenEdges open_between(const PanelMesh& mesh, std::span<const Index> cells) {
  OpenEdges open;
  for (const PanelEdge& edge : mesh.edges())
    open.push_back(!edge.is_border() && cells[edge.triangles[0]] != cells[edge.triangles[1]] ? 1
                                                                                             : 0);
  return open;
}

}  // namespace planish
