#include "panels/joined_pieces.h"

#include <cmath>
#include <utility>
#include <vector>

#include "panels/seams/flat_zip.h"
#include "panels/seams/unzip.h"

namespace planish {

namespace {

constexpr double k_to_spare = 0.9;  // of the limit, that joined pieces keep
constexpr double k_opened = 0.02;   // of the root of the area, by which runs are opened

/// The largest of the pieces beside one; itself where there is none.
Index largest_beside(const SeamState& state, Index piece) {
  const PanelMesh& mesh = state.mesh();
  Index largest = piece;
  double area = 0.0;
  for (const Index t : state.pieces()[piece].triangles) {
    for (std::size_t side = 0; side < 3; ++side) {
      const Index e = mesh.edge_of(t, side);
      if (mesh.edges()[e].is_border()) continue;
      const Index beside = state.piece_of(mesh.edges()[e].other(t));
      if (beside == piece || state.pieces()[beside].area <= area) continue;
      area = state.pieces()[beside].area;
      largest = beside;
    }
  }
  return largest;
}

/// Opens seams in the largest piece beside one over the limit, so that both together keep it.
void make_room(SeamState& state, const std::vector<SeamChain>& chains, Index piece, double limit) {
  const Index largest = largest_beside(state, piece);
  if (largest == piece) return;
  const PanelPiece &strained = state.pieces()[piece], &other = state.pieces()[largest];
  const double room = limit * limit * (strained.area + other.area) - strained.energy;
  if (room > 0.0) unzip(state, chains, largest, std::sqrt(room / other.area), k_opened);
}

}  // namespace

OpenEdges with_strained_pieces_joined(const FinishedDivision& division,
                                      const FinishOptions& options, ThreadPool& pool) {
  const PanelMesh& mesh = division.net->mesh;
  const std::vector<SeamChain>& chains = division.net->chains;
  const double limit = k_to_spare * options.rms;
  SeamState state(mesh, division.open, pool);
  std::vector<unsigned char> is_strained(mesh.triangles().size(), 0);
  for (const FlatPiece& piece : division.pieces) {
    if (!piece.has_pattern || piece.overlaps || piece.keeps(options.limits.strain)) continue;
    for (const Index t : piece.triangles)
      is_strained[t] = 1;
    make_room(state, chains, state.piece_of(piece.triangles.front()), limit);
  }
  OpenEdges held = state.open();
  for (Index e = 0; e < held.size(); ++e) {
    const auto& sides = mesh.edges()[e].triangles;
    if (held[e] != 0 && (is_strained[sides[0]] != 0 || is_strained[sides[1]] != 0)) held[e] = 0;
  }
  return zipped_flat(state, chains, limit, options.prices, {}, held, pool).state.open();
}

}  // namespace planish
