#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/thread_pool.h"
#include "panels/piece/panel_mesh.h"
#include "panels/seams/flat_zip.h"
#include "panels/seams/seam_chains.h"
#include "panels/seams/seam_state.h"

namespace planish {

/// A mesh with the seams between its cells.
struct SeamNet {
  PanelMesh mesh;
  OpenEdges seams;  ///< all of them
  std::vector<SeamChain> chains;

  /// The seams that are not open.
  OpenEdges closed(const OpenEdges& open) const;
};

/// One way to divide a product: what a move of the search changes.
struct DivisionWay {
  std::size_t cells = 70;    ///< to begin with
  double merge_limit = 0.3;  ///< up to which they are merged, of the limit
  double spread = 1.5;       ///< of cell_fields(), mean edges
  std::uint64_t seed = 0;    ///< of the factors of costs of chains; 0: all are 1
  double plane = 1.0;        ///< one more of these, for seams on the plane of a mirrored mesh
  double aim = 1.0;          ///< of the limit, where seams are to match: that takes some of it
  double beyond = 1.3;       ///< times the limit, where pieces may change
};

/// The n-th way that is tried; the first is the plain one.
DivisionWay way_of_move(std::size_t move);

/// A product divided into pieces.
struct Division {
  std::shared_ptr<const SeamNet> net;  ///< of the state's mesh
  SeamState state;
  bool lies_flat = false;  ///< no piece lies over itself
  double cost = 0.0;       ///< SeamState::cost()
};

/// Cells by normals, merged, their borders made fair lines and edges of the mesh, closed again.
/// @param mesh a product, thinned, or with a plane the half on one side of it
/// @param plane in which the pieces become mirror images of each other or of themselves
/// @throws Cancelled
Division divided(const PanelMesh& mesh, const std::optional<Plane>& plane, double limit,
                 const SeamPrices& prices, const DivisionWay& way, ThreadPool& pool);

}  // namespace planish
