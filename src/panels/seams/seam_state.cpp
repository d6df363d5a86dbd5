#include "panels/seams/seam_state.h"

#include <algorithm>
#include <utility>

namespace planish {

SeamState::SeamState(const PanelMesh& mesh, OpenEdges open, ThreadPool& pool)
    : mesh_(&mesh),
      open_(std::move(open)),
      piece_of_(mesh.triangles().size()),
      open_at_(open_edges_at(mesh, open_)) {
  std::vector<std::vector<Index>> parts = open_parts(mesh, open_);
  pieces_.resize(parts.size());
  pool.for_ranges(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      pieces_[p] = measured_piece(mesh, open_, std::move(parts[p]));
  });
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    for (const Index t : pieces_[p].triangles)
      piece_of_[t] = static_cast<Index>(p);
  }
}

std::size_t SeamState::piece_count() const {
  return static_cast<std::size_t>(
      std::count_if(pieces_.begin(), pieces_.end(),
                    [](const PanelPiece& piece) { return !piece.triangles.empty(); }));
}

std::size_t SeamState::tips() const {
  return tips_of(*mesh_, open_at_);
}

double SeamState::cost(const SeamPrices& prices) const {
  return open_length(*mesh_, open_) + prices.piece * static_cast<double>(piece_count()) +
         prices.tip * static_cast<double>(tips());
}

int SeamState::more_tips(std::span<const Index> edges) const {
  std::vector<std::pair<Index, int>> fewer;
  for (const Index e : edges) {
    for (const Index v : mesh_->edges()[e].ends) {
      const auto found = std::find_if(fewer.begin(), fewer.end(),
                                      [v](const auto& entry) { return entry.first == v; });
      if (found == fewer.end())
        fewer.emplace_back(v, 1);
      else
        ++found->second;
    }
  }
  int more = 0;
  for (const auto& [v, closed] : fewer) {
    if (mesh_->patch().is_border(v)) continue;
    more += (open_at_[v] - closed == 1 ? 1 : 0) - (open_at_[v] == 1 ? 1 : 0);
  }
  return more;
}

std::vector<Index> SeamState::pieces_beside(std::span<const Index> edges) const {
  std::vector<Index> beside;
  for (const Index e : edges) {
    for (const Index t : mesh_->edges()[e].triangles)
      beside.push_back(piece_of_[t]);
  }
  std::sort(beside.begin(), beside.end());
  beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
  return beside;
}

PanelPiece SeamState::closed_piece(std::span<const Index> edges, std::size_t most_cut_loops) const {
  OpenEdges open = open_;
  for (const Index e : edges)
    open[e] = 0;
  std::vector<Index> triangles;
  for (const Index p : pieces_beside(edges))
    triangles.insert(triangles.end(), pieces_[p].triangles.begin(), pieces_[p].triangles.end());
  std::sort(triangles.begin(), triangles.end());
  return measured_piece(*mesh_, open, std::move(triangles), most_cut_loops);
}

void SeamState::close(std::span<const Index> edges, PanelPiece piece) {
  const std::vector<Index> beside = pieces_beside(edges);
  for (const Index e : edges) {
    open_[e] = 0;
    for (const Index v : mesh_->edges()[e].ends)
      --open_at_[v];
  }
  std::vector<PanelPiece> pieces;
  pieces.push_back(std::move(piece));
  replace(beside, std::move(pieces));
}

std::vector<PanelPiece> SeamState::opened_pieces(std::span<const Index> edges) const {
  OpenEdges open = open_;
  for (const Index e : edges)
    open[e] = 1;
  const PanelPiece& piece = pieces_[pieces_beside(edges).front()];
  std::vector<PanelPiece> pieces;
  for (std::vector<Index>& part : open_parts(*mesh_, open, piece.triangles))
    pieces.push_back(measured_piece(*mesh_, open, std::move(part)));
  return pieces;
}

void SeamState::open(std::span<const Index> edges, std::vector<PanelPiece> pieces) {
  const std::vector<Index> beside = pieces_beside(edges);
  for (const Index e : edges) {
    open_[e] = 1;
    for (const Index v : mesh_->edges()[e].ends)
      ++open_at_[v];
  }
  replace(beside, std::move(pieces));
}

void SeamState::replace(std::span<const Index> beside, std::vector<PanelPiece> pieces) {
  for (const Index p : beside)
    pieces_[p] = {};
  for (PanelPiece& piece : pieces) {
    for (const Index t : piece.triangles)
      piece_of_[t] = static_cast<Index>(pieces_.size());
    pieces_.push_back(std::move(piece));
  }
}

std::vector<std::vector<Index>> closed_runs(const SeamState& state,
                                            const std::vector<SeamChain>& chains,
                                            std::size_t piece) {
  std::vector<std::vector<Index>> runs;
  for (const SeamChain& chain : chains) {
    bool goes_on = false;
    for (const Index e : chain.edges) {
      const Index t = state.mesh().edges()[e].triangles[0];
      const bool is_closed = state.open()[e] == 0 && state.piece_of(t) == piece;
      if (is_closed && !goes_on) runs.emplace_back();
      if (is_closed) runs.back().push_back(e);
      goes_on = is_closed;
    }
  }
  return runs;
}

}  // namespace planish
