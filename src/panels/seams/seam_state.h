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

/// Edges that are opened or closed together. On a mesh that is mirrored their images are too: they
/// are among the edges where both are of the same pieces, else what is done is done twice.
struct SeamRun {
  std::vector<Index> edges;
  std::vector<Index> pieces;  ///< beside them, increasing
  bool is_twice = false;
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
  /// Whether a piece is the mirror image of another one.
  bool is_image(std::size_t piece) const {
    return mesh_->is_image(pieces_[piece].triangles.front());
  }
  SeamRun run_of(std::span<const Index> edges) const;
  double cost(const SeamPrices& prices) const;
  /// Where an open run ends inside.
  std::size_t tips() const;
  /// How many more tips there are when edges are closed.
  int more_tips(std::span<const Index> edges) const;

  /// The piece that closing the run would make of those beside it.
  /// @param most_cut_loops as measured_piece() takes it
  PanelPiece closed_piece(const SeamRun& run, std::size_t most_cut_loops) const;
  /// Closes a run, where closed_piece() gave this.
  void close(const SeamRun& run, PanelPiece piece);
  /// The pieces that opening the run, of one piece, would make of it.
  std::vector<PanelPiece> opened_pieces(const SeamRun& run) const;
  /// Opens a run, where opened_pieces() gave these, which come first of the new ones.
  void open(const SeamRun& run, std::vector<PanelPiece> pieces);
  /// Whether a slit that begins at the vertex would come from the border or from an open edge.
  bool is_open_at(Index vertex) const {
    return open_at_[vertex] > 0 || mesh_->patch().is_border(vertex);
  }

 private:
  void set(std::span<const Index> edges, bool is_open);
  void replace(const SeamRun& run, std::vector<PanelPiece> pieces);
  std::vector<Index> pieces_beside(std::span<const Index> edges) const;
  PanelPiece image_of(const PanelPiece& piece) const;
  Index image_of(Index piece) const;

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
