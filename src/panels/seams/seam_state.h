#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/thread_pool.h"
#include "panels/piece/panel_mesh.h"
#include "panels/piece/piece_strain.h"
#include "panels/seams/seam_chains.h"

namespace planish {

/// What seams cost: J = seam / sqrt(area) + piece * pieces + tip * tips.
struct SeamPrices {
  double piece = 0.25;  ///< of a piece
  double tip = 0.0;     ///< of a place where a slit ends inside a piece
};

/// A mesh that is open along some of its seams: pieces, and slits that end inside them.
class SeamState {
 public:
  /// @param mesh must outlive it
  SeamState(const PanelMesh& mesh, OpenEdges open, ThreadPool& pool);

  const PanelMesh& mesh() const { return *mesh_; }
  const OpenEdges& open() const { return open_; }
  /// Those that are there; others have no triangles.
  const std::vector<PanelPiece>& pieces() const { return pieces_; }
  std::size_t piece_count() const;
  Index piece_of(Index triangle) const { return piece_of_[triangle]; }
  double cost(const SeamPrices& prices) const;
  /// Where an open run ends inside.
  std::size_t tips() const;
  /// How many more tips there are when edges are closed.
  int more_tips(std::span<const Index> edges) const;

  /// The piece that closing the edges would make of those beside them.
  /// @param most_cut_loops as measured_piece() takes it
  PanelPiece closed_piece(std::span<const Index> edges, std::size_t most_cut_loops) const;
  /// Closes edges, where closed_piece() gave this.
  void close(std::span<const Index> edges, PanelPiece piece);
  /// The pieces that opening the edges, of one piece, would make of it.
  std::vector<PanelPiece> opened_pieces(std::span<const Index> edges) const;
  /// Opens edges, where opened_pieces() gave these.
  void open(std::span<const Index> edges, std::vector<PanelPiece> pieces);
  /// Whether a slit that begins at the vertex would come from the border or from an open edge.
  bool is_open_at(Index vertex) const {
    return open_at_[vertex] > 0 || mesh_->patch().is_border(vertex);
  }

 private:
  void replace(std::span<const Index> beside, std::vector<PanelPiece> pieces);
  std::vector<Index> pieces_beside(std::span<const Index> edges) const;

  const PanelMesh* mesh_;
  OpenEdges open_;
  std::vector<PanelPiece> pieces_;
  std::vector<Index> piece_of_;
  std::vector<int> open_at_;  // open edges at each vertex
};

/// Runs of closed edges of the chains inside a piece.
std::vector<std::vector<Index>> closed_runs(const SeamState& state,
                                            const std::vector<SeamChain>& chains,
                                            std::size_t piece);

}  // namespace planish
