#include <algorithm>
#include <utility>

#include <planish/evolve/remesh.h>
#include <planish/mesh/coarsen.h>
#include <planish/mesh/connectivity.h>
#include <planish/mesh/inspect.h>

#include "evolve/fixed_marks.h"

namespace planish {

namespace {

constexpr std::size_t k_enough = 5000, k_per_border_vertex = 3;

std::size_t border_vertices(const Connectivity& connectivity) {
  std::size_t count = 0;
  for (const auto& loop : connectivity.border_loops())
    count += loop.size();
  return count;
}

}  // namespace

RemeshedPatch remesh(const TriMesh& mesh, const Constraints& constraints) {
  require(inspect(mesh), Purpose::measure);
  if (!can_be_coarsened(mesh)) return {mesh, constraints};
  const Connectivity connectivity(mesh);
  const std::size_t wanted =
      std::max(k_enough, k_per_border_vertex * border_vertices(connectivity));
  if (wanted >= mesh.positions.size()) return {mesh, constraints};
  CoarsePatch coarse = coarsen(mesh, connectivity, wanted, CoarseBorder::kept,
                               fixed_marks(constraints, mesh.positions.size()));
  return {std::move(coarse.mesh), restricted_to(constraints, coarse.source)};
}

}  // namespace planish
