#include "panels/seams/seam_state.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace planish {

SeamState::SeamState(const PanelMesh& mesh, OpenEdges open, ThreadPool& pool)
    : mesh_(&mesh),
      open_(std::move(open)),
      piece_of_(mesh.triangles().size()),
      open_at_(open_edges_at(mesh, open_)) {
  std::vector<std::vector<Index>> parts = open_parts(mesh, open_);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (const Index t : parts[p])
      piece_of_[t] = static_cast<Index>(p);
  }
  pieces_.resize(parts.size());
  const auto is_image = [&](std::size_t p) { return mesh.is_image(parts[p].front()); };
  pool.for_ranges(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      if (!is_image(p)) pieces_[p] = measured_piece(mesh, open_, parts[p]);
    }
  });
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (is_image(p))
      pieces_[p] = image_of(pieces_[piece_of_[mesh.image_of_triangle(parts[p].front())]]);
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

SeamRun SeamState::run_of(std::span<const Index> edges) const {
  SeamRun run{{edges.begin(), edges.end()}, pieces_beside(edges)};
  if (!mesh_->is_mirrored()) return run;
  std::vector<Index> images;
  for (const Index e : edges) {
    if (mesh_->image_of_edge(e) != e) images.push_back(mesh_->image_of_edge(e));
  }
  if (images.empty()) return run;
  std::vector<Index> beside = pieces_beside(images), all;
  std::set_union(run.pieces.begin(), run.pieces.end(), beside.begin(), beside.end(),
                 std::back_inserter(all));
  run.is_twice = all.size() == run.pieces.size() + beside.size();
  if (run.is_twice) return run;
  run.pieces = std::move(all);
  run.edges.insert(run.edges.end(), images.begin(), images.end());
  return run;
}

PanelPiece SeamState::closed_piece(const SeamRun& run, std::size_t most_cut_loops) const {
  OpenEdges open = open_;
  for (const Index e : run.edges)
    open[e] = 0;
  std::vector<Index> triangles;
  for (const Index p : run.pieces)
    triangles.insert(triangles.end(), pieces_[p].triangles.begin(), pieces_[p].triangles.end());
  std::sort(triangles.begin(), triangles.end());
  return measured_piece(*mesh_, open, std::move(triangles), most_cut_loops);
}

void SeamState::close(const SeamRun& run, PanelPiece piece) {
  set(run.edges, false);
  std::vector<PanelPiece> pieces;
  pieces.push_back(std::move(piece));
  replace(run, std::move(pieces));
}

std::vector<PanelPiece> SeamState::opened_pieces(const SeamRun& run) const {
  OpenEdges open = open_;
  for (const Index e : run.edges)
    open[e] = 1;
  std::vector<PanelPiece> pieces;
  for (std::vector<Index>& part : open_parts(*mesh_, open, pieces_[run.pieces.front()].triangles))
    pieces.push_back(measured_piece(*mesh_, open, std::move(part)));
  return pieces;
}

void SeamState::open(const SeamRun& run, std::vector<PanelPiece> pieces) {
  set(run.edges, true);
  replace(run, std::move(pieces));
}

void SeamState::set(std::span<const Index> edges, bool is_open) {
  for (const Index e : edges) {
    open_[e] = is_open ? 1 : 0;
    for (const Index v : mesh_->edges()[e].ends)
      open_at_[v] += is_open ? 1 : -1;
  }
}

void SeamState::replace(const SeamRun& run, std::vector<PanelPiece> pieces) {
  const auto put = [&](std::span<const Index> beside, std::vector<PanelPiece> added) {
    for (const Index p : beside)
      pieces_[p] = {};
    for (PanelPiece& piece : added) {
      for (const Index t : piece.triangles)
        piece_of_[t] = static_cast<Index>(pieces_.size());
      pieces_.push_back(std::move(piece));
    }
  };
  if (!run.is_twice) return put(run.pieces, std::move(pieces));
  std::vector<Index> edges, beside;
  std::vector<PanelPiece> images;
  edges.reserve(run.edges.size());
  beside.reserve(run.pieces.size());
  images.reserve(pieces.size());
  for (const Index e : run.edges)
    edges.push_back(mesh_->image_of_edge(e));
  for (const Index p : run.pieces)
    beside.push_back(image_of(p));
  for (const PanelPiece& piece : pieces)
    images.push_back(image_of(piece));
  set(edges, open_[run.edges.front()] != 0);
  put(run.pieces, std::move(pieces));
  put(beside, std::move(images));
}

PanelPiece SeamState::image_of(const PanelPiece& piece) const {
  PanelPiece image = piece;
  for (Index& t : image.triangles)
    t = mesh_->image_of_triangle(t);
  std::sort(image.triangles.begin(), image.triangles.end());
  return image;
}

Index SeamState::image_of(Index piece) const {
  return piece_of_[mesh_->image_of_triangle(pieces_[piece].triangles.front())];
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
